"""The application: its commands, its errors, its exit codes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from .classes.classes import classes
from .classes.grade import grade
from .classes.variants import variants
from .commands.check import check
from .commands.cycle import cycle
from .commands.demo import demo
from .commands.design import design
from .commands.draw import draw
from .commands.exact import exact
from .commands.export import export
from .commands.listing import listing
from .commands.new import new
from .commands.play import play
from .commands.report import report
from .commands.schema import schema
from .commands.search import search
from .commands.solve import solve
from .errors import REFUSED, tell, tell_as, told
from .help import Command, in_chinese
from .options import ErrorsOption, SaidLang
from .terminal import speak_utf8
from .tongue import speak, tongue


class Commands(TyperGroup):
    """All commands under one roof: whatever one of them refuses is told in a line, never in a traceback."""

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> Any:
        """Read the command line, its language first."""
        speak(args)
        with told():
            return super().make_context(info_name, args, parent, **extra)

    def invoke(self, ctx: Any) -> Any:
        """Run the command."""
        with told():
            return super().invoke(ctx)

    def get_help(self, ctx: Any) -> str:
        """The help page."""
        return in_chinese(self, ctx) if tongue() == "zh" else super().get_help(ctx)


app = typer.Typer(
    cls=Commands, name="vecpoly", no_args_is_help=True, rich_markup_mode=None,
    pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]},
)  # fmt: skip


def _version(wanted: bool) -> None:
    if wanted:
        from .. import __version__

        typer.echo(f"vecpoly {__version__}")
        raise typer.Exit


@app.callback()
def vecpoly(
    ctx: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and leave.")
    ] = False,
    lang: SaidLang = None,
    errors: ErrorsOption = "text",
) -> None:
    """Velocity, acceleration and force polygons, drawn to scale, from a problem file to a printed report."""
    if lang is not None:
        ctx.default_map = {name: {"lang": lang} for name in COMMANDS}
    tell_as(errors)


COMMANDS: dict[str, Callable[..., None]] = {
    "solve": solve,
    "exact": exact,
    "report": report,
    "design": design,
    "search": search,
    "check": check,
    "cycle": cycle,
    "draw": draw,
    "export": export,
    "list": listing,
    "play": play,
    "new": new,
    "variants": variants,
    "class": classes,
    "grade": grade,
    "schema": schema,
    "demo": demo,
}
for _name, _command in COMMANDS.items():  # in a word each, wrapped and not cut off in the middle
    _first = " ".join((_command.__doc__ or "").partition("\n\n")[0].split())
    app.command(_name, cls=Command, short_help=_first)(_command)


def main() -> None:
    """Entry point of the command `vecpoly`."""
    speak_utf8()
    try:
        app(prog_name="vecpoly")
    except OSError as error:  # help and version are printed before a command runs
        tell(error)
        raise SystemExit(REFUSED) from None
