"""What the tests of pictures share: words lie inside their picture and apart from each other."""

from matplotlib.text import Text


def assert_words_fit(figure):
    figure.draw_without_rendering()
    frame = figure.bbox.padded(1)
    for axes in figure.axes:
        written = [note for note in [*axes.texts, axes.title] if note.get_text()]
        boxes = [Text.get_window_extent(note) for note in written]  # without the arrow of an annotation
        assert all(frame.contains(box.x0, box.y0) and frame.contains(box.x1, box.y1) for box in boxes)
        assert not any(one.overlaps(other) for k, one in enumerate(boxes) for other in boxes[:k])
