"""Files written whole or not at all."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from errno import EISDIR, ENOTDIR
from pathlib import Path
from typing import Any

import typer


def parent_of(path: Path) -> Path:
    """The path, its folder made; a file that stands where the folder should be is named."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        file = next(folder for folder in path.parents if folder.exists())
        raise NotADirectoryError(ENOTDIR, "is a file, not a folder; choose another place", str(file)) from None
    return path


@contextmanager
def named(path: Path) -> Iterator[Path]:
    """The path, its folder made; what fails inside names this file, not a temporary one beside it."""
    target = parent_of(path)
    try:
        yield target
    except BrokenPipeError:
        raise
    except OSError as error:
        raise OSError(error.errno, error.strerror or str(error), str(path)) from None


def write_bytes(path: Path, data: bytes) -> Path:
    """Write beside the place, then move there: nobody ever sees half a file."""
    with named(path) as target:
        if target.is_dir():
            raise IsADirectoryError(EISDIR, "is a folder; name a file in it", str(target))
        handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".tmp", dir=target.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            Path(name).chmod(0o666 & ~_umask())
            Path(name).replace(target)
        finally:
            Path(name).unlink(missing_ok=True)
    return path


def write_text(path: Path, text: str) -> Path:
    """Text as UTF-8 with plain newlines, whole or not at all."""
    return write_bytes(path, text.encode())


def write_json(data: Any, where: str) -> None:
    """JSON to a file, or to stdout where it is '-'; NaN and infinity are no JSON and are refused."""
    text = json.dumps(data, ensure_ascii=False, indent=2, allow_nan=False) + "\n"
    if where == "-":
        typer.echo(text, nl=False)
    else:
        write_text(Path(where), text)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
