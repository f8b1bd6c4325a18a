"""Curves that come as near to given data as their degree allows: least squares in the Bernstein basis."""

from fractions import Fraction

import numpy as np

from bezteach.numeric import basis
from bezteach.numeric.arrays import FLOAT, control_points, finish, one_arithmetic, quiet, read, whole
from bezteach.numeric.exact import exact, is_zero, tidy


@quiet
def fit(data, degree, parameters=None):
    """Control points (degree+1, d) of the curve that is nearest to N data points (N, d) by least squares.

    The data point D_i is compared with p(t_i), and the sum of |p(t_i) - D_i|^2 is least. Without ``parameters`` the
    t_i are i/(N-1), evenly over [0, 1]. With N = degree+1 the curve passes through all data points. A batch of data,
    (B, N, d), is fitted with the same t_i and gives (B, degree+1, d).

    >>> fit([[15, 1], [11, -1], [4, 4], [-1, 11], [1, 15]], 2).astype(str).tolist()
    [['16', '0'], ['0', '0'], ['0', '16']]

    Exact numbers are fitted by the normal equations, in Fractions; floats by NumPy's ``lstsq``, which loses digits at
    high degrees. Parameters that are symbols are taken to be different from each other and from the numbers, unless
    they are certainly equal. Raises ValueError for data or parameters that are no finite real numbers, a degree that
    is no whole number or negative, fewer data points or fewer different parameters than degree+1, not one parameter
    for each data point, and parameters that float64 cannot keep apart.
    Source: games, "review: fitting" and "two kinds of modelling: reconstruction"; transcript, overview.
    """
    data, flat = control_points(data, "data point D")
    degree, count = whole(degree, "degree", 0), data.shape[-2]
    if count <= degree:
        raise ValueError(f"data points: {count}, and degree {degree} needs at least {degree + 1}")
    data, t = one_arithmetic(data, _parameters(parameters, count))
    if len(set(t.tolist())) <= degree:
        raise ValueError(
            f"different parameters: {len(set(t.tolist()))}, and degree {degree} needs at least {degree + 1}"
        )
    columns = np.moveaxis(data, -2, 0)
    solve = _nearest if data.dtype is FLOAT else _normal
    found = solve(finish(basis.basis(degree, t)), columns.reshape(count, -1))
    return finish(np.moveaxis(found.reshape(degree + 1, *columns.shape[1:]), 0, -2), flat)


def _parameters(given, count):
    """The t_i as an array (count,) that divides exactly, evenly spaced if none are given."""
    if given is None:
        given = [Fraction(i, max(count - 1, 1)) for i in range(count)]
    t = read(given, "parameter t")
    if t.shape != (count,):
        raise ValueError(f"parameters of shape {t.shape}: {count} numbers are needed, one for each data point")
    return t if t.dtype is FLOAT else exact(t)


def _nearest(rows, columns):
    """The x with rows x nearest to the columns, in float64."""
    found, _, rank, _ = np.linalg.lstsq(rows, columns, rcond=None)
    if rank < rows.shape[1]:  # lstsq would go on with the shortest of many solutions
        raise ValueError("parameters too close together for float64: give data and parameters as int or Fraction")
    return found


def _normal(rows, columns):
    """The x with rows^T rows x = rows^T columns: elimination without a search for pivots: all are positive."""
    size = rows.shape[1]
    system = tidy(rows.T @ np.concatenate([rows, columns], axis=1))
    for k in range(size):
        if is_zero(system[k, k]):  # two formulas for one number, which looked different
            raise ValueError(f"different parameters: {k}, and degree {size - 1} needs at least {size}")
        system[k] = tidy(system[k] / system[k, k])
        for i in (i for i in range(size) if i != k):
            system[i] = tidy(system[i] - system[i, k] * system[k])
    return system[:, size:]
