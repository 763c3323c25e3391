"""A reportlab canvas that writes a tagged PDF: structure, tab order, metadata, links; fonts of our own only."""

from __future__ import annotations

from typing import Any

from reportlab.pdfgen.canvas import Canvas

from .packed import Flate, PackedDocument
from .strings import pdf_string
from .tag import Role, Tag
from .tree import tree_of
from .written import Plain, StructureWriter, say


class TaggedCanvas(Canvas):  # type: ignore[misc]
    """PDF 1.7, the same bytes every time; what `tree_of` holds when it is saved becomes the file's structure."""

    def __init__(self, filename: Any, *, font: str, **options: Any) -> None:
        options |= {"initialFontName": font, "pdfVersion": (1, 7), "invariant": 1, "pageCompression": 0}
        super().__init__(filename, **options)
        tree_of(self).lang = "en" if str(options.get("lang") or "").startswith("en") else "zh"
        self._doc.__class__ = PackedDocument  # reportlab makes its document itself, and asks for no class
        self._doc.defaultStreamFilters = [Flate()]  # for this document alone, without Base 85 around it
        self.setViewerPreference("DisplayDocTitle", "true")
        self.setViewerPreference("PrintScaling", "None")  # a millimetre of the sheet is one of the print

    def showPage(self) -> None:
        """The page knows its structure, and is walked through in the order of it."""
        index = tree_of(self).turn()
        super().showPage()
        page = self._doc.Pages.pages[-1]
        page.__NoDefault__ = [*page.__NoDefault__, "StructParents", "Tabs"]
        page.StructParents, page.Tabs = index, "/S"

    def mark_place(self, goal: str, x: float, y: float) -> None:
        """References to this name lead here, where the block that it names begins on this page."""
        if goal not in self._placed():
            self._placed().add(goal)
            self.bookmarkHorizontal(goal, 0, y)

    def _placed(self) -> set[str]:
        found: set[str] = self.__dict__.setdefault("_vecpoly_places", set())
        return found

    def link(self, key: str, rect: tuple[float, float, float, float], said: str, tag: Tag) -> None:
        """A link over this rectangle (of the present coordinates) to a bookmark, a part of the tagged element."""
        name = f"Annot.{key}.{len(tree_of(self).links)}"
        note = _Link(self._bookmarkReference(key), self._absRect(rect, 1), said)
        note.parent = tree_of(self).annotate(Tag(Role.LINK, tag, said) if tag.role is not Role.LINK else tag, name)
        self._doc.Reference(note, name)
        self._annotationrefs.append(self._doc.Reference(note))
        self._links().append(note)

    def _links(self) -> list[_Link]:
        found: list[_Link] = self.__dict__.setdefault("_vecpoly_links", [])
        return found

    def save(self) -> None:
        """Write the structure, then the file."""
        if len(self._code):
            self.showPage()
        tree = tree_of(self)
        for note in self._links():
            note.parent += len(tree.pages) - 1
        StructureWriter(self, tree).write()
        say(self._doc)
        super().save()


class _Link(Plain):
    """A link that is not seen, and says where it leads."""

    def __init__(self, destination: Any, rect: Any, said: str) -> None:
        super().__init__()
        self.parent = 0
        self._destination, self._rect, self._said = destination, rect, said

    def format(self, document: Any) -> bytes:
        """Its dictionary."""
        to = self._destination.format(document).decode()
        rect = " ".join(f"{x:.2f}" for x in self._rect)
        return (
            f"<</Type/Annot/Subtype/Link/Rect[{rect}]/Border[0 0 0]/F 4/Dest {to}"
            f"/Contents{pdf_string(self._said)}/StructParent {self.parent}>>"
        ).encode("latin-1")
