"""Explorers: a board, or a picture, with controls, for one idea each; what they show is a function of their state."""

from .affine import explore_affine
from .basis import explore_basis
from .bspline import explore_bspline
from .joining import explore_join, explore_spline
from .powers import explore_powers
from .presets import (
    explore_casteljau,
    explore_crossings,
    explore_curvature,
    explore_elevation,
    explore_halving,
    explore_hodograph,
    explore_pull,
    explore_segment,
    explore_split,
    explore_tangents,
)
from .quartic import explore_quartic
from .weights import explore_weights

__all__ = [
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
]
