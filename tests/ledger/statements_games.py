"""The statements of the games slides in their order, and the rows that read them."""


def parabola(number):
    return ("二次多项式曲线(抛物线)", [f"power basis, slide {number}, quadratic curve (parabola)"])


def cut(number):
    where = f"de Casteljau, slide {number} of 4 with the cut"
    return [
        ("Bisect control polygon in ratio t:(1-t)", [f"{where}, ratio"]),
        ("该点将曲线一分两条子Bezier曲线", [f"{where}, first part", f"{where}, second part"]),
        ("其控制顶点是中间生成的点", [f"{where}, their control points"]),
        ("可用于Bezier曲线的离散及求根", [f"{where}, use, polygons for the curve", f"{where}, use, roots"]),
    ]


def ends(where):
    return [
        (r"f(0) = \mathbf{p}_0", [f"{where}, f(0)"]),
        (r"f(1) = \mathbf{p}_n", [f"{where}, f(1)"]),
        ("端点的切线方向与边相同", [f"{where}, tangents along the edges"]),
        ("f'(0) = n[p_1 - p_0]", [f"{where}, f'(0)"]),
        ("f'(1) = n[p_{n-1} - p_n]", [f"{where}, f'(1)"]),
        (
            "端点的2阶(k)切线与3点(k+1)相关",
            [
                f"{where}, k-th derivative from k + 1 points, start",
                f"{where}, k-th derivative from k + 1 points, end",
            ],
        ),
        (r"f''(0) = n(n-1)[\mathbf{p}_2 - 2\mathbf{p}_1 + \mathbf{p}_0]", [f"{where}, f''(0)"]),
        (r"f''(1) = n(n-1)[\mathbf{p}_n - 2\mathbf{p}_{n-1} + \mathbf{p}_{n-2}]", [f"{where}, f''(1)"]),
    ]


