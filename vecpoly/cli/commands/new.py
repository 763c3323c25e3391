"""vecpoly new: a problem file to start from, commented or like one of the library."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from ...foundation.files import write_whole
from ...foundation.patterns import pattern
from ...words import Words
from ..files import put
from ..terminal import say
from ..tongue import told_in

_ID = pattern(r"\w[\w.\-]*")
_ID_LINE = pattern(r"^id:[ \t]*[\w.\-'\"]+", re.M)
_STEM, SCHEMA, _EDITOR = "my-problem", "vecpoly.schema.json", "# yaml-language-server: $schema="
Like = Annotated[
    str | None,
    typer.Option(
        "--like",
        metavar="ID",
        help="Start from a problem of the library: a screw jack from 5-5, forces from 4-3a.",
        show_default=False,
    ),
]
NewFile = Annotated[
    Path, typer.Argument(metavar="FILE", help="The file to write; .yaml is added where it has no ending.")
]


def new(path: NewFile, like: Like = None) -> None:
    """Write a problem file to start from: a commented one, or a copy of one of the library."""
    target = path if path.suffix else path.with_suffix(".yaml")
    text = _start(target) if like is None else _copy(like)
    if _ID.fullmatch(target.stem):
        text = _ID_LINE.sub(f"id: {target.stem}", text, count=1)
    text = text if _EDITOR in text else f"{_EDITOR}{SCHEMA}\n{text}"
    from ...problem.library import command_for

    try:
        write_whole(target, text.encode(), new=True)
    except FileExistsError:
        raise FileExistsError(17, "exists already and is not overwritten; choose another name", str(target)) from None
    _write_schema(target.with_name(SCHEMA))
    if like is not None:
        _write_tables(like, text, target)
    told = f"vecpoly {command_for(text)} {target}"
    say(told_in(Words(f"已写入 {target}；可接着运行：{told}", f"wrote {target}; now try: {told}")))


def _write_schema(path: Path) -> None:
    """The schema that the file's first line names, for editors; one that lies there already is left as it is."""
    if not path.exists():
        from .schema import schema_text

        put(path, schema_text().encode())


def _write_tables(name: str, text: str, target: Path) -> None:
    """The tables that a copied problem reads, beside the copy where it looks for them; what lies there already is left
    as it is."""
    from ...problem.library import command_for
    from ...problem.load import load, locate

    if command_for(text) != "solve":
        return
    home = locate(name).parent
    for file in load(name).files:
        copy = target.parent / file.relative_to(home) if file.is_relative_to(home) else target
        if file.suffix != ".yaml" and not copy.exists():
            put(copy, file.read_bytes())


def _start(target: Path) -> str:
    """The commented file, under the name it will have."""
    from ...problem.template import template_text

    return template_text().replace(f"{_STEM}.yaml", target.name)


def _copy(name: str) -> str:
    """The file of a problem as it stands, for another id."""
    from ...problem.load import locate

    return locate(name).read_text(encoding="utf-8")
