"""The structure tree of a document, grown while its pages are drawn: what is drawn first is read first."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from ..words import Lang
from .strings import pdf_string
from .tag import Tag

Open = Callable[[], tuple[str, ...]]  # the operators that begin marked content, made when something is put into it
ARTIFACT = "/Artifact BMC"
HEADER = "/Artifact<</Type/Pagination/Subtype/Header>>BDC"
FOOTER = "/Artifact<</Type/Pagination/Subtype/Footer>>BDC"
END = "EMC"


@dataclass(frozen=True, slots=True)
class Content:
    """Marked content: its page, counted from 0, and its number there."""

    page: int
    number: int


@dataclass(frozen=True, slots=True)
class Annotated:
    """A link on a page, by the name under which the document knows it."""

    page: int
    name: str


@dataclass(slots=True)
class Element:
    """An element and what it holds, in the order of reading."""

    tag: Tag | None
    kids: list[Element | Content | Annotated] = field(default_factory=list)


class Tree:
    """Grows with the pages; `begin` gives the operators under which the next piece of an element is drawn."""

    def __init__(self) -> None:
        self.root = Element(None)
        self.lang: Lang = "zh"  # of what is said in the place of figures and formulas
        self.goals: frozenset[str] = frozenset()  # the places that references may lead to
        self.pages: list[list[Element]] = [[]]
        self.links: list[Element] = []
        self._elements: dict[Tag, Element] = {}

    def element(self, tag: Tag) -> Element:
        """The element of a tag, in its place since it was first drawn."""
        found = self._elements.get(tag)
        if found is None:
            found = self._elements[tag] = Element(tag)
            (self.element(tag.within) if tag.within is not None else self.root).kids.append(found)
        return found

    def begin(self, tag: Tag, actual: str = "") -> tuple[str, ...]:
        """The operators that open a piece of this element, each to be closed; actual: the text that it stands for."""
        element, marked = self.element(tag), self.pages[-1]
        element.kids.append(Content(len(self.pages) - 1, len(marked)))
        marked.append(element)
        outer = f"/{tag.role.value}<</MCID {len(marked) - 1}>>BDC"
        return (
            (outer, f"/Span<</ActualText{pdf_string(actual)}>>BDC") if actual else (outer,)
        )  # poppler: of a Span alone

    def opener(self, tag: Tag, actual: str = "") -> Open:
        """`begin`, when it is needed."""
        return lambda: self.begin(tag, actual)

    def annotate(self, tag: Tag, name: str) -> int:
        """A link belongs to this element; its place among the links."""
        element = self.element(tag)
        element.kids.append(Annotated(len(self.pages) - 1, name))
        self.links.append(element)
        return len(self.links) - 1

    def turn(self) -> int:
        """The page is done; which it was, from 0."""
        self.pages.append([])
        return len(self.pages) - 2


def tree_of(canvas: Any) -> Tree:
    """The tree that grows with this canvas."""
    found: Tree | None = canvas.__dict__.get("_vecpoly_tree")
    if found is None:
        found = canvas.__dict__["_vecpoly_tree"] = Tree()
    return found


@contextmanager
def marked(canvas: Any, tag: Tag) -> Iterator[None]:
    """What is drawn meanwhile is this element's."""
    begun = tree_of(canvas).begin(tag)
    canvas._code.extend(begun)
    yield
    canvas._code.extend(END for _ in begun)


@contextmanager
def artifact(canvas: Any, kind: str = ARTIFACT) -> Iterator[None]:
    """What is drawn meanwhile says nothing to who hears the page: rules, grounds, running heads."""
    canvas._code.append(kind)
    yield
    canvas._code.append(END)