STATEMENTS = [
    (r"比如幂基  $\{1, x, x^2, ..., x^n\}$", ["review, the powers as a basis"]),
    ("(n = 2) 二次多项式:  $f(t) = at^2 + bt + c$", ["review, quadratic polynomial in powers of t"]),
    (r"参数曲线形式:  $f(t) = \begin{pmatrix} x(t) \\ y(t) \end{pmatrix}$", ["review, parametric form"]),
    parabola(1),
    (
        r"f(t) = \begin{pmatrix} x(t) \\ y(t) \end{pmatrix} = \begin{pmatrix} 1 \\ 1 \end{pmatrix} t^2",
        ["power basis, slide 1, the example"],
    ),
    ("基函数为这些顶点的组合权系数", ["power basis, slide 1, coefficients as points"]),
    parabola(2),
    ("系数顶点与曲线本身无直观的联系: 无几何意义!", ["power basis, slide 2, no geometric meaning"]),
    (r"$\{a,b,c\}$ 作为基函数的组合权系数", ["two kinds of modelling, powers as weights of points"]),
    (r"基函数 $\{t^2, t, 1\}$ 作为控制点的组合权系数", ["two kinds of modelling, powers as weights of points"]),
    (
        r"\mathbf{f}(t) = \begin{pmatrix} 1 \\ 1 \end{pmatrix} t^2 + \begin{pmatrix} -2 \\ 0 \end{pmatrix} t",
        ["Bernstein instead of powers, the example in powers again"],
    ),
    (
        r"(1-t)^2 + \begin{pmatrix} 0 \\ 0 \end{pmatrix} 2t(1-t) + \begin{pmatrix} 0 \\ 1 \end{pmatrix} t^2",
        ["Bernstein instead of powers, the example in the Bernstein basis"],
    ),
    (r"$$B_i^{(n)}(t) = \binom{n}{i} t^i (1-t)^{n-i} = B_{i-\text{th", ["Bernstein basis, definition"]),
    (
        r"\frac{n!}{(n-i)! \, i!} & \text{for } 0 \le i \le n",
        ["Bernstein basis, binomial coefficient"],
    ),
    (
        r"0 & \text{otherwise}",
        ["Bernstein basis, binomial coefficient 0 below", "Bernstein basis, binomial coefficient 0 above"],
    ),
    (r"$$B_i^{(n)}(t) = \binom{n}{i} t^i (1-t)^{n-i}$$", ["the first few, definition again"]),
    (r"B_0^{(1)} \coloneqq 1 - t", ["the first few, B_0 of degree 1"]),
    (r"B_0^{(0)} \coloneqq 1", ["the first few, B_0 of degree 0"]),
    (r"B_1^{(1)} \coloneqq t", ["the first few, B_1 of degree 1"]),
    (r"B_0^{(2)} \coloneqq (1-t)^2", ["the first few, B_0 of degree 2"]),
    (r"B_1^{(2)} \coloneqq 2t(1-t)", ["the first few, B_1 of degree 2"]),
    (r"B_2^{(2)} \coloneqq t^2", ["the first few, B_2 of degree 2"]),
    (r"\boldsymbol{b}_0 = \begin{pmatrix} 0 \\ 1 \end{pmatrix}", ["another example, three points"]),
    ("n次Bezier曲线: n+1个控制顶点", ["Bézier curve, degree n with n + 1 points"]),
    (r"x(t) = \sum_{i=0}^{n} B_i^n(t) \cdot b_i", ["Bézier curve, definition"]),
    ("Bezier曲线的性质来源于Bernstein基函数的性质", ["Bézier curve, its properties from those of the basis"]),
    ("曲线是控制顶点的线性组合构成的", ["Bézier curve, its properties from those of the basis"]),
    (r"\boldsymbol{f}(t) = \sum_{i=1}^{3} B_i^3 \boldsymbol{p}_i", ["cubic example, sum from 1"]),
    (r"f(t) = \sum_{i=1}^{n} B_i^n p_i", ["curves in space, sum from 1"]),
    ("n次 (n+1阶) Bernstein基函数", ["properties, degree n is order n + 1"]),
    (r"基函数:  $B_i^{(n)}(t) = \binom{n}{i} t^i (1-t)^{n-i}", ["properties, definition again"]),
    ("B_i^n(t) = B_{n-i}^n(1-t)", ["properties, symmetry"]),
    (r"在 $t = \frac{i}{n}$ 达到最大值", ["properties, greatest value"]),
    (r"$B_i^{(n)}(t) \ge 0$ ,  $\forall t \in [0,1]$", ["property 1, not negative"]),
    (r"\sum_{i=1}^{n} B_i^{(n)}(t) = 1, \forall t \in [0,1]", ["property 1, sum from 1"]),
    ("Bezier曲线的凸包性", ["property 1, convex hull"]),
    (
        "是次数不高于n的多项式集合(空间)的一组基",
        ["property 2, a basis", "property 2, independent", "property 2, every polynomial of degree at most n"],
    ),
    ("与幂基可以相互线性表达", ["property 2, from powers", "property 2, to powers"]),
    (r"B_{0,n}(t) & B_{1,n}(t) & \cdots & B_{n,n}(t)", ["property 2, the matrix"]),
    ("B_i^n(t) = (1-t)B_i^{(n-1)}(t) + tB_{i-1}^{(n-1)}(1-t)", ["property 3, recursion"]),
    ("with  $B_0^0(t) = 1$", ["property 3, B_0 of degree 0"]),
    (
        r"$B_i^n(t) = 0$  for  $i \notin \{0 \dots n\}$",
        ["property 3, index below 0", "property 3, index above n"],
    ),
    (r"\binom{n-1}{i} + \binom{n-1}{i-1} = \binom{n}{i}", ["property 3, binomial coefficients"]),
    ('高阶的基函数由2个低阶的基函数"升阶"得到', ["property 3, from two of lower degree"]),
    ("B_0^n(0) = 1", ["property 4, B_0 at 0"]),
    (r"B_1^n(0) = \dots = B_n^n(0) = 0", ["property 4, the others at 0"]),
    (r"B_0^n(1) = \cdots = B_{n-1}^n(1) = 0", ["property 4, the others at 1"]),
    ("B_n^n(0) = 1", ["property 4, B_n at 1"]),
    ("Bezier曲线经过首末两个控制顶点 $p_0, p_n$", ["property 4, first point", "property 4, last point"]),
    (
        r"\frac{d}{dt}B_i^{(n)}(t) = n\left[B_{i-1}^{(n-1)}(t) B_i^{(n-1)}(t)\right]",
        ["property 5, derivative of the basis"],
    ),
    (
        r"n(n-1)\left[B_{i-2}^{(n-2)}(t) 2B_{i-1}^{(n-2)}(t) + B_i^{(n-2)}(t)\right]",
        ["property 5, second derivative of the basis"],
    ),
    (r"f(t) = \sum_{i=0}^n B_i^n(t) p_i", ["property 5, the curve"]),
    (r"f'(t) = n \sum_{i=0}^{n-1} B_i^{n-1}(t) (p_{i+1} p_i)", ["property 5, derivative of the curve"]),
    (
        r"f^{[r]}(t) = \frac{n!}{(n-r)!} \cdot \sum_{i=0}^{n-r} B_i^{n-r}(t) \cdot \Delta^r p_i",
        ["property 5, r-th derivative of the curve"],
    ),
    *ends("ends of the curve"),
    (r"(1-t)B_i^n(t) = (1 - \frac{i}{n+1})B_i^{n+1}(t)", ["property 6, times 1 - t"]),
    (r"tB_i^n(t) = \frac{i+1}{n+1}B_i^{n+1}(t)", ["property 6, times t"]),
    (
        r"\left[ \frac{n+1-i}{n+1} \mathbf{P}_i + \frac{i}{n+1} \mathbf{P}_{i-1} \right]",
        ["property 6, the curve"],
    ),
    (r"\mathbf{b}_{i}^{0}(t) = \mathbf{b}_{i}, \qquad i = 0, ..., n", ["de Casteljau, level 0"]),
    (
        r"\mathbf{b}_{i}^{r}(t) = (1 - t)\mathbf{b}_{i}^{r-1}(t) + t \mathbf{b}_{i+1}^{r-1}(t)",
        ["de Casteljau, a step"],
    ),
    (r"r = 1, ..., n \qquad i = 0, ..., n - r", ["de Casteljau, a step"]),
    ("is the searched curve point", ["de Casteljau, the point of the curve"]),
    ("Repeated convex combination of control points", ["de Casteljau, convex combination"]),
    (
        r"\boldsymbol{b}_i^{(r)} = (1-t)\boldsymbol{b}_i^{(r-1)} + t\boldsymbol{b}_{i+1}^{(r-1)}",
        ["de Casteljau, convex combination, the step again"],
    ),
    *(statement for number in (1, 2, 3, 4) for statement in cut(number)),
    (
        "每两点间生成一段Bezier曲线,使得整体曲线满足一定的连续性( $C^0$ ,  $C^1$ ,  $C^2$ )",
        [
            "splines, a piece between each two data points, C0 and C1",
            "splines, a piece between each two data points, C2",
        ],
    ),
    *ends("joins, ends of the curve again"),
    ("$C^0$ 连续", ["joins, C0"]),
    ("G<sup>1</sup>连续:三点共线", ["joins, G1"]),
    ("$C^1$ 连续: 三点共线 且等长", ["joins, C1"]),
    (r"d^2/dt^2 \supset (p_2 2p_1 + p_0)", ["joins, C2, second derivative at the start"]),
    ("(p_n 2p_{n-1} + p_{n-2})", ["joins, C2, second derivative at the end"]),
    ("阴影三角形相似", ["joins, C2, similar triangles"]),
    ("*G*<sup>2</sup> 连续?", ["joins, what of G2"]),
    ("构造3次插值Bezier曲线的几何方法", ["construction of interpolating cubics, picture lost"]),
    (
        "分段的多项式曲线(Bezier曲线)",
        ["splines in general, pieces of polynomials are Bézier curves"],
    ),
]
