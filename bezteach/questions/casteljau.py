"""The questions of the lesson on de Casteljau's algorithm."""

QUESTIONS = {}
