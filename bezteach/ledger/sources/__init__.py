"""The sources, each read from its first line to its last; a row is one statement."""

from . import deck_basis, deck_curve, deck_operations, games, notes, transcript

READINGS = {
    "deck": [*deck_basis.ROWS, *deck_curve.ROWS, *deck_operations.ROWS],
    "games": [*games.ROWS],
    "notes": [*notes.ROWS],
    "transcript": [*transcript.ROWS],
}
