"""The application: its commands, its errors, its exit codes."""

from __future__ import annotations

from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from .check import check
from .cycle import cycle
from .demo import demo
from .draw import draw
from .errors import REFUSED, tell, told
from .exact import exact
from .listing import listing
from .new import new
from .play import play
from .report import report
from .schema import schema
from .solve import solve
from .terminal import speak_utf8


class Commands(TyperGroup):
    """All commands under one roof: whatever one of them refuses is told in a line, never in a traceback."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        with told():
            return super().invoke(ctx)


app = typer.Typer(
    cls=Commands, name="vecpoly", no_args_is_help=True, add_completion=False, rich_markup_mode=None,
    pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]},
)  # fmt: skip


def _version(wanted: bool) -> None:
    if wanted:
        from .. import __version__

        typer.echo(f"vecpoly {__version__}")
        raise typer.Exit


@app.callback()
def vecpoly(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and leave.")
    ] = False,
) -> None:
    """Velocity, acceleration and force polygons, drawn to scale, from a problem file to a printed report."""


app.command("solve")(solve)
app.command("exact")(exact)
app.command("report")(report)
app.command("check")(check)
app.command("cycle")(cycle)
app.command("draw")(draw)
app.command("list")(listing)
app.command("play")(play)
app.command("new")(new)
app.command("schema")(schema)
app.command("demo")(demo)


def main() -> None:
    """Entry point of the command `vecpoly`."""
    speak_utf8()
    try:
        app(prog_name="vecpoly")
    except OSError as error:  # help and version are printed before a command runs
        tell(error)
        raise SystemExit(REFUSED) from None
