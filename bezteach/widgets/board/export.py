"""A board as one page of HTML that needs neither Python nor a network: for a course page, opened from a file."""

import json
from html import escape

from .script import CSS, SCRIPT

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ margin: 1em auto; padding: 0 1em; max-width: 1100px; font-family: system-ui, sans-serif; }}
{css}
@media (prefers-color-scheme: dark) {{
  .bt-board {{ --bt-ink: #eee; --bt-paper: #121212; --bt-first: #64b5f6; --bt-second: #ff9e57; --bt-quiet: #9e9e9e; }}
  body {{ background: #121212; color: #eee; }}
}}
</style>
</head>
<body>
<h1>{title}</h1>
<p>Drag a control point, or press Tab until it is marked and move it with the arrow keys; Shift takes larger steps.</p>
<main id="board"></main>
<noscript>This page needs JavaScript. {text}</noscript>
<script type="module">
{script}
render({{ model: standIn({values}), el: document.getElementById("board") }});
</script>
</body>
</html>
"""
SENT = (
    "state",
    "home",
    "view",
    "ends",
    "grid",
    "layers",
    "styles",
    "limits",
    "most",
    "vertical",
    "projector",
    "letter",
)


def page(board, title):
    """The text of a page with this board; reset goes back to the state that the board has now.

    >>> from bezteach.widgets import Board
    >>> text = page(Board([(0, 0), (1, 2), (2, 0)]), "A parabola")
    >>> "http" in text.replace("http://www.w3.org/2000/svg", "")
    False
    """
    sent = board.get_state(SENT)
    values = json.dumps(sent | {"home": sent["state"]}).replace("</", "<\\/")
    return PAGE.format(
        title=escape(title),
        css=CSS,
        script=SCRIPT,
        values=values,
        text=escape(board.text),
    )
