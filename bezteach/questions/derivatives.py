"""The questions of the lesson on derivatives and the hodograph."""

QUESTIONS = {}
