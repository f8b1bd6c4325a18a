"""The board in a browser: it paints a state at once and moves its points; Python answers with exact numbers.

The files of ``browser/`` are one script, in this order; a widget and an exported page have nothing else to load.
"""

from pathlib import Path

HERE = Path(__file__).parent
PARTS = ("exact", "scene", "spline", "picture", "moving", "alone")
SCRIPT = "\n".join((HERE / "browser" / f"{part}.js").read_text(encoding="utf-8") for part in PARTS)
CSS = (HERE / "board.css").read_text(encoding="utf-8")
