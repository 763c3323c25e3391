"""The structure tree of a PDF, read by another library than the one that wrote it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from io import BytesIO
from typing import Any

import pikepdf

PAINT = frozenset(["Tj", "TJ", "'", '"', "f", "F", "f*", "S", "s", "B", "B*", "b", "b*", "Do", "sh"])
ARTIFACT = "an artifact"


@dataclass(frozen=True, slots=True)
class Piece:
    """Marked content: page and number."""

    page: int
    number: int


class Read:
    """A tagged document."""

    def __init__(self, data: bytes) -> None:
        self.pdf = pikepdf.open(BytesIO(data))
        self.numbers = {page.obj.objgen: i for i, page in enumerate(self.pdf.pages)}
        self.root = self.pdf.Root.StructTreeRoot

    @cached_property
    def elements(self) -> tuple[Any, ...]:
        """Every element, as it is read."""
        return tuple(self._below(self.root))

    def _below(self, element: Any) -> Iterator[Any]:
        for kid in kids(element):
            if isinstance(kid, pikepdf.Dictionary) and "/S" in kid:
                yield kid
                yield from self._below(kid)

    def of(self, role: str) -> list[Any]:
        """The elements of this kind."""
        return [one for one in self.elements if f"/{role}" == one.S]

    @cached_property
    def told(self) -> tuple[Piece, ...]:
        """All marked content of the tree, as it is read."""
        return tuple(self._told(self.root))

    def _told(self, element: Any) -> Iterator[Piece]:
        for kid in kids(element):
            if isinstance(kid, pikepdf.Dictionary) and "/S" in kid:
                yield from self._told(kid)
            else:
                yield from self._piece(element, kid)

    def own(self, element: Any) -> Iterator[Piece]:
        """The marked content that is this element's, and no other's in it."""
        for kid in kids(element):
            if not (isinstance(kid, pikepdf.Dictionary) and "/S" in kid):
                yield from self._piece(element, kid)

    def _piece(self, element: Any, kid: Any) -> Iterator[Piece]:
        if isinstance(kid, int):
            yield Piece(self.numbers[element.Pg.objgen], kid)
        elif kid.get("/Type") == "/MCR":
            yield Piece(self.numbers[kid.Pg.objgen], int(kid.MCID))

    def is_sheet(self, page: int) -> bool:
        """Whether no running head stands over it: a drawing sheet, a cover."""
        return b"/Subtype/Header" not in self.pdf.pages[page].obj.Contents.read_bytes()

    def painted(self, page: int) -> list[int | str]:
        """To what each mark on the page belongs: the number of its marked content, an artifact, or nothing."""
        out: list[int | str] = []
        for _, where in self._operators(page):
            out.append(where)
        return out

    def _operators(self, page: int) -> Iterator[tuple[str, int | str]]:
        stack: list[int | str] = []
        for one in pikepdf.parse_content_stream(self.pdf.pages[page]):
            name, operands = str(one.operator), one.operands
            if name in ("BDC", "BMC"):
                stack.append(stack[-1] if str(operands[0]) == "/Span" else _begun(operands))
                assert ARTIFACT not in stack or set(stack) == {ARTIFACT}, stack
            elif name == "EMC":
                stack.pop()
            elif name in PAINT:
                yield name, stack[-1] if stack else "nothing"
        assert not stack

    def parents(self) -> dict[int, Any]:
        """What the parent tree says of each key."""
        nums = list(self.root.ParentTree.Nums)
        return {int(key): value for key, value in zip(nums[::2], nums[1::2], strict=True)}


def _begun(operands: Any) -> int | str:
    if str(operands[0]) == "/Artifact":
        return ARTIFACT
    return int(operands[1].MCID)


def kids(element: Any) -> list[Any]:
    """What an element holds."""
    held = element.get("/K")
    if held is None:
        return []
    return list(held) if isinstance(held, pikepdf.Array) else [held]
