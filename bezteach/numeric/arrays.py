"""What the numeric functions accept, and the two arithmetics they work in.

Numbers are Python and NumPy ints and floats, ``fractions.Fraction`` and SymPy expressions; anything else is a
``ValueError`` of one line that names the rule and the offender. What is read is an array of one of two kinds:

* float64, as soon as one float is among the numbers;
* Python objects (``int``, ``Fraction``, SymPy), in which every sum and product is exact. Integers of NumPy become
  Python integers, so nothing overflows.

Points are rows: the control points lie along axis -2, the coordinates along axis -1, and a batch of curves leads.
SymPy is recognised by its attributes and never imported.
"""

from fractions import Fraction
from math import isfinite
from numbers import Integral, Rational
from operator import index

import numpy as np

FLOAT = np.dtype(float)
FEW = 16  # numbers up to which Python's own sum is the quicker one
MOST = 10**8  # points that one call may be asked for

# Overflow is looked for in the results, where it can be told in words, so NumPy need not warn of it.
quiet = np.errstate(over="ignore", invalid="ignore")


def control_points(points, name="control point b"):
    """The points as (..., n+1, d), and whether they were flat: one coordinate, whose axis `finish` drops again."""
    values = read(points, name)
    if values.ndim == 1:
        return values[:, None], True
    if not 2 <= values.ndim <= 3:
        raise ValueError(f"{name}: {values.ndim} axes; 1 (a coordinate), 2 (a curve) or 3 (a batch) are needed")
    return values, False


def plain(values, ndim):
    """Whether it is a float64 array with so many axes, which needs no reading."""
    return type(values) is np.ndarray and values.dtype is FLOAT and values.ndim == ndim and values.size > 0


def finish(values, flat=False):
    """A result as it is handed out: finite, and without the coordinate axis if the points had none."""
    if values.dtype is FLOAT and not is_finite(values):
        raise ValueError("the result is too large for float64: give the numbers as int or Fraction")
    return drop(values, flat)


def drop(values, flat):
    """Without the coordinate axis if the points had none."""
    return values[..., 0][()] if flat else values


def parameter(t, name="t"):
    """One parameter, as an array without axes."""
    values = read(t, f"parameter {name}")
    if values.ndim:
        raise ValueError(f"parameter {name} has {values.ndim} axes: a single number is needed")
    return values


def whole(value, name, least, most=MOST):
    """A whole number within bounds: a degree, an order, a count."""
    if type(value) is int and least <= value <= most:
        return value
    try:
        number = None if isinstance(value, bool) or str(getattr(value, "dtype", "")) == "bool" else index(value)
    except TypeError:
        number = None
    if number is None:
        raise ValueError(f"{name} is {shown(value)}: a whole number is needed")
    if not least <= number <= most:
        raise ValueError(f"{name} is {shown(number)}: it must be between {least} and {most}")
    return number


def one_arithmetic(*values):
    """The arrays as they are if all are float64 or all exact, else all float64."""
    if len({v.dtype is FLOAT for v in values}) == 1:
        return values
    return tuple(v if v.dtype is FLOAT else _floats(v.ravel().tolist()).reshape(v.shape) for v in values)


def is_finite(values):
    """Whether all of a float64 array is finite; a finite sum, or one of squares, says so in one quick pass."""
    flat = values.ravel("K")  # no copy, also of a transposed array
    quick = sum(flat.tolist()) if flat.size <= FEW else np.vdot(flat, flat)  # unlike `dot` it warns of nothing
    return isfinite(quick) or bool(np.isfinite(flat).all())


def read(values, name):
    """An array of float64 or of exact objects from whatever the caller gave."""
    if type(values) is not np.ndarray or values.dtype is not FLOAT:
        values = _converted(values, name)
    if not values.size:
        raise ValueError(f"{name}: there are none, the array is empty")
    if values.dtype is FLOAT and not is_finite(values):
        at = np.argwhere(~np.isfinite(values))[0]
        _reject(values[tuple(at)].item(), name, at)
    return values


