"""What all pictures have in common, and how one is shown."""

from io import BytesIO, StringIO

import matplotlib as mpl
from PIL import Image

from bezteach.display import image

STYLE = {
    "font.size": 14,
    "axes.titlesize": 15,
    "lines.linewidth": 2.5,
    "lines.markersize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "svg.hashsalt": "bezteach",
    "svg.fonttype": "path",
}
SAMPLES = 65
COLOURS = 128  # of a PNG: flat pictures need no more, and a third of the bytes is left


def show(figure):
    """Display a figure in a notebook as PNG and SVG with its alternative text."""
    from IPython.display import display

    alt = figure.get_label()
    pixels, png, svg = BytesIO(), BytesIO(), StringIO()
    with mpl.rc_context(STYLE):
        figure.savefig(pixels, format="png", dpi=96)
        figure.savefig(svg, format="svg", metadata={"Date": None, "Creator": None})
    Image.open(pixels).convert("RGB").quantize(COLOURS).save(png, "PNG", optimize=True)
    bundle = {"text/plain": alt, "image/png": png.getvalue(), "text/html": image(svg.getvalue(), alt)}
    display(bundle, raw=True, metadata={"image/png": {"alt": alt}})
