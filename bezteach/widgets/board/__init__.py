"""The draggable board.

``state.py`` is what it shows, ``scene.py`` how: every layer as marks; ``svg.py`` and ``board.js`` draw marks,
``words.py`` says the exact numbers, ``board.py`` puts them into a widget.
"""

from .board import Board
from .state import LAYERS

__all__ = ["LAYERS", "Board"]
