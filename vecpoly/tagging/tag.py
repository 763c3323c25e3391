"""What a piece of a page is to a reader: heading, paragraph, row of a table, formula, figure."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Role(StrEnum):
    """The standard structure types of ISO 32000-1, 14.8.4, of which our documents are made."""

    H1 = "H1"
    H2 = "H2"
    H3 = "H3"
    H4 = "H4"
    P = "P"
    DIV = "Div"
    LIST = "L"
    ITEM = "LI"
    LABEL = "Lbl"
    BODY = "LBody"
    TABLE = "Table"
    ROW = "TR"
    HEADER = "TH"
    CELL = "TD"
    CAPTION = "Caption"
    FIGURE = "Figure"
    FORMULA = "Formula"
    CONTENTS = "TOC"
    ENTRY = "TOCI"
    LINK = "Link"
    CODE = "Code"


@dataclass(frozen=True, slots=True, eq=False)
class Tag:
    """One element of the structure, wherever its pieces stand: two tags are never the same element.

    alt: what is said in its place; attributes: further entries of its dictionary, in the language of PDF.
    """

    role: Role
    within: Tag | None = None
    alt: str = ""
    attributes: str = ""


def cell(row: Tag, header: bool) -> Tag:
    """A cell of a row: a heading of its column, or data."""
    scope = "/A<</O/Table/Scope/Column>>" if header else ""
    return Tag(Role.HEADER if header else Role.CELL, row, attributes=scope)


def heading_of_row(row: Tag) -> Tag:
    """A cell that names what stands in its row."""
    return Tag(Role.HEADER, row, attributes="/A<</O/Table/Scope/Row>>")


def boxed(tag: Tag, x0: float, y0: float, x1: float, y1: float) -> Tag:
    """The tag with the rectangle of the page (pt) that its picture takes."""
    box = f"/A<</O/Layout/Placement/Block/BBox[{x0:.1f} {y0:.1f} {x1:.1f} {y1:.1f}]>>"
    return Tag(tag.role, tag.within, tag.alt, tag.attributes + box)
