"""A finished plot: the matplotlib figure, and the same as a scene of the house."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from matplotlib.figure import Figure

from ..drawing.backends.pdf import to_pdf
from ..drawing.backends.png import to_png
from ..drawing.backends.svg import to_svg
from ..drawing.scene import Scene
from ..words import Lang, Words, bare
from .record import record


@dataclass(frozen=True, eq=False)
class Plot:
    """A figure of matplotlib whose pixels are millimetres; its lettering is set by the house's own type."""

    figure: Figure
    title: Words
    lang: Lang

    @cached_property
    def scene(self) -> Scene:
        """The plot as strokes, fills and lettering in mm: for a page, with `drawing.pdf.draw_pdf`."""
        return record(self.figure)

    @property
    def width(self) -> float:
        """mm."""
        return self.scene.extents.width

    @property
    def height(self) -> float:
        """mm."""
        return self.scene.extents.height

    def svg(self) -> str:
        """SVG in mm."""
        return to_svg(self.scene, bare(self.title.of(self.lang)))

    def pdf(self) -> bytes:
        """A PDF page of the plot's size, lines as vectors, fonts embedded."""
        return to_pdf(self.scene)

    def png(self, dpi: float = 200.0) -> bytes:
        """A picture; 25.4 mm are `dpi` pixels."""
        return to_png(self.scene, dpi)
