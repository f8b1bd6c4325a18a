"""What a reader moves, follows and answers in a lesson: the board, explorers, derivations line by line, questions."""

from .asking import ask
from .basis_explorer import explore_basis
from .bench import bench
from .board import Board
from .explorers import explore_segment, explore_split
from .walking import walk

__all__ = ["Board", "ask", "bench", "explore_basis", "explore_segment", "explore_split", "walk"]
