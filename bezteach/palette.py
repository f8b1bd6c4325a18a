"""The colours of every picture, apart also in greyscale and for colour-blind readers when a dash or marker helps."""

INK = "#1a1a1a"
FIRST = "#0060a8"
SECOND = "#c04a00"
QUIET = "#8c8c8c"
