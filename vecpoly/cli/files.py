"""Where a command writes: a file, whole or not at all; '-', which is standard output; a pipe or a device."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import VecpolyError
from ..foundation.files import is_special, write_whole
from ..words import Words
from .terminal import wrote

if TYPE_CHECKING:
    from ..problem.problem import Problem

STDOUT = Path("-")


def spared(
    target: Path | None, endings: Sequence[str], problems: Iterable[Problem] = (), more: Iterable[Path] = ()
) -> Path | None:
    """The place to write to, once its ending is one of these and it is none of the files that are read.

    Raises VecpolyError before any work is done.
    """
    if target is None or target == STDOUT or is_special(target):
        return target
    if target.suffix.lower() not in endings and not target.is_dir():
        raise VecpolyError(
            Words(
                f"{target}：此处写出的是 {_either(endings, '、', ' 或 ')} 文件；文件名应以此结尾",
                f"{target}: what is written here is {_either(endings, ', ', ' or ')}; end the file's name so",
            ),
            code="ending",
        )
    for read in (*(file for problem in problems for file in problem.files), *more):
        if target.exists() and read.exists() and target.samefile(read):
            raise VecpolyError(
                Words(
                    f"{target}：这是要读取的文件，写入会毁掉它；请另取输出文件名",
                    f"{target}: is read by this command, and writing would destroy it; name another file",
                ),
                code="output is input",
            )
    return target


def _either(names: Sequence[str], comma: str, last: str) -> str:
    """'.svg, .png or .pdf'."""
    return last.join([comma.join(names[:-1]), names[-1]] if len(names) > 1 else names)


def put(target: Path, data: bytes) -> None:
    """Write, and say so; to standard output where the place is '-'."""
    if target == STDOUT:
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        sys.stdout.flush()
    else:
        wrote(write_whole(target, data))


def write_json(data: Any, where: Path) -> None:
    """JSON to a file or to standard output. NaN and infinity are no JSON;
    raises VecpolyError with the place of such a value."""
    for path in _endless(data, ""):
        raise VecpolyError(
            Words(
                f"{path} 不是有限数，JSON 无法表示；请看不带 --json 的结果",
                f"{path} is not finite, which JSON cannot say; look at it without --json",
            ),
            code="not finite",
        )
    text = json.dumps(data, ensure_ascii=False, indent=2, allow_nan=False) + "\n"
    if where == STDOUT:
        put(where, text.encode())
    else:
        write_whole(where, text.encode())


def _endless(data: Any, path: str) -> Iterable[str]:
    """Where NaN or infinity stands."""
    match data:
        case dict():
            for key, value in data.items():
                yield from _endless(value, f"{path}.{key}".lstrip("."))
        case list() | tuple():
            for i, value in enumerate(data):
                yield from _endless(value, f"{path}[{i}]")
        case float() if not isfinite(data):
            yield path
        case _:
            return
