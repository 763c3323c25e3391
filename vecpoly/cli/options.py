"""The options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from ..errors import VecpolyError
from ..foundation.stock import FormatName
from ..words import Words
from .completion import ids

Lang = Literal["zh", "en"]


def place(text: str) -> Path:
    """Where to write: anything but an empty text, which Python would take for this folder."""
    if not str(text).strip():
        raise VecpolyError(
            Words(
                "-o、--json 后面是空的；请写文件名，或用 - 表示标准输出",
                "the name after -o or --json is empty; name a file, or - for standard output",
            ),
            code="no output",
        )
    return Path(text)


JSON = (".json",)  # endings of what --json writes
Hand = Literal["exact", "drafting", "pencil"]
Style = Literal["solution", "question", "course"]

Problems = Annotated[
    list[str],
    typer.Argument(
        metavar="ID_OR_FILE...",
        help="Problems or assignments: ids such as 3-9, or files.",
        show_default=False,
        autocompletion=ids,
    ),
]
Documents = Problems
HandOption = Annotated[
    Hand,
    typer.Option("--hand", help="How accurately is drawn: exact; drafting (0.1 mm); pencil (0.5 mm, with scatter)."),
]
SeedOption = Annotated[int, typer.Option("--seed", min=0, help="Seed of the hand's scatter.")]
TableOption = Annotated[
    Path | None,
    typer.Option("--table", metavar="FILE", help="A printed table over the cycle, CSV or XLSX.", show_default=False),
]
ColumnsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--columns",
        metavar="HEADER=MEANING,...",
        show_default=False,
        help="What columns of the table hold: phi_5=rad, w3=omega_4, V=v_E[mm/s], remarks=- (left out).",
    ),
]
LangOption = Annotated[Lang, typer.Option("--lang", envvar="VECPOLY_LANG", help="Chinese or English.")]
JobsOption = Annotated[
    int,
    typer.Option("--jobs", "-j", min=0, max=256, help="Processes; as many as there are processors where 0 is said."),
]
OutsideOption = Annotated[
    bool,
    typer.Option(
        "--allow-outside", help="Read files that the problem file names outside its folder and the library, too."
    ),
]
SaidLang = Annotated[Lang | None, typer.Option("--lang", help="Chinese or English.", show_default=False)]
ErrorsOption = Annotated[
    Literal["text", "json"],
    typer.Option(
        "--errors",
        envvar="VECPOLY_ERRORS",
        help="How what is refused is told: as text, or as JSON, a line each, for programs.",
    ),
]
JsonOption = Annotated[
    Path | None,
    typer.Option(
        "--json",
        metavar="FILE|-",
        parser=place,
        help="Write JSON to this file, or to stdout with -.",
        show_default=False,
    ),
]
StyleOption = Annotated[
    Style,
    typer.Option(
        "--style",
        help="The solution; the question with blank frames to draw in; or the course report over the whole cycle.",
    ),
]
PlainOption = Annotated[
    bool, typer.Option("--plain", help="In black alone: for examinations, and for printers without colours.")
]
PaperOption = Annotated[
    FormatName | None, typer.Option("--paper", help="The format of the paper, in place of the problem's own (A4).")
]
OutOption = Annotated[
    Path | None,
    typer.Option(
        "-o",
        "--output",
        metavar="PATH|-",
        parser=place,
        help="File or folder to write, or - for standard output; missing folders are made.",
        show_default=False,
    ),
]
