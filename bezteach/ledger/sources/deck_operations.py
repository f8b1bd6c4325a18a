"""The deck, section 2: linear operations on Bézier curves."""

from . import deck_casteljau, deck_derivatives, deck_splitting

ROWS = [*deck_casteljau.ROWS, *deck_derivatives.ROWS, *deck_splitting.ROWS]
