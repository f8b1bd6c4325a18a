"""The statements of the deck in its own order: a printed fragment of each, and the places of its rows."""

STATEMENTS = [
    (r"Bezier曲线是一种参数多项式曲线", ["1, introduction, a curve of polynomials"]),
    (r"\vec{p}(t) = \sum_{i=0}^n \vec{a}_i f_i(t)", ["1.1, 1, the curve in relative vectors"]),
    (r"从 \vec{a}_0 的末端到 \vec{a}_n 的末端首尾相连构成的多边形", ["1.1, 1, control polygon"]),
    (
        r"f_i(t) = \sum_{j=i}^n (-1)^{i+j} C_n^j C_{j-1}^{i-1} t^j \quad i=0,1,\dots,n",
        ["1.1, 1, the functions f_i", "1.1, 1, the function f_0"],
    ),
    (r"f_0(t) = 1", ["1.1, 1, n = 3, f_0"]),
    (r"f_1(t) = 3t - 3t^2 + t^3", ["1.1, 1, n = 3, f_1"]),
    (r"f_2(t) = 3t^2 - 2t^3", ["1.1, 1, n = 3, f_2"]),
    (r"f_3(t) = t^3", ["1.1, 1, n = 3, f_3"]),
    (
        r"\vec{b}_0 = \vec{a}_0, \vec{b}_j = \vec{b}_{j-1} + \vec{a}_j \quad j=1,2,\cdots n",
        ["1.1, 2, absolute vectors b_j = b_{j-1} + a_j"],
    ),
    (r"这时，Bezier曲线的方程变为", ["1.1, 2, the equation becomes"]),
    (r"\vec{p}(t) = \sum_{j=0}^n \vec{b}_j B_{j,n}(t) \quad 0 \leq t \leq 1", ["1.1, 2, the curve"]),
    (r"B_{j,n}(t) = C_n^j t^j (1-t)^{n-j} \quad j=0,1,\cdots n", ["1.1, 2, Bernstein basis"]),
    (r"B_{0,3}(t) = (1-t)^3", ["1.1, 2, n = 3, B_0"]),
    (r"B_{1,3}(t) = 3t(1-t)^2", ["1.1, 2, n = 3, B_1"]),
    (r"B_{2,3}(t) = 3t^2(1-t)", ["1.1, 2, n = 3, B_2"]),
    (r"B_{3,3}(t) = t^3", ["1.1, 2, n = 3, B_3"]),
    (
        r"\begin{bmatrix} 1 & 0 & 0 & 0 \\ -3 & 3 & 0 & 0 \\ 3 & -6 & 3 & 0 \\ -1 & 3 & -3 & 1 \end{bmatrix}",
        ["1.1, 2, n = 3, matrix form"],
    ),
    (
        r"0 \leq B_{i,n}(u) \leq 1 \quad 0 \leq u \leq 1, i = 0, 1, \dots, n",
        ["1.2, basis property 1, not negative", "1.2, basis property 1, at most 1"],
    ),
    (r"\sum_{i=0}^n B_{i,n}(u) \equiv 1, \quad 0 \leq u \leq 1", ["1.2, basis property 2, sum"]),
    (r"1 = [u + (1-u)]^n", ["1.2, basis property 2, proof"]),
    (r"= \sum_{i=0}^n C_n^i u^i (1-u)^{n-i}", ["1.2, basis property 2, proof"]),
    (r"= \sum_{i=0}^n B_{i,n}(u)", ["1.2, basis property 2, proof"]),
    (
        r"B_{i,n}(u) = B_{n-i,n}(1-u) \quad 0 \leq u \leq 1, i = 0, 1, \dots, n",
        ["1.2, basis property 3, symmetry"],
    ),
    (
        r"B'_{i,n}(u) = n[B_{i-1,n-1}(u) - B_{i,n-1}(u)] \quad i = 1, 2, \dots, n",
        ["1.2, basis property 4, derivative"],
    ),
    (
        r"= C_n^j j t^{j-1} (1-t)^{n-j} - C_n^j (n-j) t^j (1-t)^{n-j-1}",
        ["1.2, basis property 4, proof", "1.2, basis property 4, proof, the last function"],
    ),
    (
        r"= n C_{n-1}^{j-1} t^{j-1} (1-t)^{n-j} - n C_{n-1}^j t^j (1-t)^{n-j-1}",
        ["1.2, basis property 4, proof", "1.2, basis property 4, proof, the last function"],
    ),
    (
        r"= n[\mathbf{B}_{j-1,n-1}(t) - \mathbf{B}_{j,n-1}(t)]",
        ["1.2, basis property 4, proof", "1.2, basis property 4, proof, the last function"],
    ),
    (r"当 $u = \frac{i}{n}$ 时, $B_{i,n}(u)$ 达到最大值", ["1.2, basis property 5, greatest value"]),
    (r"可以由性质4推出", ["1.2, basis property 5, from property 4"]),
    (r"B_{i,n}(u) = (1-u)B_{i,n-1}(u) + uB_{i-1,n-1}(u)", ["1.2, basis property 6, recursion"]),
    (r"B_{0,2}(u) = (1-u) B_{0,1}(u)", ["1.2, basis property 6, picture of B_{0,2}"]),
    (r"B_{1,2}(u) = (1-u) B_{1,1}(u) + u B_{0,1}(u)", ["1.2, basis property 6, picture of B_{1,2}"]),
    (r"B_{2,2}(u) = u B_{1,1}(u)", ["1.2, basis property 6, picture of B_{2,2}"]),
    (r"B_{i,n}(u) = (1-u)B_{i,n-1}(u) + uB_{i-1,n-1}(u)", ["1.2, basis property 6, recursion, printed again"]),
    (r"B_{i,n}(u) &= C_n^i u^i (1-u)^{n-i}", ["1.2, basis property 6, proof, third line"]),
    (r"&= (C_{n-1}^i + C_{n-1}^{i-1}) u^i (1-u)^{n-i}", ["1.2, basis property 6, proof, third line"]),
    (
        r"&= C_{n-1}^i u^i (1-u)^{n-i} + C_{n-1}^{i-1} u^{i-1} (1-u)^{n-i+1}",
        ["1.2, basis property 6, proof, third line"],
    ),
    (r"&= (1-u)B_{i,n-1}(u) + uB_{i-1,n-1}(u)", ["1.2, basis property 6, proof, third line"]),
    (
        r"(1-u)B_{i,n}(u) = \left(1 - \frac{i}{n+1}\right)B_{i,n+1}(u)",
        ["1.2, basis property 7, elevation, first"],
    ),
    (r"uB_{i,n}(u) = \frac{i+1}{n+1}B_{i+1,n+1}(u)", ["1.2, basis property 7, elevation, second"]),
    (
        r"B_{i,n}(u) = \left(1 - \frac{i}{n+1}\right)B_{i,n+1}(u) + \frac{i+1}{n+1}B_{i+1,n+1}(u)",
        ["1.2, basis property 7, elevation, third"],
    ),
    (r"B_{i,n}(cu) = \sum_{j=0}^n B_{i,j}(c) B_{j,n}(u)", ["1.2, basis property 8, subdivision"]),
    (r"\int_0^1 B_{i,n}(u) du = \frac{1}{n+1}", ["1.2, basis property 9, integral"]),
    (
        r"u^i = \sum_{j=i}^n \frac{C_j^i}{C_n^i} B_{j,n}(u)",
        ["1.2, basis property 10, a power in the basis"],
    ),
    (r"u = \sum_{j=1}^n \frac{j}{n} B_{j,n}(u)", ["1.2, basis property 10, t in the basis"]),
    (
        r"B_{i,n}(u) = \sum_{j=i}^n (-1)^{i+j} C_n^j C_j^i u^j",
        ["1.2, basis property 10, in powers, first form"],
    ),
    (
        r"= \sum_{j=i}^n (-1)^{i+j} C_n^i C_{n-i}^{j-i} u^j",
        ["1.2, basis property 10, in powers, second form", "1.2, basis property 10, in powers, the chain"],
    ),
    (
        r"B_{i,n}(0) = \begin{cases} 1 & i = 0 \\ 0 & 1 \leq i \leq n \end{cases}",
        ["1.2, basis property 11, at 0, i = 0", "1.2, basis property 11, at 0, i = 1, ..., n"],
    ),
    (
        r"B_{i,n}(1) = \begin{cases} 1 & i = n \\ 0 & 0 \leq i < n \end{cases}",
        ["1.2, basis property 11, at 1, i = n", "1.2, basis property 11, at 1, i = 0, ..., n - 1"],
    ),
    (r"$B_{0,n}(u)$, $B_{1,n}(u)$, ..., $B_{n,n}(u)$ 线性无关", ["1.2, basis property 12, independent"]),
    (
        r"可以作为 n 次多项式空间的一组基",
        ["1.2, basis property 12, every polynomial", "1.2, basis property 12, a basis"],
    ),
    (r"\vec{p}(0) = \vec{b}_0", ["1.2, curve property 1, start"]),
    (r"\vec{p}(1) = \vec{b}_n", ["1.2, curve property 1, end"]),
    (r"\vec{p}'(0) = n(\vec{b}_1 - \vec{b}_0)", ["1.2, curve property 2, tangent at the start"]),
    (r"\vec{p}'(1) = n(\vec{b}_n - \vec{b}_{n-1})", ["1.2, curve property 2, tangent at the end"]),
    (r"控制多边形的第一条边和最后一条边平行，且模长是其n倍", ["1.2, curve property 2, in words"]),
    (
        r"\vec{p}''(0) = n(n-1)[(\vec{b}_2 - \vec{b}_1) - (\vec{b}_1 - \vec{b}_0)]",
        ["1.2, curve property 2, second derivative at the start"],
    ),
    (
        r"\vec{p}''(1) = n(n-1)[(\vec{b}_n - \vec{b}_{n-1}) - (\vec{b}_{n-1} - \vec{b}_{n-2})]",
        ["1.2, curve property 2, second derivative at the end"],
    ),
    (
        r"\vec{p}^k(0) = \frac{n!}{(n-k)!} \sum_{i=0}^k (-1)^{k-i} C_k^i \vec{b}_i",
        ["1.2, curve property 2, k-th derivative at the start"],
    ),
    (
        r"\vec{p}^k(1) = \frac{n!}{(n-k)!} \sum_{i=0}^k (-1)^{k-i} C_k^i \vec{b}_{n-i}",
        ["1.2, curve property 2, k-th derivative at the end"],
    ),
    (r"k阶导矢只和最前面的k条边 (k+1个顶点)", ["1.2, curve property 2, first k edges, k + 1 vertices"]),
    (r"和最后面的k条边 (k+1个顶点) 有关", ["1.2, curve property 2, last k edges, k + 1 vertices"]),
    (r"3) 仿射不变性 (Affine invariance)", ["1.2, curve property 3, affine invariance"]),
    (
        r"\because 0 \leq B_{i,n}(u) \leq 1",
        ["1.2, curve property 3, reason, not negative", "1.2, curve property 3, reason, at most 1"],
    ),
    (r"\text{ 且 } \sum_{i=0}^n B_{i,n}(u) \equiv 1", ["1.2, curve property 3, reason, sum"]),
    (r"Bezier曲线上的点是控制顶点的重心组合", ["1.2, curve property 3, barycentric combination"]),
    (r"大大减少对Bezier曲线曲面进行仿射变换时的计算量", ["1.2, curve property 3, use"]),
    (
        r"\sum_{j=0}^n \vec{b}_j B_{j,n}(u) = \sum_{j=0}^n \vec{b}_{n-j} B_{j,n}(1-u)",
        ["1.2, curve property 4, symmetry"],
    ),
    (
        r"\vec{b} = \sum_{j=0}^n \alpha_j \vec{b}_j, \sum_{j=0}^n \alpha_j = 1, \alpha_j \geq 0",
        ["1.2, curve property 5, definition of the hull"],
    ),
    (r"Bezier曲线一定位于控制顶点的凸包内", ["1.2, curve property 5, hull"]),
    (r"可以预估曲线的范围", ["1.2, curve property 5, use, range of the curve"]),
    (r"排除曲线相交", ["1.2, curve property 5, use, no intersection"]),
    (r"它与平面上任一直线的交点不多于**两个**", ["1.2, curve property 6, definition of convex"]),
    (r"任一条直线 L 与线段AB的交点至多为一个", ["1.2, curve property 6, line and segment"]),
    (r"连接AB两点的曲线与直线 L 的交点则可以有任意个", ["1.2, curve property 6, line and curve from A to B"]),
    (
        r"交点个数**不会超过**它与控制多边形的交点个数",
        ["1.2, curve property 6, variation diminishing"],
    ),
    (
        r"若Bezier曲线的控制多边形是凸的，则它生成的Bezier曲线也一定是凸的",
        ["1.2, curve property 6, convexity theorem"],
    ),
    (r"凹的控制多边形也有可能生成凸的Bezier曲线", ["1.2, curve property 6, converse of the theorem"]),
    (
        r"\vec{b}_1 = [\frac{1}{4}, \frac{1}{4}], \vec{b}_2 = [\frac{1}{2}, \omega]",
        ["1.2, curve property 6, quartic, x", "1.2, curve property 6, quartic, y"],
    ),
    (r"x = t", ["1.2, curve property 6, quartic, x"]),
    (r"y = (1-x)^3 x + 6\omega(1-x^2)x^2 + (1-x)x^3", ["1.2, curve property 6, quartic, y"]),
    (
        r"y'' = 6[(2\omega - 1)(1 - x)^2 + 2(1 - 4\omega)(1 - x)x + (2\omega - 1)x^2]",
        ["1.2, curve property 6, quartic, y''"],
    ),
    (
        r"当 $0 \leq \omega \leq \frac{1}{2}$ 时，曲线为凸",
        ["1.2, curve property 6, quartic, convex for 0 <= omega <= 1/2"],
    ),
    (
        r"当 $\omega < 0$ 或 $\omega > \frac{1}{2}$ 时，曲线有两个拐点",
        ["1.2, curve property 6, quartic, two inflections"],
    ),
    (
        r"取 $0 < \omega < 1/4$ 时，控制多边形是凹的，但Bezier曲线是凸的",
        ["1.2, curve property 6, quartic, 0 < omega < 1/4"],
    ),
    (
        r"\vec{b}_j = (1 - \frac{j}{n})\vec{p} + \frac{j}{n}\vec{q} \quad j = 0, 1, \dots, n",
        ["1.2, curve property 7, linear precision"],
    ),
    (
        r"则Bezier曲线 $\sum_{j=0}^n \vec{b}_j B_{j,n}(u)$ 即为直线段",
        ["1.2, curve property 7, linear precision"],
    ),
    (
        r"\sum_{i=0}^n \vec{b}_i B_{i,n}(t) = \sum_{i=0}^n \vec{b}_i B_{i,n}\left(\frac{u-a}{b-a}\right)",
        ["1.2, curve property 8, affine change of the parameter"],
    ),
    (r"t \in [0, 1] \Rightarrow u \in [a, b]", ["1.2, curve property 8, affine change of the parameter"]),
    (
        r"移动n次Bezier曲线的第j个控制顶点，将对曲线上参数为 j/n 的点影响最大",
        ["1.2, curve property 9, influence of the j-th control point"],
    ),
    (r"Bezier曲线是一种具有优良性质的参数多项式曲线", ["1.2, summary, a curve of polynomials"]),
    (r"不具有局部修改性", ["1.2, summary, shortcoming 1, not local"]),
    (
        r"控制顶点的个数与曲线次数有关",
        ["1.2, summary, shortcoming 2, number of control points and degree"],
    ),
    (r"仍是一种多项式参数曲线，次数不能太高", ["1.2, summary, shortcoming 3, still polynomials"]),
    (
        r"\vec{b}_0^1(t) = (1-t)\vec{b}_0 + t\vec{b}_1 \quad (1)",
        ["2.1, three-tangent theorem, (1)"],
    ),
    (
        r"\vec{b}_1^1(t) = (1-t)\vec{b}_1 + t\vec{b}_2 \quad (2)",
        ["2.1, three-tangent theorem, (2)"],
    ),
    (
        r"\vec{b}_0^2(t) = (1-t)\vec{b}_0^1 + t\vec{b}_1^1 \quad (3)",
        ["2.1, three-tangent theorem, (3)"],
    ),
    (
        r"\vec{b}_0^2(t) = (1-t)^2\vec{b}_0 + 2t(1-t)\vec{b}_1 + t^2\vec{b}_2",
        ["2.1, three-tangent theorem, (1) and (2) put into (3)"],
    ),
    (r"二次Bezier 曲线", ["2.1, three-tangent theorem, (1) and (2) put into (3)"]),
    (
        r"\text{ratio}(\vec{b}_0, \vec{b}_0^1, \vec{b}_1)",
        ["2.1, three-tangent theorem, conclusion 1, first edge"],
    ),
    (
        r"= \text{ratio}(\vec{b}_1, \vec{b}_1^1, \vec{b}_2)",
        ["2.1, three-tangent theorem, conclusion 1, second edge"],
    ),
    (
        r"= \text{ratio}(\vec{b}_0^1, \vec{b}_0^2, \vec{b}_1^1)",
        ["2.1, three-tangent theorem, conclusion 1, line between"],
    ),
    (r"= \frac{t}{1-t}", ["2.1, three-tangent theorem, conclusion 1, value t/(1 - t)"]),
    (r"$\overrightarrow{b_0 b_1}$", ["2.1, three-tangent theorem, conclusion 2, first edge"]),
    (r"$\overrightarrow{b_1 b_2}$", ["2.1, three-tangent theorem, conclusion 2, second edge"]),
    (
        r"$\overrightarrow{b_0^1 b_1^1}$ 都与曲线相切",
        ["2.1, three-tangent theorem, conclusion 2, line between"],
    ),
    (
        r"二次Bezier曲线上的一点可以通过三次线性插值得到",
        ["2.1, three-tangent theorem, consequence 1, three interpolations"],
    ),
    (
        r"二次Bezier曲线可以表示成两个一次Bezier曲线 (直线) 的线性组合",
        ["2.1, three-tangent theorem, consequence 2, two linear curves"],
    ),
    (r"为 n 次 Bezier 曲线的 $n+1$ 个控制顶点", ["2.1, algorithm, n + 1 control points"]),
    (r"\begin{cases} \vec{b}_j & k = 0", ["2.1, algorithm, level 0"]),
    (
        r"(1-t)\vec{b}_j^{k-1} + t\vec{b}_{j+1}^{k-1} & k = 1, 2, \dots, n; j = 0, 1, \dots, n-k",
        ["2.1, algorithm, level k"],
    ),
    (r"$\vec{b}_0^n = \vec{p}(t)$", ["2.1, algorithm, the point of the curve"]),
    (r"每递推一级，中间控制顶点就会少一个", ["2.1, algorithm, picture, one point less with each level"]),
    (
        r"经过n级递推后，只剩最后一个点，它就是Bezier曲线上对应于参数 t 的点",
        ["2.1, algorithm, picture, the last point"],
    ),
    (
        r"$\vec{b}_0^n(t)$ 的轨迹就是 n 次 Bezier 曲线",
        ["2.1, algorithm, note 1, the path of the last point"],
    ),
    (
        r"由前 n 个控制顶点和后 n 个控制顶点确定的两条 $n-1$ 次 Bezier 曲线的线性组合",
        ["2.1, algorithm, note 2, first n and last n control points"],
    ),
    (
        r"\vec{P}\left(\frac{1}{3}\right) = \sum_{i=0}^3 \vec{P}_i B_{i,n}\left(\frac{1}{3}\right)",
        ["2.1, algorithm, worked example"],
    ),
    (r"I\vec{b}_j = \vec{b}_j", ["2.1, operator form, identity"]),
    (r"E\vec{b}_j = \vec{b}_{j+1}", ["2.1, operator form, shift"]),
    (r"E^k\vec{b}_j = \vec{b}_{j+k}", ["2.1, operator form, k shifts"]),
    (r"E^{-1}\vec{b}_j = \vec{b}_{j-1}", ["2.1, operator form, shift back"]),
    (
        r"\vec{b}_0^n(t) &= (1-t)\vec{b}_0^{n-1}(t) + t\vec{b}_1^{n-1}(t)",
        ["2.1, operator form, first step"],
    ),
    (r"&= [(1-t)I + tE]\vec{b}_0^{n-1}(t)", ["2.1, operator form, first step"]),
    (
        r"\vec{b}_0^{n-1}(t) &= (1-t)\vec{b}_0^{n-2}(t) + t\vec{b}_1^{n-2}(t)",
        ["2.1, operator form, second step"],
    ),
    (r"&= [(1-t)I + tE]\vec{b}_0^{n-2}(t)", ["2.1, operator form, second step"]),
    (r"\vec{b}_0^n(t) = [(1-t)I + tE]^2 \vec{b}_0^{n-2}(t)", ["2.1, operator form, two steps"]),
    (
        r"&= \dots = [(1-t)I + tE]^{n-1} \vec{b}_0^1(t) \\ &= [(1-t)I + tE]^n \vec{b}_0(t)",
        ["2.1, operator form, n steps"],
    ),
    (r"\vec{b}_j^k &= [(1-t)I + tE]^k \vec{b}_j", ["2.1, operator form, intermediate points"]),
    (r"&= \sum_{i=0}^k C_k^i (1-t)^{k-i} t^i E^i \vec{b}_j", ["2.1, operator form, intermediate points"]),
    (r"&= \sum_{i=0}^k B_{i,k}(t) \vec{b}_{j+i}", ["2.1, operator form, intermediate points"]),
    (
        r"第 k 层中间控制顶点的轨迹就是一条 k 次 Bezier 曲线",
        ["2.1, operator form, path of the intermediate points"],
    ),
    (
        r"B'_{i,n}(u) = n[B_{i-1,n-1}(u) - B_{i,n-1}(u)] \quad i = 1, 2, \dots, n",
        ["2.2, hodograph, derivative of the basis"],
    ),
    (
        r"\frac{d}{dt} \vec{p}(t) = n \sum_{j=0}^n [B_{j-1,n-1}(t) - B_{j,n-1}(t)] \vec{b}_j",
        ["2.2, hodograph, derivative of the curve"],
    ),
    (
        r"B_{j,n}(t) = 0, \quad \text{for } j \notin \{0, 1, \dots, n\}",
        [
            "2.2, hodograph, functions with a negative index",
            "2.2, hodograph, functions with an index above the degree",
        ],
    ),
    (
        r"&= n \sum_{j=1}^n B_{j-1,n-1}(t) \vec{b}_j - n \sum_{j=0}^{n-1} B_{j,n-1}(t) \vec{b}_j",
        ["2.2, hodograph, simplified"],
    ),
    (
        r"&= n \sum_{j=0}^{n-1} B_{j,n-1}(t) \vec{b}_{j+1} - n \sum_{j=0}^{n-1} B_{j,n-1}(t) \vec{b}_j",
        ["2.2, hodograph, simplified"],
    ),
    (
        r"&= n \sum_{j=0}^{n-1} (\vec{b}_{j+1} - \vec{b}_j) B_{j,n-1}(t)",
        ["2.2, hodograph, simplified"],
    ),
    (r"&= n \sum_{j=0}^{n-1} \Delta \vec{b}_j B_{j,n-1}(t)", ["2.2, hodograph, simplified"]),
    (r"$\Delta \vec{b}_j, j = 0, 1, \dots, n-1$ 为相对矢量", ["2.2, hodograph, relative vectors"]),
    (r"则可以构成 $n-1$ 个绝对矢量", ["2.2, hodograph, number of absolute vectors"]),
    (
        r"以这 $n-1$ 个绝对矢量作为控制顶点，则可以生成一个 $n-1$ 次Bezier曲线",
        ["2.2, hodograph, number of its control points"],
    ),
    (r"称其为**一阶速端曲线**", ["2.2, hodograph, first hodograph"]),
    (r"还可以类似地定义高阶速端曲线", ["2.2, hodograph, those of higher order"]),
    (r"\vec{p}(t) = [(1-t)I + tE]^n \vec{b}_0", ["2.2, higher derivatives, operator form"]),
    (
        r"\frac{d}{dt} \vec{p}(t) &= n[(1-t)I + tE]^{n-1} (E\vec{b}_0 - \vec{b}_0)",
        ["2.2, higher derivatives, first"],
    ),
    (r"&= n[(1-t)I + tE]^{n-1} (\vec{b}_1 - \vec{b}_0)", ["2.2, higher derivatives, first"]),
    (r"&= n[(1-t)I + tE]^{n-1} \Delta \vec{b}_0", ["2.2, higher derivatives, first"]),
    (
        r"&= n(n-1)[(1-t)I + tE]^{n-2} (E\Delta\vec{b}_0 - \Delta\vec{b}_0)",
        ["2.2, higher derivatives, second"],
    ),
    (
        r"&= n(n-1)[(1-t)I + tE]^{n-2} (\Delta\vec{b}_1 - \Delta\vec{b}_0)",
        ["2.2, higher derivatives, second"],
    ),
    (r"&= n(n-1)[(1-t)I + tE]^{n-2} \Delta^2\vec{b}_0", ["2.2, higher derivatives, second"]),
    (
        r"&= n(n-1)\cdots(n-r+1)[(1-t)I + tE]^{n-r} \Delta^r\vec{b}_0",
        ["2.2, higher derivatives, factor of order r", "2.2, higher derivatives, order r"],
    ),
    (
        r"&= \frac{n!}{(n-r)!} \sum_{j=0}^{n-r} \Delta^r\vec{b}_j B_{j,n-r}(t)",
        ["2.2, higher derivatives, factor of order r", "2.2, higher derivatives, order r"],
    ),
    (
        r"\frac{d^r}{dt^r} \vec{p}(0) = \frac{n!}{(n-r)!} \Delta^r \vec{b}_0",
        ["2.2, at the ends, order r at 0"],
    ),
    (
        r"\frac{d^r}{dt^r} \vec{p}(1) = \frac{n!}{(n-r)!} \Delta^r \vec{b}_{n-r}",
        ["2.2, at the ends, order r at 1"],
    ),
    (
        r"在端点处的 r 阶导矢仅与最近的 $r + 1$ 个控制顶点（控制多边形的 r 条边）有关",
        [
            "2.2, at the ends, r + 1 control points, at 0",
            "2.2, at the ends, r edges, at 0",
            "2.2, at the ends, r + 1 control points, at 1",
            "2.2, at the ends, r edges, at 1",
        ],
    ),
    (
        r"\vec{p}'(0) = n\Delta\vec{b}_0 = n(\vec{b}_1 - \vec{b}_0)",
        ["2.2, at the ends, tangent at 0"],
    ),
    (
        r"\vec{p}'(1) = n\Delta\vec{b}_{n-1} = n(\vec{b}_n - \vec{b}_{n-1})",
        ["2.2, at the ends, tangent at 1"],
    ),
    (
        r"\vec{p}''(0) = n(n-1)\Delta^2\vec{b}_0",
        ["2.2, at the ends, second derivative at 0"],
    ),
    (
        r"\vec{p}''(1) = n(n-1)\Delta^2\vec{b}_{n-2}",
        ["2.2, at the ends, second derivative at 1"],
    ),
    (
        r"k(0) = \frac{|\vec{p}'(0) \times \vec{p}''(0)|}{|\vec{p}'(0)|^3}"
        r" = \frac{n^2(n-1)|\Delta\vec{b}_0 \times \Delta\vec{b}_1|}{n^3|\Delta\vec{b}_0|^3}",
        [
            "2.2, at the ends, curvature at 0, cross product",
            "2.2, at the ends, curvature at 0, first equality",
        ],
    ),
    (
        r"= \frac{(n-1)}{n} \cdot \frac{|\Delta\vec{b}_0 \times \Delta\vec{b}_1|}{|\Delta\vec{b}_0|^3}",
        ["2.2, at the ends, curvature at 0, second equality"],
    ),
    (
        r"k(1) = \frac{|\vec{p}'(1) \times \vec{p}''(1)|}{|\vec{p}'(1)|^3}"
        r" = \frac{n^2(n-1)|\Delta\vec{b}_{n-2} \times \Delta\vec{b}_{n-1}|}{n^3|\Delta\vec{b}_{n-1}|^3}",
        [
            "2.2, at the ends, curvature at 1, cross product",
            "2.2, at the ends, curvature at 1, first equality",
        ],
    ),
    (
        r"= \frac{(n-1)}{n} \cdot \frac{|\Delta\vec{b}_{n-2} \times \Delta\vec{b}_{n-1}|}{|\Delta\vec{b}_{n-1}|^3}",
        ["2.2, at the ends, curvature at 1, second equality"],
    ),
    (
        r"由 $\frac{d^r}{dt^r} \vec{p}(t) = \frac{n!}{(n-r)!} \sum_{j=0}^{n-r} \Delta^r \vec{b}_j B_{j,n-r}(t)$ 可得",
        ["2.2, inside, order r again"],
    ),
    (
        r"&= \frac{n!}{(n-r)!} \Delta^r \sum_{j=0}^{n-r} \vec{b}_j B_{j,n-r}(t)",
        ["2.2, inside, from intermediate points"],
    ),
    (
        r"&= \frac{n!}{(n-r)!} \Delta^r [(1-t)I + tE]^{n-r} \vec{b}_0",
        ["2.2, inside, from intermediate points"],
    ),
    (r"&= \frac{n!}{(n-r)!} \Delta^r \vec{b}_0^{n-r}", ["2.2, inside, from intermediate points"]),
    (r"表示成deCasteljau算法中间控制顶点的 r 阶差分，再乘以倍数", ["2.2, inside, in words"]),
    (
        r"\Delta^r \vec{b}_0^{n-r} = \sum_{i=0}^r (-1)^{r-i} C_r^i \vec{b}_i^{n-r}",
        ["2.2, inside, difference of order r"],
    ),
    (
        r"\vec{b}_0^{n-r}, \vec{b}_1^{n-r}, \dots, \vec{b}_r^{n-r}",
        ["2.2, inside, number of points"],
    ),
    (
        r"三角阵列的第 $n-r$ 列的 r 个中间控制顶点",
        ["2.2, inside, number of points", "2.2, inside, column"],
    ),
    (r"“副产品”计算出结果", ["2.2, inside, by-product of the algorithm"]),
    (
        r"&= n(n-1)(n-2)(\vec{b}_3^{n-3} - 3\vec{b}_2^{n-3} + 3\vec{b}_1^{n-3} + \vec{b}_0^{n-3})",
        ["2.2, inside, third derivative"],
    ),
    (
        r"&= 6(\vec{b}_3^0 - 3\vec{b}_2^0 + 3\vec{b}_1^0 + \vec{b}_0^0)",
        ["2.2, inside, third derivative, n = 3"],
    ),
    (
        r"&= n(n-1)(\vec{b}_2^{n-2} - 2\vec{b}_1^{n-2} + \vec{b}_0^{n-2})",
        ["2.2, inside, second derivative"],
    ),
    (
        r"&= 6(\vec{b}_2^1 - 2\vec{b}_1^1 + \vec{b}_0^1)",
        ["2.2, inside, second derivative, n = 3"],
    ),
    (
        r"\vec{p}'(t) = n(\vec{b}_1^{n-1} - \vec{b}_0^{n-1})",
        ["2.2, inside, first derivative"],
    ),
    (r"= 3(\vec{b}_1^2 - \vec{b}_0^2)", ["2.2, inside, first derivative, n = 3"]),
    (
        r"b_0^0 b_1^0 b_2^0 b_3^0 b_0^1 b_1^1 b_2^1 b_0^2 b_1^2 b_0^3",
        ["2.2, inside, triangle of a cubic"],
    ),
    (r"因为Bezier曲线不具有局部修改性", ["2.3, why to split, no local change"]),
    (
        r"分别记作 $\vec{p}_1(u)$ 和 $\vec{p}_2(u)$, 其中 $0 < u < 1$",
        ["2.3, split theorem, control points of the front"],
    ),
    (
        r"\vec{b}_0^0(t^*), \vec{b}_0^1(t^*), \dots, \vec{b}_0^n(t^*)",
        ["2.3, split theorem, control points of the front"],
    ),
    (
        r"\vec{b}_0^n(t^*), \vec{b}_1^{n-1}(t^*), \dots, \vec{b}_n^0(t^*)",
        ["2.3, split theorem, control points of the back"],
    ),
    (
        r"得到的三角阵列中的每列第一个元素和最后一个元素(逆序)",
        [
            "2.3, split theorem, first points of the columns",
            "2.3, split theorem, last points of the columns, in reverse",
        ],
    ),
    (r"\vec{p}_1(u) = \vec{p}(t^*u)", ["2.3, split theorem, proof, p_1(u) = p(t* u)"]),
    (
        r"\vec{p}_2(u) = \vec{p}[1 - (1 - t^*)(1 - u)]",
        ["2.3, split theorem, proof, p_2(u) = p[1 - (1 - t*)(1 - u)]"],
    ),
    (r"其中: } 0 < u < 1", ["2.3, split theorem, proof, p_2(u) = p[1 - (1 - t*)(1 - u)]"]),
    (r"\vec{p}_1(0) = \vec{p}(0)", ["2.3, split theorem, proof, p_1(0)"]),
    (r"\vec{p}_1(1) = \vec{p}(t^*)", ["2.3, split theorem, proof, p_1(1)"]),
    (r"\vec{p}_2(0) = \vec{p}(t^*)", ["2.3, split theorem, proof, p_2(0)"]),
    (r"\vec{p}_2(1) = \vec{p}(1)", ["2.3, split theorem, proof, p_2(1)"]),
    (
        r"\vec{p}_1(u) &= \sum_{j=0}^n \vec{b}_0^j (t^*) B_{j,n}(u)",
        ["2.3, split theorem, proof, the front"],
    ),
    (
        r"&= \sum_{j=0}^n B_{j,n}(u) [(1-t^*)I + t^*E]^j \vec{b}_0",
        ["2.3, split theorem, proof, the front"],
    ),
    (
        r"&= \sum_{j=0}^n C_n^j (1-u)^{n-j} [u(1-t^*)I + ut^*E]^j \vec{b}_0",
        ["2.3, split theorem, proof, the front"],
    ),
    (r"&= [(1-u)I + u(1-t^*)I + ut^*E]^n \vec{b}_0", ["2.3, split theorem, proof, the front"]),
    (
        r"&= [(1-t^*u)I + (t^*u)E]^n \vec{b}_0 = \vec{b}^n(t^*u)",
        ["2.3, split theorem, proof, the front"],
    ),
    (r"说明 $p_1(u)$ 确实是原Bezier曲线的前半段", ["2.3, split theorem, proof, the front"]),
    (
        r"\vec{p}_2(u) &= \sum_{j=0}^n \vec{b}_j^{n-j}(t^*) B_{j,n}(u)",
        ["2.3, split theorem, proof, the back"],
    ),
    (
        r"&= \sum_{j=0}^n B_{j,n}(u) [(1-t^*)I + t^*E]^{n-j} \vec{b}_j",
        ["2.3, split theorem, proof, the back"],
    ),
    (
        r"&= \sum_{j=0}^n C_n^j (1-u)^{n-j} u^j [(1-t^*)I + t^*E]^{n-j} E^j \vec{b}_0",
        ["2.3, split theorem, proof, the back"],
    ),
    (
        r"&= [(1-(u+t^*-t^*u))I + (u+t^*-t^*u)E]^n \vec{b}_0",
        ["2.3, split theorem, proof, the back"],
    ),
    (r"&= \vec{b}^n [1-(1-t^*)(1-u)]", ["2.3, split theorem, proof, the back"]),
    (r"说明 $p_2(u)$ 确实是原Bezier曲线的后半段", ["2.3, split theorem, proof, the back"]),
    (
        r"\vec{p}\left(\frac{1}{3}\right) = \sum_{i=0}^3 \vec{P}_i B_{i,3}\left(\frac{1}{3}\right)",
        ["2.3, split, worked example, point at 1/3"],
    ),
    (r"$P_0 \rightarrow (0,0)^T$", ["2.3, split, worked example, triangle"]),
    (r"$P_1 \rightarrow (1,3)^T$", ["2.3, split, worked example, triangle"]),
    (r"$P_2 \rightarrow (2,1)^T$", ["2.3, split, worked example, triangle"]),
    (r"$P_3 \rightarrow (3,3)^T$", ["2.3, split, worked example, triangle"]),
    (r"\xrightarrow{2/3}", ["2.3, split, worked example, triangle"]),
    (r"\xrightarrow{1/3}", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (1/3,1)^T$", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (4/3,7/3)^T$", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (7/3,5/3)^T$", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (2/3,13/9)^T$", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (5/3,19/9)^T$", ["2.3, split, worked example, triangle"]),
    (r"$\rightarrow (1, 5/3)^T$", ["2.3, split, worked example, triangle"]),
    (
        r"[0,0], [\frac{1}{3}, 1], [\frac{2}{3}, \frac{13}{9}], [1, \frac{5}{3}]",
        ["2.3, split, worked example, front"],
    ),
    (
        r"[1, \frac{5}{3}], [\frac{5}{3}, \frac{19}{9}], [\frac{7}{3}, \frac{5}{3}], [3, 3]",
        ["2.3, split, worked example, back"],
    ),
    (
        r"求界于 $\vec{p}(t_1)$ 和 $\vec{p}(t_2)$ 两点之间的子曲线段的控制顶点",
        ["2.3, any part, its control points"],
    ),
    (
        r"$\vec{p}(t), t \in [0, t_2]$ 的控制顶点依次为",
        ["2.3, any part, scheme 1, first cut"],
    ),
    (
        r"\vec{b}_0^0(t_2), \vec{b}_0^1(t_2), \dots, \vec{b}_0^n(t_2)",
        ["2.3, any part, scheme 1, first cut"],
    ),
    (r"作为一条新的完整Bezier曲线 $\vec{p}(u)$", ["2.3, any part, scheme 1, step 1, u = t/t_2"]),
    (r"$u = t/t_2$, 则 $0 \leq u \leq 1$", ["2.3, any part, scheme 1, step 1, u = t/t_2"]),
    (r"令 $u^* = t_1 / t_2$", ["2.3, any part, scheme 1, step 2, u* = t_1/t_2"]),
    (
        r"取 $[t_1 / t_2, 1]$ 段的控制顶点即为原曲线 $\vec{p}(t)$ 界于 $[t_1, t_2]$ 段的控制顶点",
        ["2.3, any part, scheme 1, step 2, the part"],
    ),
    (r"方案2：原理与方案1完全相同", ["2.3, any part, scheme 2, first cut"]),
    (r"第一步：以 $p(t_1)$ 为界分割，取后半段", ["2.3, any part, scheme 2, first cut"]),
    (
        r"第二步：以局部参数 t_1/t_2 为界分割，取前半段",
        ["2.3, any part, scheme 2, local parameter t_1/t_2", "2.3, any part, scheme 2, the part"],
    ),
    (
        r"\vec{b}_0 = [-9, 0], \vec{b}_1 = [-3, 6], \vec{b}_2 = [3, 6], \vec{b}_3 = [9, 0]",
        ["2.3, any part, worked example, triangle at 3/4"],
    ),
    (r"$$[-3, 6]$$ $$[-\frac{9}{2}, \frac{9}{2}]$$", ["2.3, any part, worked example, triangle at 3/4"]),
    (
        r"$$[3, 6]$$ $$[\frac{3}{2}, 6]$$ $$[0, \frac{45}{8}]$$",
        ["2.3, any part, worked example, triangle at 3/4"],
    ),
    (
        r"$$[9, 0]$$ $$[\frac{15}{2}, \frac{3}{2}]$$ $$[6, \frac{21}{8}]$$ $$[\frac{9}{2}, \frac{27}{8}]$$",
        ["2.3, any part, worked example, triangle at 3/4"],
    ),
    (
        r"[-9, 0], \quad \left[-\frac{9}{2}, \frac{9}{2} \right], \quad [0, \frac{45}{8}],"
        r" \quad [\frac{9}{2}, \frac{27}{8}]",
        ["2.3, any part, worked example, front"],
    ),
    (
        r"$u = \frac{1}{4} / \frac{3}{4} = \frac{1}{3}$",
        ["2.3, any part, worked example, u = 1/3"],
    ),
    (
        r"$[-\frac{9}{2}, \frac{9}{2}] \quad [-\frac{15}{2}, \frac{3}{2}]$",
        ["2.3, any part, worked example, triangle at 1/3"],
    ),
    (
        r"$[0, \frac{45}{8}] \quad [-3, \frac{39}{8}] \quad [-6, \frac{21}{8}]$",
        ["2.3, any part, worked example, triangle at 1/3"],
    ),
    (
        r"$$[\frac{9}{2}, \frac{27}{8}]$$ $$[\frac{3}{2}, \frac{39}{8}]$$ $$[-\frac{3}{2}, \frac{39}{8}]$$"
        r" $$[-\frac{9}{2}, \frac{27}{8}]$$",
        ["2.3, any part, worked example, triangle at 1/3"],
    ),
    (
        r"[-\frac{9}{2}, \frac{27}{8}], [-\frac{3}{2}, \frac{39}{8}], [\frac{3}{2}, \frac{39}{8}],"
        r" [\frac{9}{2}, \frac{27}{8}]",
        ["2.3, any part, worked example, the part"],
    ),
    (
        r"次Bezier曲线经过 k 次分割后, 曲线被分为 2^k 段 n 次Bezier曲线",
        ["2.3, limit theorem, number of pieces"],
    ),
    (r"它们共有 $2^k(n+1)$ 个控制顶点", ["2.3, limit theorem, number of control points"]),
    (r"\lim_{k \rightarrow +\infty} B^k\{\vec{p}_n\} = \vec{p}(t)", ["2.3, limit theorem, the limit"]),
]
