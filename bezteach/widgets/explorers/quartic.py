"""The deck's quartic with a free height w: its polygon is concave for some w for which the curve is convex."""

from fractions import Fraction

from ... import numeric
from ...display import number
from ...examples import EXAMPLES
from ..board import Board
from ..board.blocks import Block
from ..board.counting import roots_inside
from ..board.marks import STYLES, Mark
from .sliders import beside, slider

AXIS = Mark("whole", ((0, 0), (1, 0)), STYLES["axis"])
STOPS = tuple(Fraction(k, 16) for k in range(-8, 17))


def explore_quartic(w=Fraction(1, 4), goal=None):
    """The quartic with control points at the places 0, 1/4, ..., 1 and the heights 0, 1/4, w, 1/4, 0.

    ``w``: a multiple of 1/16 from -1/2 to 1; its slider is ``.controls["w"]``, the board ``.board``. Slider and b₂ move
    each other; a height from Python that is no stop of the slider leaves it where it is. A ``goal`` is a task for the
    board's state. Source: deck, 1.2, note on the convexity theorem.
    """
    height = slider(w, "w, the height of b₂", STOPS)
    board = Board(
        quartic(w),
        show=("polygon", "curve"),
        offer=("polygon", "curve", "hull", "tangents"),
        grid=Fraction(1, 16),
        vertical=True,
        view=(-0.1, -0.55, 1.1, 1.05),  # on its grid, b₂ stays among the slider's stops
        goal=goal,
        marks=lambda state: [AXIS],
        blocks=lambda state: quartic_blocks(state.points),
    )

    def lead(change):
        points = list(board.points)
        points[2] = (points[2][0], change.new)
        board.change(points=points)

    def follow(change):
        if board.points[2][1] in STOPS:
            height.value = board.points[2][1]

    height.observe(lead, "value")
    board.observe(follow, "state")
    return beside(board, {"w": height})


def quartic(w):
    """The control points for a height w."""
    return tuple((x, w if y == "w" else y) for x, y in EXAMPLES["deck/quartic"].given["points"])


def quartic_blocks(points):
    """What is said of a graph y(x) with these control points: its second derivative's coefficients and signs.

    The graph's inflection points are counted exactly.
    """
    heights = [y for _, y in points]
    edges = numeric.sign_changes(numeric.hodograph(heights, 2))
    second = tuple(numeric.hodograph(heights, 2))
    turns = (roots_inside(second) or (0, 0))[0]
    curve = (
        f"{turns} inflection point{'s' * (turns != 1)}: {'not convex' if turns else 'convex, it bends one way only'}"
    )
    return [
        Block("Heights", (tuple(map(number, heights)),)),
        Block("Coefficients of y'' in the Bernstein basis", (tuple(map(number, second)),)),
        Block("The polygon", ((f"its edges turn {'both ways' if edges else 'one way only'}",),)),
        Block("The curve", ((curve,),)),
    ]