def _converted(values, name):
    if type(values) is np.ndarray and values.dtype.kind in "iu":
        return values.astype(object)
    if type(values) is np.ndarray and values.dtype.kind == "f":
        return _rounded(values)
    shape, leaves = _unnested(values, name)
    numbers = [_number(leaf) for leaf in leaves]
    for i in (i for i, number in enumerate(numbers) if number is None):
        _reject(leaves[i], name, np.unravel_index(i, shape))
    if float in map(type, numbers):
        return _floats(numbers).reshape(shape)
    return np.fromiter(numbers, object, len(numbers)).reshape(shape)


@quiet
def _rounded(values):
    return values.astype(float)


def _unnested(values, name):
    """Shape and numbers of nested lists, tuples and arrays, one level at a time."""
    shape, level, levels, seen = (), [values], [], set()
    while True:
        level = [v.tolist() if _is_array(v) else v for v in level]
        lengths = [len(v) if isinstance(v, (list, tuple, range)) else None for v in level]
        for i, length in enumerate(lengths):
            if length != lengths[0]:
                at = "".join(f"[{k}]" for k in np.unravel_index(i, shape))
                raise ValueError(f"{name}: ragged, the entry {at} has not the length of the first")
        if lengths[0] is None:
            return shape, level
        # A list found again at another depth holds itself; `levels` keeps all alive, so an id stays unique.
        if lengths[0] == 0 or len(shape) == 16 or not seen.isdisjoint(map(id, level)):
            raise ValueError(f"{name}: empty, nested too deep, or a list that holds itself")
        seen.update(map(id, level))
        levels.append(level)
        shape += (lengths[0],)
        level = [item for row in level for item in row]


def _is_array(value):
    if isinstance(value, np.ndarray):
        return value.dtype.kind not in "mMV"
    return hasattr(value, "tolist") and not isinstance(value, np.generic)


def _number(value):
    """The value as int, Fraction, float or SymPy expression; None if it is no finite real number."""
    if type(value) is int or (type(value) is Fraction and type(value.numerator) is type(value.denominator) is int):
        return value
    if hasattr(value, "free_symbols"):
        return _expression(value)
    if isinstance(value, (bool, np.bool_)):
        return None
    if isinstance(value, (float, np.floating)):
        return float(value) if isfinite(value) else None
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Rational):
        return Fraction(int(value.numerator), int(value.denominator))
    return None


def _expression(value):
    """A SymPy expression; one with a Float in it as a float."""
    if not getattr(value, "is_scalar", False):  # a matrix, a set, a truth value
        return None
    atoms = value.atoms()
    # oo, zoo, nan and I are numbers that are not real
    unreal = (a.is_real is False or (a.is_number and not a.is_real) for a in atoms if hasattr(a, "is_real"))
    if value.is_real is False or any(unreal):
        return None
    return float(_floats([value])[0]) if any(a.is_Float for a in atoms) else value


def _floats(numbers):
    """Exact numbers as float64."""
    symbolic = [x for x in numbers if not getattr(x, "is_number", True)]
    if symbolic:
        raise ValueError(f"a float beside {shown(symbolic[0])}: write the float as a fraction to stay exact")
    try:
        values = np.array([float(x) for x in numbers])
    except OverflowError:
        values = np.array([np.inf])
    if not is_finite(values):
        raise ValueError("a number is too large for float64: write the floats beside it as fractions")
    return values


def _reject(value, name, at):
    """Raise, naming the entry of the argument and what stands there."""
    at = [int(k) for k in at]
    if name.startswith("parameter"):
        what = name + (f"{at} is" if at else " is")
    else:
        curve = f" of curve {at[0]}" if len(at) == 3 else ""
        place = f"_{at[-2] if len(at) > 1 else at[0]}" if at else ""
        what = f"{name}{place}{curve} has coordinate" if at else f"{name}"
    raise ValueError(f"{what} {shown(value)}: a finite real number is needed")


def shown(value):
    """A value in one short line, also where its repr fails or runs over many lines."""
    try:
        text = " ".join(repr(value).split())
    except Exception:
        text = f"a {type(value).__name__}"
    return text if len(text) <= 60 else text[:57] + "..."
