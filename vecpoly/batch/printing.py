"""The sheets of a class, or of one of its shards, written in pieces that are the same wherever they are written."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from ..errors import VecpolyError
from ..foundation.data import data_dir
from ..words import Words
from .drawing import finished
from .register import Register, Sheet
from .run.runners import Runner
from .run.store import digest
from .run.tasks import Print, cut, own

PAGES = 10  # students of one task
Told = Callable[[Words, int, int], None]


def printed(
    register: Register, out: Path, run: Runner, told: Told, parts: Sequence[Sequence[Sheet]]
) -> tuple[dict[str, Any], dict[str, VecpolyError]]:
    """Layouts of the sheets that were written, and what went wrong with others.

    parts: the sheets of each shard; what a shard has written already is not written again.
    """
    mark = digest(["pages", register.vecpoly, _templates()])
    tasks = [Print(register=own(register, piece), mark=mark) for sheets in parts for piece in cut(sheets, PAGES)]
    results = finished(tasks, run, out, lambda done, of: told(Words("写作业", "writing sheets"), done, of))
    rows = [row for result in results for row in result]
    failed = {row["number"]: VecpolyError(Words(**row["error"])) for row in rows if "error" in row}
    return {row["number"]: row["layout"] for row in rows if "layout" in row}, failed


def _templates() -> list[str]:
    """The templates that lecturers edit: with others the pages are others."""
    return [file.read_text("utf-8") for file in sorted(data_dir("templates").glob("*.j2"))]
