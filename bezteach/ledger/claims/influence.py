"""What one control point does to the curve: it moves all of it between the ends, and most near its parameter i/n."""

from ..claim import Known, argued

CLAIMS = [
    argued(
        "influence/everywhere",
        "moving one control point moves the curve at every t with 0 < t < 1, and an end only if it is the end point",
        Known("Moving b_j by a vector moves the point at t by B_{j,n}(t) times that vector.", "curve/moved"),
        Known("This factor is positive for every t between 0 and 1: no point there stays.", "basis/positive-inside"),
        Known("At t = 0 it is 0 for j = 1, ..., n: only b_0 moves the start.", "basis/start/others"),
        Known("At t = 1 it is 0 for j = 0, ..., n - 1: only b_n moves the end.", "basis/end/others"),
    ),
    argued(
        "influence/falls",
        "the influence of b_j grows up to t = j/n and falls after it",
        Known("The influence at t is B_{j,n}(t).", "curve/moved"),
        Known("t (1 - t) times its derivative is (j - n t) B_{j,n}(t).", "basis/maximum/from-derivative"),
        Known("B_{j,n} is positive between 0 and 1,", "basis/positive-inside"),
        "so there the derivative has the sign of j - n t: positive before j/n, negative after it. The distance that "
        "counts is that of the parameter t from j/n, on one side; it is no distance in the plane.",
    ),
]
