"""What a reader moves, follows and answers in a lesson: the board, explorers, derivations line by line, questions."""

from .asking import ask
from .bench import bench
from .board import Board
from .explorers import (
    explore_affine,
    explore_basis,
    explore_bspline,
    explore_casteljau,
    explore_crossings,
    explore_curvature,
    explore_elevation,
    explore_halving,
    explore_hodograph,
    explore_join,
    explore_powers,
    explore_pull,
    explore_quartic,
    explore_segment,
    explore_spline,
    explore_split,
    explore_tangents,
    explore_weights,
)
from .walking import walk

__all__ = [
    "Board",
    "ask",
    "bench",
    "explore_affine",
    "explore_basis",
    "explore_bspline",
    "explore_casteljau",
    "explore_crossings",
    "explore_curvature",
    "explore_elevation",
    "explore_halving",
    "explore_hodograph",
    "explore_join",
    "explore_powers",
    "explore_pull",
    "explore_quartic",
    "explore_segment",
    "explore_spline",
    "explore_split",
    "explore_tangents",
    "explore_weights",
    "walk",
]
