"""The structure tree as PDF objects: elements, the tree from marked content back to them, what the catalogue says."""

from __future__ import annotations

from typing import Any

from reportlab.pdfbase.pdfdoc import PDFDictionary, PDFName, PDFObject, PDFStream

from .strings import pdf_string
from .tree import Annotated, Content, Element, Tree
from .xmp import packet


class Plain(PDFObject):  # type: ignore[misc]
    """An object that is written as it stands."""

    __RefOnly__ = 1

    def __init__(self, text: str = "") -> None:
        self.text = text

    def format(self, _: Any) -> bytes:
        """Its text."""
        return self.text.encode("latin-1")


class StructureWriter:
    """Gives every element a number, then writes them."""

    def __init__(self, canvas: Any, tree: Tree) -> None:
        self._document, self._tree = canvas._doc, tree
        self._objects = dict[int, Plain]()
        self._numbers = dict[int, int]()

    def write(self) -> None:
        """Put root, elements and parent tree into the document."""
        root, document = Plain(), Plain()
        self._root, self._body = self._number(root, "root"), self._number(document, "document")
        self._reserve(self._tree.root)
        parents = self._number(Plain(self._parents()), "parents")
        tree = f"/ParentTree {parents} 0 R/ParentTreeNextKey {self._next}"
        root.text = f"<</Type/StructTreeRoot/K[{self._body} 0 R]{tree}>>"
        kids = " ".join(f"{self._numbers[id(kid)]} 0 R" for kid in self._tree.root.kids)
        document.text = f"<</Type/StructElem/S/Document/P {self._root} 0 R/K[{kids}]>>"
        self._fill(self._tree.root, self._body)
        self._document.Catalog.StructTreeRoot = self._document.Reference(root)
        self._document.Catalog.MarkInfo = self._document.Reference(Plain("<</Marked true>>"), "vecpoly.marked")

    @property
    def _next(self) -> int:
        return len(self._tree.pages) - 1 + len(self._tree.links)

    def _number(self, one: Plain, name: str) -> int:
        self._document.Reference(one, f"vecpoly.{name}")
        return int(self._document.idToObjectNumberAndVersion[f"vecpoly.{name}"][0])

    def _reserve(self, element: Element) -> None:
        for kid in element.kids:
            if isinstance(kid, Element):
                plain = self._objects[id(kid)] = Plain()
                self._numbers[id(kid)] = self._number(plain, f"element{len(self._objects)}")
                self._reserve(kid)

    def _parents(self) -> str:
        """Of each page the elements of its contents in order, then of each link its own."""
        rows = [
            f"{i}[{' '.join(f'{self._numbers[id(one)]} 0 R' for one in page)}]"
            for i, page in enumerate(self._tree.pages[:-1])
        ]
        count = len(rows)
        rows += [f"{count + i} {self._numbers[id(one)]} 0 R" for i, one in enumerate(self._tree.links)]
        return f"<</Nums[{' '.join(rows)}]>>"

    def _fill(self, element: Element, parent: int) -> None:
        for kid in element.kids:
            if isinstance(kid, Element):
                number = self._numbers[id(kid)]
                self._objects[id(kid)].text = self._dictionary(kid, parent)
                self._fill(kid, number)

    def _dictionary(self, element: Element, parent: int) -> str:
        tag = element.tag
        assert tag is not None
        page = next((kid.page for kid in element.kids if isinstance(kid, Content)), None)
        alt = f"/Alt{pdf_string(tag.alt)}" if tag.alt else ""
        on = f"/Pg {self._page(page)}" if page is not None else ""
        kids = " ".join(self._kid(kid, page) for kid in element.kids)
        held = f"/K[{kids}]" if len(element.kids) != 1 else f"/K {kids}"
        return f"<</S/{tag.role.value}/P {parent} 0 R{on}{alt}{tag.attributes}{held if kids else ''}>>"

    def _kid(self, kid: Element | Content | Annotated, page: int | None) -> str:
        match kid:
            case Element():
                return f"{self._numbers[id(kid)]} 0 R"
            case Content(on, number):
                return str(number) if on == page else f"<</Type/MCR/Pg {self._page(on)}/MCID {number}>>"
            case Annotated(on, name):
                link = self._document.idToObjectNumberAndVersion[name][0]
                return f"<</Type/OBJR/Pg {self._page(on)}/Obj {link} 0 R>>"

    def _page(self, page: int) -> str:
        return f"{self._document.idToObjectNumberAndVersion[f'Page{page + 1}'][0]} 0 R"


def say(document: Any) -> None:
    """What the file says about itself, in XMP too."""
    info, catalog = document.info, document.Catalog
    lang = getattr(catalog.Lang, "s", "en-GB") if catalog.Lang else "en-GB"
    words = packet(
        title=info.title, author=info.author, subject=info.subject, keywords=info.keywords,
        lang=lang, creator=info.creator, producer=info.producer,
    )  # fmt: skip
    kind = PDFDictionary({"Type": PDFName("Metadata"), "Subtype": PDFName("XML")})
    catalog.Metadata = PDFStream(kind, words.encode(), filters=[])
