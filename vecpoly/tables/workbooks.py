"""A workbook: whole, and no larger when it is unpacked than can be looked through."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from zipfile import BadZipFile, ZipFile

from ..errors import VecpolyError
from ..limits import TABLE_UNPACKED
from ..words import Words
from .files import too_much

WORKBOOKS = (".xlsx", ".xlsm")
# what openpyxl, zipfile and the XML parser raise for damaged workbooks
_DAMAGED = (
    OSError,
    ValueError,
    KeyError,
    IndexError,
    AttributeError,
    TypeError,
    ArithmeticError,
    EOFError,
    RuntimeError,
    SyntaxError,
    MemoryError,
    NotImplementedError,
    BadZipFile,
    zlib.error,
)


@contextmanager
def reading(name: str, data: bytes, kind: type[VecpolyError]) -> Iterator[None]:
    """While these bytes are read as a workbook: raises an error of this kind where they are none, are damaged, or would
    burst when unpacked."""
    try:
        _unpacks(name, data, kind)
        yield
    except _DAMAGED as error:
        if isinstance(error, kind):
            raise
        what = type(error).__name__
        raise kind(
            Words(
                f"{name} 不是 XLSX 工作簿，或已损坏（{what}）；请在电子表格程序中重新保存，或存为 CSV",
                f"{name} is no XLSX workbook, or damaged ({what}); save it again in a spreadsheet program, or as CSV",
            ),
            code="damaged",
        ) from None


def _unpacks(name: str, data: bytes, kind: type[VecpolyError]) -> None:
    with ZipFile(BytesIO(data)) as archive:
        size = sum(part.file_size for part in archive.infolist())
        for part in archive.infolist():
            if part.filename.endswith((".xml", ".rels")) and b"<!DOCTYPE" in archive.open(part).read(4096):
                raise kind(
                    Words(
                        f"{name}：{part.filename} 含有 DOCTYPE 声明，不予读取",
                        f"{name}: {part.filename} declares entities of its own (DOCTYPE) and is not read",
                    ),
                    code="entities",
                )
    if size > TABLE_UNPACKED:
        unpacked = Words(
            f"解压后 {size / 1e6:.0f} MB，大于 {TABLE_UNPACKED / 1e6:g} MB",
            f"{size / 1e6:.0f} MB when unpacked, more than {TABLE_UNPACKED / 1e6:g} MB",
        )
        raise too_much(name, unpacked, kind)
