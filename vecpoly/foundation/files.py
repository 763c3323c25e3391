"""Files written whole or not at all: no half file, no stray one, no place turned into something else.

A new file is written without a name (O_TMPFILE) and named when it is whole. Where it takes the place of another, or
where the
system knows no such files, it stands beside its place for a moment under a name of ours; should we be killed in that
moment, the
next file written to that folder clears it away. Symbolic links are followed, an existing file keeps its permissions,
and what is
no regular file (a pipe, a device) is written straight into.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from errno import EISDIR, ENOTDIR
from pathlib import Path
from typing import BinaryIO

UNFINISHED, ENDING = ".vecpoly-", ".tmp"  # .vecpoly-1a2b3c4d.tmp: short, however long the name of the file is
ABANDONED = 60.0  # s since anything was written to an unfinished file: whoever wrote it is gone
PERMISSIONS = 0o666  # of a new file, less the umask
_DESCRIPTORS = "/proc/self/fd"


def folder_of(path: Path) -> Path:
    """The folder of a file, made where it is missing; raises NotADirectoryError where a file stands in its place."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        file = next(folder for folder in path.parents if folder.exists())
        raise NotADirectoryError(ENOTDIR, "is a file, not a folder; choose another place", str(file)) from None
    return path.parent


def is_special(path: Path) -> bool:
    """Whether a pipe, a terminal or a device stands here, into which one writes; /dev/stdout is one wherever it
    leads."""
    if path.exists() and path.is_absolute() and path.parts[1:2] in (("dev",), ("proc",)) and not path.is_dir():
        return True
    return path.exists() and not path.is_file() and not path.is_dir()


def write_whole(path: Path, data: bytes, *, new: bool = False) -> Path:
    """Put these bytes at this place, whole or not at all; `new`: only where nothing stands there.

    Raises IsADirectoryError for a folder, FileExistsError for what is there already, OSError naming this file for the
    rest.
    """
    with _about(path):
        if is_special(path) and not new:
            with os.fdopen(os.open(path, os.O_WRONLY | os.O_APPEND), "wb") as into:
                into.write(data)
            return path
        target = Path(os.path.realpath(path)) if path.is_symlink() and not new else path
        folder = folder_of(target)
        if target.is_dir():
            raise IsADirectoryError(EISDIR, "is a folder; name a file in it", str(path))
        _clear(folder)
        if not _written_nameless(target, data, new):
            _written_beside(target, data, new)
    return path


@contextmanager
def _about(path: Path) -> Iterator[None]:
    """What the system refuses inside is told of this file, not of an unfinished one."""
    try:
        yield
    except BrokenPipeError:
        raise
    except OSError as error:
        inner = error.filename if isinstance(error, NotADirectoryError) else None
        raise OSError(error.errno, error.strerror or str(error), inner or str(path)) from None


def _written_nameless(target: Path, data: bytes, new: bool) -> bool:
    """Written to a file without a name, which was then named; False where the system has no such files."""
    if not hasattr(os, "O_TMPFILE") or not Path(_DESCRIPTORS).is_dir():
        return False
    try:
        handle = os.open(target.parent, os.O_TMPFILE | os.O_WRONLY, PERMISSIONS)
    except OSError:  # an old or foreign file system; whatever else is wrong comes to light once more
        return False
    with os.fdopen(handle, "wb") as file:
        _fill(file, data, None if new else target)
        if not new and target.exists():
            return _replaced(handle, target)
        _named(handle, target)
    return True


def _replaced(handle: int, target: Path) -> bool:
    draft = _draft(target.parent)
    _named(handle, draft)
    draft.replace(target)
    return True


def _named(handle: int, path: Path) -> None:
    """Give a nameless file its name; linkat follows the descriptor only where a folder's descriptor is given too."""
    folder = os.open(path.parent, os.O_DIRECTORY | os.O_RDONLY)
    try:
        os.link(f"{_DESCRIPTORS}/{handle}", path.name, dst_dir_fd=folder)
    finally:
        os.close(folder)


def _written_beside(target: Path, data: bytes, new: bool) -> None:
    """Written under a name of ours, then moved to its place."""
    draft = _draft(target.parent)
    try:
        with os.fdopen(os.open(draft, os.O_CREAT | os.O_EXCL | os.O_WRONLY, PERMISSIONS), "wb") as file:
            _fill(file, data, None if new else target)
        if new:
            os.link(draft, target)
        else:
            draft.replace(target)
    finally:
        draft.unlink(missing_ok=True)


def _fill(file: BinaryIO, data: bytes, like: Path | None) -> None:
    """All bytes, and the permissions of the file whose place this one takes."""
    file.write(data)
    file.flush()
    if like is not None and like.exists() and hasattr(os, "fchmod"):
        os.fchmod(file.fileno(), stat.S_IMODE(like.stat().st_mode))


def _draft(folder: Path) -> Path:
    return folder / f"{UNFINISHED}{os.urandom(4).hex()}{ENDING}"


def _clear(folder: Path) -> None:
    """Take away what a run that was killed left here."""
    with suppress(OSError):
        for entry in os.scandir(folder):
            ours = entry.name.startswith(UNFINISHED) and entry.name.endswith(ENDING)
            if ours and time.time() - entry.stat(follow_symlinks=False).st_mtime > ABANDONED:
                Path(entry.path).unlink(missing_ok=True)
