"""A curve in space, as a picture in the plane."""

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from .. import numeric
from ..display import point
from ..palette import FIRST, INK, QUIET
from .style import SAMPLES, STYLE


@mpl.rc_context(STYLE)
def space(points):
    """A curve in space with its control polygon, and the shadow of both on the ground; ``points``: shape (n+1, 3)."""
    places = np.asarray(points, dtype=float)
    figure = Figure(figsize=(7, 5.6), layout="constrained")
    axes = figure.add_subplot(projection="3d", computed_zorder=False)
    ground = min(places[:, 2].min(), 0.0)
    for height, look, dash in ((lambda z: np.full_like(z, ground), QUIET, ":"), (lambda z: z, FIRST, "-")):
        x, y, z = numeric.sample(places, SAMPLES).T
        axes.plot(x, y, height(z), dash, color=look, linewidth=4 if dash == "-" else 2)
        x, y, z = places.T
        axes.plot(x, y, height(z), dash, color=INK if dash == "-" else QUIET, linewidth=1.4, marker="o", markersize=5)
    for x, y, z in places:
        axes.plot([x, x], [y, y], [ground, z], color=QUIET, linewidth=0.8, zorder=0)
    for i, (x, y, z) in enumerate(places):
        axes.text(x, y, z + 0.09 * np.ptp(places[:, 2]), f"$b_{{{i}}}$", ha="center")
    axes.set(xlabel="x", ylabel="y", zlabel="z")
    axes.locator_params(nbins=5)
    axes.view_init(elev=24, azim=-58)
    figure.set_label(
        f"A curve of degree {len(points) - 1} in space, above its shadow on the ground, with the control points "
        f"{', '.join(map(point, points))}."
    )
    return figure
