"""The key terms of the course in English and Chinese, in the order in which the lessons bring them."""

import nbformat

from .coverage import LESSONS
from .display import Page

TERMS = {
    "parabola": "抛物线",
    "control point": "控制顶点",
    "control polygon": "控制多边形",
    "coefficient": "系数",
    "parameter": "参数",
    "explicit": "显式",
    "implicit": "隐式",
    "power basis": "幂基",
    "degree": "次数",
    "weight": "权",
    "basis function": "基函数",
    "Bernstein function": "伯恩斯坦基函数",
    "reverse engineering": "逆向工程",
    "sample": "采样点",
    "fit": "拟合",
    "reconstruction": "重建",
    "least squares": "最小二乘",
    "normal equations": "法方程",
    "design": "设计",
    "relative vector": "相对矢量",
    "absolute vector": "绝对矢量",
    "weighted mean": "加权平均",
    "Pascal's triangle": "杨辉三角",
    "curve in space": "空间曲线",
    "tangent vector": "切向量",
    "partition of unity": "单位分解",
    "property at the ends": "端点性质",
    "symmetry": "对称性",
    "derivative of a function": "导函数",
    "maximum": "最大值",
    "recursion": "递推性",
    "split": "分割",
    "elevation formula": "升阶公式",
    "linear precision": "线性精度",
    "linearly independent": "线性无关",
    "end point interpolation": "端点插值性",
    "end tangent vector": "端点切矢",
    "higher derivative": "高阶导矢",
    "barycentric combination": "重心组合",
    "affine map": "仿射变换",
    "affine invariance": "仿射不变性",
    "affine change of the parameter": "仿射参数变换",
    "collinear": "共线",
    "convex hull": "凸包",
    "variation diminishing": "变差缩减性",
    "Descartes' rule of signs": "笛卡尔符号法则",
    "convex": "凸",
    "convexity theorem": "凸性定理",
    "concave": "凹",
    "inflection point": "拐点",
    "global": "全局",
    "pseudo-local": "伪局部",
    "local control": "局部修改",
    "linear interpolation": "线性插值",
    "de Casteljau's algorithm": "德卡斯特里奥算法",
    "level": "级",
    "tangent": "切线",
    "three-tangent theorem": "三切线定理",
    "shift": "移位",
    "derivative of a curve": "导矢",
    "intermediate control point": "中间控制顶点",
    "converge": "收敛",
    "binomial theorem": "二项式定理",
    "linear combination": "线性组合",
    "pseudo-code": "伪代码",
    "Horner's scheme": "秦九韶算法",
    "convex combination": "凸组合",
    "numerically stable": "数值稳定",
    "extrapolation": "外推",
    "shift operator": "移位算子",
    "identity": "恒等算子",
    "difference": "差分",
    "difference operator": "差分算子",
    "hodograph": "速端曲线",
    "second derivative": "二阶导矢",
    "triangular scheme": "三角阵列",
    "parallelogram": "平行四边形",
    "curvature": "曲率",
    "part of a curve": "子曲线段",
    "discretisation": "离散",
    "curve range": "曲线范围",
    "root finding": "求根",
    "double root": "二重根",
    "single root": "单根",
    "intersection": "求交",
    "greatest common divisor": "最大公因式",
    "degree elevation": "升阶",
    "order": "阶",
    "corner cutting": "割角",
    "degree reduction": "降阶",
    "Legendre's polynomial": "勒让德多项式",
    "orthogonal": "正交",
    "cubic": "三次曲线",
    "join": "拼接",
    "continuous": "连续",
    "geometric continuity": "几何连续",
    "similar": "相似",
    "data point": "型值点",
    "chord": "弦",
    "natural cubic spline": "自然三次样条",
    "cusp": "尖点",
}


def table():
    """English and Chinese, and the first lesson that has the word, as a table to look at."""
    prose = _prose()
    places = {term: next((name for name, text in prose.items() if word in text), "") for term, word in TERMS.items()}
    found = [(term, TERMS[term], places[term]) for term in sorted(TERMS, key=places.get)]
    text = "\n".join(f"{term}: {word} ({lesson})" for term, word, lesson in found)
    rows = "\n".join(f"| {term} | {word} | {lesson} |" for term, word, lesson in found)
    return Page(text, f"| English | 中文 | lesson |\n|---|---|---|\n{rows}")


def _prose():
    """{lesson: its prose}, of the lessons from 01 on."""
    paths = sorted(path for path in LESSONS.glob("[0-9][0-9]-*.ipynb") if not path.name.startswith("00"))
    notebooks = {path.stem[:2]: nbformat.read(path, 4) for path in paths}
    return {
        name: "\n".join(cell.source for cell in one.cells if cell.cell_type == "markdown")
        for name, one in notebooks.items()
    }
