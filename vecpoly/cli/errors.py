"""How a refusal sounds: 'vecpoly: ...' on stderr, exit code 2; 130 after Ctrl-C; silence where the reader went away.

What was drawn and is contradicted by the analysis is told in red, with an exit code of its own, 3.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import typer

from ..errors import VecpolyError
from .wording import bare

if TYPE_CHECKING:
    from ..words import Lang, Words

DISAGREES, REFUSED, SUSPECT, INTERRUPTED = 1, 2, 3, 130


@contextmanager
def told() -> Iterator[None]:
    """Turn the errors of a command into words and an exit code."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        _hush()
        raise typer.Exit(0) from None
    except (VecpolyError, OSError) as error:
        tell(error)
        raise typer.Exit(REFUSED) from None
    except KeyboardInterrupt:
        typer.echo("vecpoly: interrupted", err=True)
        raise typer.Exit(INTERRUPTED) from None


@contextmanager
def about(problem: str) -> Iterator[None]:
    """Whatever is refused inside names this problem."""
    try:
        yield
    except VecpolyError as error:
        raise type(error)(f"{problem}: {error}") from None


def tell(error: Exception) -> None:
    """One line on stderr for each thing that is wrong."""
    for line in worded(error).splitlines():
        typer.echo(f"vecpoly: {line}", err=True)


def worded(error: Exception) -> str:
    """What went wrong, with the file's name where there is one."""
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return str(error) or type(error).__name__


def _hush() -> None:
    """Let Python's own flush at exit go nowhere."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@dataclass(slots=True)
class Tally:
    """Several jobs of which some may fail: the others are still done, and every failure and every alarm is told at the end."""

    failed: list[Exception] = field(default_factory=list)
    alarms: list[str] = field(default_factory=list)

    @contextmanager
    def job(self) -> Iterator[None]:
        """One of them."""
        try:
            yield
        except BrokenPipeError:
            raise
        except (VecpolyError, OSError) as error:
            self.failed.append(error)

    def weigh(self, problem: str, warning: Words | None, lang: Lang) -> None:
        """Note the alarm that a solution raised, if it did."""
        if warning is not None:
            self.alarms.append(f"{problem}: {bare(warning.of(lang))}")

    def settle(self) -> None:
        """Tell the failures and the alarms, if there were any, and leave."""
        for error in self.failed:
            tell(error)
        for alarm in self.alarms:
            typer.secho(f"vecpoly: {alarm}", err=True, fg="red", bold=True)
        if self.failed or self.alarms:
            raise typer.Exit(SUSPECT if self.alarms else REFUSED)
