"""A reportlab document whose small objects share one compressed stream (PDF 1.5, ISO 32000-1, 7.5.7).

A structure tree is made of thousands of small dictionaries; each by itself would double the file.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any
from zlib import compress

from reportlab.pdfbase.pdfdoc import PDFArray, PDFDocument, PDFFile, PDFTrueTypeFont
from reportlab.pdfbase.pdfdoc import format as formatted

_STREAM = b"endstream\n"
_FACE = b"\x00\x01\x00\x00"  # with which a TrueType face begins
_FACES = 64  # that are kept packed, some 30 KB each
_QUICK = 2  # of nine: less than half the time of the usual six, for a file that is a twentieth larger


class Flate:
    """What reportlab packs streams with; the subset of a face that several documents share is packed once."""

    pdfname = "FlateDecode"

    def encode(self, text: str | bytes) -> bytes:
        """Packed."""
        data = text.encode() if isinstance(text, str) else text
        return _face(data) if data.startswith(_FACE) else compress(data, _QUICK)


_face = lru_cache(maxsize=_FACES)(compress)


class PackedDocument(PDFDocument):  # type: ignore[misc]
    """Streams stand by themselves, all else in one object stream; the cross-references are a stream too."""

    def format(self) -> bytes:
        """The whole file."""
        self.Reference(self.Catalog)
        self.Reference(self.info)
        file = PDFFile(self._pdfVersion)
        small: list[tuple[int, bytes]] = []
        places: dict[int, tuple[int, int, int]] = {}
        number = 0
        while (number := number + 1) in self.numberToId:  # formatting an object may make further ones
            text = formatted(_with_widths(self.idToObject[self.numberToId[number]]), self, toplevel=1)
            if text.endswith(_STREAM):
                places[number] = (1, _add(file, number, text), 0)
            else:
                places[number] = (2, 0, len(small))
                small.append((number, text.strip()))
        for held, (kind, _, index) in places.items():
            if kind == 2:
                places[held] = (2, number, index)
        places[number] = (1, _add(file, number, _object_stream(small)), 0)
        self._cross_references(file, number + 1, places)
        return bytes(file.format(self))

    def _cross_references(self, file: Any, number: int, places: dict[int, tuple[int, int, int]]) -> None:
        places = {0: (0, 0, 65535), **places, number: (1, file.offset, 0)}
        rows = b"".join(
            bytes([kind]) + place.to_bytes(4, "big") + index.to_bytes(2, "big")
            for _, (kind, place, index) in sorted(places.items())
        )
        root, info = (formatted(self.Reference(one), self).decode() for one in (self.Catalog, self.info))
        identity = self.ID().decode("latin-1").split("%")[0].strip()
        entries = f"/Type/XRef/Size {number + 1}/W[1 4 2]/Root {root}/Info {info}/ID {identity}"
        start = _add(file, number, _stream(entries, rows))
        file.add(f"startxref\n{start}\n%%EOF\n".encode())


def _with_widths(held: Any) -> Any:
    """The object; of a font the widths of its letters are told here, once for all documents that have the same:
    reportlab takes longer over them than over a page."""
    font = getattr(held, "content", held)
    if isinstance(font, PDFTrueTypeFont):
        font.Widths = _widths(tuple(font.Widths.sequence))
    return held


@lru_cache(maxsize=_FACES)
def _widths(values: tuple[float, ...]) -> bytes:
    return bytes(PDFArray(values).format(None))


def _add(file: Any, number: int, text: bytes) -> int:
    return int(file.add(b"%d 0 obj\n%sendobj\n" % (number, text)))


def _object_stream(small: list[tuple[int, bytes]]) -> bytes:
    offsets, at = [], 0
    for number, text in small:
        offsets.append(f"{number} {at}")
        at += len(text) + 1
    head = " ".join(offsets).encode() + b"\n"
    body = b"\n".join(text for _, text in small)
    return _stream(f"/Type/ObjStm/N {len(small)}/First {len(head)}", head + body)


def _stream(entries: str, content: bytes) -> bytes:
    packed = compress(content, _QUICK)
    return (
        f"<<{entries}/Filter/FlateDecode/Length {len(packed)}>>\nstream\n".encode("latin-1") + packed + b"\n" + _STREAM
    )
