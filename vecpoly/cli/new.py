"""vecpoly new: a commented problem file to start from."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from .files import parent_of
from .terminal import say

_ID = re.compile(r"[A-Za-z0-9][\w.\-]*", re.ASCII)
_STEM = "my-problem"
NewFile = Annotated[Path, typer.Argument(metavar="FILE", help="The file to write; .yaml is added where it has no ending.")]


def new(path: NewFile) -> None:
    """Write a commented problem file to start from."""
    from ..problem.template import template_text

    target = parent_of(path if path.suffix else path.with_suffix(".yaml"))
    text = template_text().replace(f"{_STEM}.yaml", target.name)
    if _ID.fullmatch(target.stem):
        text = text.replace(f"id: {_STEM}", f"id: {target.stem}", 1)
    try:
        with target.open("x", encoding="utf-8", newline="\n") as file:
            file.write(text)
    except FileExistsError:
        raise FileExistsError(17, "exists already and is not overwritten; choose another name", str(target)) from None
    say(f"wrote {target}; now try: vecpoly solve {target}")
