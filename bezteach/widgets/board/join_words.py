"""What a board says of curves in several pieces: the class of each join, and the control points of splines."""

from ...display import number, point
from ...numeric import joins
from .blocks import Block, exact_array, name_of
from .joining import a_frame, joints

ALONE = [Block("Joins (拼接)", (("none: up to four points are one piece",),))]


def pieces_said(state):
    return [_join(*joint, name_of(3 * k)) for k, joint in _numbered(state)] or ALONE


def frames_said(state):
    return [_frame(*joint, name_of(3 * k)) for k, joint in _numbered(state)] or ALONE


def local_said(state):
    return [_cubics("one-sixth rule (六分之一法则)", joins.catmull_rom(state.points))]


def natural_said(state):
    return [_cubics("natural spline (自然样条)", joins.natural(state.points))]


def _numbered(state):
    return enumerate(joints(exact_array(state.points), state.t), 1)


def _join(left, right, lengths, name):
    h, k = lengths
    title = f"Join (拼接) at {name}, intervals {number(h)} and {number(k)}"
    if not h * k:
        return Block(title, (("one interval has no length", "nothing joins"),))
    report = joins.continuity(left, right, lengths)
    rows = [_class(name, getattr(report, name), left_over) for name, left_over in _left_over(report)]
    if report.vanishing:
        rows.append(("G1, G2", "open", f"no tangent on the {' and the '.join(report.vanishing)}"))
    return Block(title, tuple(rows))


def _left_over(report):
    """The classes that are decided, and what of each equation is left over; p ends at the join, q starts there."""
    position, velocity, second = ("C0", "q - p"), ("C1", "q' - p'"), ("C2", "q'' - p''")
    if report.vanishing:
        return [position, velocity, second]
    beta, gamma = number(report.beta), number(report.gamma)
    return [
        position,
        velocity,
        ("G1", "q'" if report.beta <= 0 else f"q' - β p', β = {beta}"),
        second,
        ("G2", f"q'' - β² p'' - γ p', γ = {gamma}" if report.G1.holds else None),
    ]


def _class(name, condition, left_over):
    """A row; a class that does not hold, but leaves nothing over, lacks the one below it."""
    lacks_below = not condition.holds and (left_over is None or not condition.residual.any())
    said = f"needs {name[0]}1" if lacks_below else f"{left_over}: {point(condition.residual)}"
    return name, "yes" if condition.holds else "no", said


def _frame(left, right, lengths, name):
    title, tips = f"A-frame at {name}: C1 with one tip is C2", a_frame(left, right, lengths)
    if tips is None:
        return Block(title, (("none: a piece is no cubic, or has no interval",),))
    sides = zip(("left", "right"), tips, strict=True)
    return Block(title, tuple((f"tip from the {side}", point(tip)) for side, tip in sides))


def _cubics(kind, cubics):
    return Block(f"Control points, {kind}", tuple(tuple(map(point, cubic)) for cubic in cubics))
