"""A panel: ipywidgets on the screen, and words and a picture in their place where no kernel runs."""

import ipywidgets as widgets


class Panel(widgets.VBox):
    """A column of widgets that tells its state in words and has a stand-in for a stored notebook or a printout.

    ``text`` and ``static`` are functions: of them come the words, and {"image/svg+xml": ...} or the like.
    """

    def __init__(self, children, *, text, static):
        super().__init__(children)
        self._text, self._static = text, static

    @property
    def text(self):
        return self._text()

    def __repr__(self):
        return self.text

    def _repr_mimebundle_(self, **kwargs):
        live = super()._repr_mimebundle_(**kwargs)
        return live | {"text/plain": self.text} | self._static()
