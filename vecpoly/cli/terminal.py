"""The terminal: UTF-8 everywhere, tables as wide as they need to be, progress only where somebody watches."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from io import TextIOWrapper
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeVar

import typer

from ..words import Lang, Words, bare
from .tongue import told_in

if TYPE_CHECKING:
    from rich.table import Table

_TRAILING = re.compile(r"[ ]+$", re.M)
Align = Literal["left", "right"]
T = TypeVar("T")


def speak_utf8() -> None:
    """Chinese and Greek letters on every platform's streams (Windows consoles and pipes default to a code page),
    closed ones going nowhere."""
    sys.stdout, sys.stderr = (stream or Path(os.devnull).open("w") for stream in (sys.stdout, sys.stderr))  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="replace")


def show(table: Table) -> None:
    """Print a table; in a pipe, with no frame cut off at 80 columns."""
    from rich.console import Console

    console = Console()
    watched = console.is_terminal
    if not watched:
        console = Console(width=200)
    title, table.title = table.title, None  # a line of its own: rich breaks it to the width of the table
    with console.capture() as shown:  # a reader that goes away is then our error, not rich's
        if title is not None:
            console.print(title, style=table.title_style or "", soft_wrap=True)
        console.print(table)
    typer.echo(shown.get() if watched else _TRAILING.sub("", shown.get()), nl=False)


def table(title: str, columns: Sequence[tuple[str, Align]]) -> Table:
    """An empty table in the style of the house."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    made = Table(
        title=Text(title) if title else None,
        title_justify="left",
        title_style="bold",
        box=box.SIMPLE_HEAD,
        pad_edge=False,
    )
    for name, justify in columns:
        made.add_column(Text(name), justify=justify)
    return made


def add(to: Table, cells: Iterable[str], *, alarmed: bool = False) -> None:
    """A row of plain text: square brackets are letters here, not markup;
    in red where it must not be taken for an answer."""
    from rich.text import Text

    to.add_row(*(Text(cell) for cell in cells), style="bold red" if alarmed else "")


def progress(items: Sequence[T], doing: Words) -> Iterator[T]:
    """The items, with a bar on stderr where a person watches and there is more than one."""
    if len(items) < 2 or not sys.stderr.isatty():
        yield from items
        return
    from rich.console import Console
    from rich.progress import track

    yield from track(items, description=told_in(doing), console=Console(stderr=True), transient=True)


@contextmanager
def working(doing: Words) -> Iterator[None]:
    """While something takes its time: a line on stderr that says what, where a person watches."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(f"{told_in(doing)} ..."):
        yield


def warn(problem: str, said: Iterable[Words], lang: Lang) -> None:
    """What is accepted but hardly meant, on stderr."""
    for words in said:
        typer.echo(
            f"vecpoly: {f'注意 {problem}：' if lang == 'zh' else f'note on {problem}: '}{bare(words.of(lang))}",
            err=True,
        )


def say(text: str) -> None:
    """A remark that is not part of the output."""
    typer.echo(text, err=True)


def wrote(path: object) -> None:
    """That a file was written."""
    say(told_in(Words(f"已写入 {path}", f"wrote {path}")))
