"""The draggable board.

``state.py`` is what it shows, ``scene.py`` how: every layer as marks; ``svg.py`` draws marks, and so does the script in
``browser/``; ``words.py`` says the exact numbers, ``board.py`` puts them into a widget.
"""

from .board import Board
from .state import LAYERS

__all__ = ["LAYERS", "Board"]
