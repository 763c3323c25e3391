"""All bytes of a table."""

from __future__ import annotations

from pathlib import Path

from ..errors import VecpolyError
from ..limits import TABLE_BYTES
from ..words import Words


def bytes_of(path: Path, kind: type[VecpolyError]) -> bytes:
    """All bytes of the file. Raises an error of this kind for what is no regular file (a pipe, a device, a folder), or
    too large."""
    try:
        if not path.is_file():
            what = (
                Words("不存在这个文件", "No such file")
                if not path.exists()
                else Words(
                    "不是普通文件（而是文件夹、管道或设备）", "it is no regular file but a folder, a pipe or a device"
                )
            )
            raise kind(Words(f"{path}：{what.zh}", f"{path}: {what.en}"), code="no file")
        with path.open("rb") as file:
            data = file.read(TABLE_BYTES + 1)
    except OSError as error:
        raise kind(
            Words(
                f"{path}：不能读取（{error.strerror or type(error).__name__}）",
                f"{path}: {error.strerror or 'cannot be read'}",
            )
        ) from None
    return not_too_large(str(path), data, kind)


def not_too_large(name: str, data: bytes, kind: type[VecpolyError]) -> bytes:
    """The bytes. Raises an error of this kind where there are more than a table has."""
    if len(data) > TABLE_BYTES:
        raise too_much(name, Words(f"大于 {TABLE_BYTES / 1e6:g} MB", f"larger than {TABLE_BYTES / 1e6:g} MB"), kind)
    return data


def too_much(name: str, what: Words, kind: type[VecpolyError]) -> VecpolyError:
    """The error for a file that holds more than is read."""
    return kind(
        Words(
            f"{name}：{what.zh}，不予读取；请只保留需要的部分",
            f"{name}: {what.en}; it is not read: keep only what is needed",
        ),
        code="too large",
    )
