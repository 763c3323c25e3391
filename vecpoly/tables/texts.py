"""A table of text: in UTF-8, UTF-16 or GB 18030, and its cells between commas, semicolons or tabs."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from io import StringIO

from ..errors import VecpolyError
from ..words import Words

_MARKED = (b"\xff\xfe", b"\xfe\xff")  # UTF-16, as "Unicode text" is saved


def decoded(data: bytes, name: str, kind: type[VecpolyError]) -> str:
    """The text. Raises an error of this kind where it is none, or in another encoding."""
    marked = data.startswith(_MARKED)
    if b"\0" in data and not marked:
        raise kind(Words(f"{name} 不是文本表格；请另存为 CSV", f"{name} is no table of text; save it as CSV"))
    for code in ("utf-16",) if marked else ("utf-8-sig", "gb18030"):
        try:
            return data.decode(code)
        except UnicodeDecodeError:
            continue
    raise kind(
        Words(
            f"{name} 的编码既非 UTF-8 也非 GB 18030；请另存为 UTF-8 编码的 CSV",
            f"{name} is neither UTF-8 nor GB 18030 text; save it as CSV in UTF-8",
        ),
        code="encoding",
    )


def separated(text: str, mark: str, name: str, kind: type[VecpolyError]) -> Iterator[list[str]]:
    """The cells of each row, whatever ends its lines; quotes may hold marks and new lines. Raises an error of this
    kind, with the line, for what cannot be read so."""
    rows = csv.reader(StringIO(text, newline=None), delimiter=mark)
    try:
        yield from rows
    except csv.Error as error:
        raise unreadable(name, rows.line_num, error, kind) from None


def unreadable(name: str, line: int, error: csv.Error, kind: type[VecpolyError]) -> VecpolyError:
    """The error for a line that is no row of a table."""
    return kind(
        Words(
            f"{name}，第 {line} 行：无法读取（{error}）；是否有未闭合的引号？",
            f"{name}, line {line}: it cannot be read ({error}); is there a quote that nothing closes?",
        )
    )
