"""The board: control points to drag, layers to switch on, exact numbers beside them."""

from fractions import Fraction
from html import escape

import anywidget
import traitlets

from ...display import image
from . import knots as knot_line
from . import scene, svg, words
from .blocks import html, text
from .marks import STYLES
from .script import CSS, SCRIPT
from .state import DEEPEST, HIGHEST, LAYERS, MOST, OF_KNOTS, State, exact, from_json, layers_of, state_of, to_json

STEPS = (Fraction(1), Fraction(1, 2), Fraction(1, 4), Fraction(1, 12), Fraction(1, 24))
FINE = 12  # steps of the grid across the points, at least


class Board(anywidget.AnyWidget):
    """A Bézier curve whose control points are moved by mouse, touch and keyboard; its numbers are exact.

    ``points``: 2 to 20 rows of two exact numbers; ``t`` in [0, 1]; ``show``: names of layers (``LAYERS``). Further
    settings of a state by name: ``a``, ``b``, ``line`` (two points), ``level``, ``end``, ``depth``, ``raised``.

    With ``knots`` it is a B-spline curve of degree 1 to 5, t in its domain, and ``OF_KNOTS`` its layers. The knots
    stand in a line under the picture: they are moved along it, and a click on one inserts it once more.

    Moved points snap to multiples of ``grid``. ``vertical`` is for graphs: points move up and down only, their number
    stays, and the axes have scales of their own. ``projector`` draws thick lines and large letters, ``letter`` names
    the points, ``offer`` the layers that the reader may switch, ``view`` is the part (x0, y0, x1, y1) of the plane.

    A ``goal`` (``questions.Goal``) is a task for the state, whose end is recognised. ``blocks`` and ``marks`` are
    functions from a state: what is said in the place of the layers' own words, what is painted under the layers.

    A float stands for the fraction it is nearest to, if that has a small denominator. ``ValueError`` names a point
    with other than two coordinates, what is no number, a parameter outside [0, 1], an unknown layer, too few or too
    many points.

    >>> board = Board([(0, 0), (1, 3), (2, 1), (3, 3)], t=Fraction(1, 3), show=("polygon", "curve", "levels"))
    >>> board.t = Fraction(1, 2)
    >>> board.state.t
    Fraction(1, 2)
    """

    _esm = SCRIPT
    _css = CSS
    state = traitlets.Instance(State).tag(
        sync=True, to_json=lambda value, _: to_json(value), from_json=lambda value, _: from_json(value)
    )
    home = traitlets.Dict().tag(sync=True)
    answer = traitlets.Dict().tag(sync=True)
    view = traitlets.List(traitlets.Float()).tag(sync=True)
    ends = traitlets.List(traitlets.Float()).tag(sync=True)
    grid = traitlets.Unicode().tag(sync=True)
    layers = traitlets.Dict().tag(sync=True)
    styles = traitlets.Dict().tag(sync=True)
    limits = traitlets.Dict().tag(sync=True)
    most = traitlets.Int(MOST).tag(sync=True)
    vertical = traitlets.Bool(False).tag(sync=True)
    projector = traitlets.Bool(False).tag(sync=True)
    letter = traitlets.Unicode("b").tag(sync=True)

    def __init__(
        self,
        points,
        t=None,
        show=None,
        *,
        grid=None,
        vertical=False,
        projector=False,
        letter="b",
        offer=None,
        view=None,
        goal=None,
        blocks=words.blocks,
        marks=lambda state: [],
        **settings,
    ):
        start = state_of(points, t=t, show=show, **settings)
        layers = LAYERS if start.knots is None else OF_KNOTS
        knots = start.knots or (0, 1)
        step = _step(_extent(start.points)) if grid is None else exact(grid, "the grid's step")
        if step <= 0:
            raise ValueError(f"the grid's step is {step}, and must be positive")
        self._blocks, self._marks, self._goal = blocks, marks, goal
        super().__init__(
            state=start,
            home=to_json(start),
            answer=self._answered(start),
            view=list(svg.room(start.points) if view is None else view),
            ends=[float(knots[0]), float(knots[-1])],
            grid=str(step),
            layers={name: layers[name] for name in layers_of(layers if offer is None else offer, start.knots)},
            styles={name: style._asdict() for name, style in STYLES.items()},
            limits={"depth": DEEPEST, "raised": HIGHEST, "knots": str(_step(knots[-1] - knots[0]))},
            vertical=vertical,
            projector=projector,
            letter=letter,
        )

    @traitlets.observe("state")
    def _answer(self, change):
        self.answer = self._answered(change.new)

    def _answered(self, now):
        said, task = self._blocks(now), self._task(now)
        return {
            "state": to_json(now),
            "html": "".join(f"<p role='status'><b>{escape(words)}</b></p>" for words in task) + html(said),
            "text": "; ".join([text(said), *task]),
            "marks": [mark._asdict() | {"style": mark.style._asdict()} for mark in self._marks(now)],
        }

    def _task(self, now):
        goal = self._goal
        return [] if goal is None else [goal.praise if goal.reached(now) else goal.text]

    def refresh(self):
        """Say and paint again what has changed beside the state."""
        self.answer = self._answered(self.state)

    def change(self, **settings):
        """Set any settings of the state at once; ``ValueError`` if one is wrong, and then nothing changes."""
        self.state = state_of(**(self.state._asdict() | settings))

    @property
    def points(self):
        """The control points, a tuple of pairs of Fractions."""
        return self.state.points

    @points.setter
    def points(self, given):
        self.change(points=given, level=None)

    @property
    def t(self):
        """The parameter, a Fraction in [0, 1]."""
        return self.state.t

    @t.setter
    def t(self, given):
        self.change(t=given)

    @property
    def knots(self):
        """The knots, a tuple of Fractions, or None."""
        return self.state.knots

    @property
    def text(self):
        """What the board says, in words."""
        return self.answer["text"]

    @property
    def marks(self):
        """What the board shows, as marks."""
        return self._marks(self.state) + scene.scene(self.state, self.letter)

    @property
    def line_view(self):
        """The part of the plane that is shown of the knots' line, as ``view``; None without knots."""
        return None if self.knots is None else knot_line.line_view(self.ends, knot_line.degree_of(self.state))

    @property
    def svg(self):
        """The picture as SVG text, for a stored notebook and a printout."""
        return svg.picture(self.marks, self.view, self.text, stretched=self.vertical, line=self.line_view)

    def figure(self):
        """The picture as a matplotlib ``Figure`` for a handout."""
        from ...figures import drawn

        return drawn(self.marks, self.view, self.text, stretched=self.vertical, line=self.line_view)

    def __repr__(self):
        return self.text

    def _repr_mimebundle_(self, **kwargs):
        live = super()._repr_mimebundle_(**kwargs)
        data, metadata = live if isinstance(live, tuple) else (live, {})
        return (data or {}) | {"text/plain": self.text, "text/html": image(self.svg, self.text)}, metadata


def _step(span):
    """The largest of the usual steps that leaves enough of them across."""
    return next((step for step in STEPS if FINE * step <= span), STEPS[-1])


def _extent(points):
    x0, y0, x1, y1 = svg.room(points, spare=0)
    return max(x1 - x0, y1 - y0)
