"""How a refusal sounds: 'vecpoly: ...' on stderr, exit code 2; 130 after Ctrl-C; silence where the reader went away.

What was drawn and is contradicted by the analysis is told in red, with an exit code of its own, 3; so is, with 4, that
no linkage satisfies a synthesis: its sheet shows why.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import typer

from ..errors import Fault, VecpolyError
from ..foundation.data import data_dir
from ..foundation.running.system import of_system
from ..words import Words, bare, unmarked
from .tongue import told_in, tongue
from .usage import UsageError, in_chinese, in_plain_english

if TYPE_CHECKING:
    from ..problem.problem import Problem
    from ..words import Lang

DISAGREES, REFUSED, SUSPECT, UNSOLVABLE, INTERRUPTED = 1, 2, 3, 4, 130
Form = Literal["text", "json"]
_FORM: ContextVar[Form] = ContextVar("form", default="text")  # for the length of one command


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
    except UsageError as error:
        if tongue() != "zh":
            in_plain_english(error)
            raise
        typer.echo(in_chinese(error), err=True)
        raise typer.Exit(REFUSED) from None
    except KeyboardInterrupt:
        typer.echo(told_in(Words("vecpoly: 已中断", "vecpoly: interrupted")), err=True)
        raise typer.Exit(INTERRUPTED) from None


@contextmanager
def about(problem: Problem) -> Iterator[None]:
    """Whatever is refused inside names this problem: the place in its file, or its id where it is the library's."""
    try:
        yield
    except VecpolyError as error:
        raise _placed(error, problem) from None


def _placed(error: VecpolyError, problem: Problem) -> VecpolyError:
    own = problem.path is not None and not problem.path.is_relative_to(data_dir("problems"))
    places = problem.written.places if own and problem.written is not None else {}
    path = next(((key,) for key in error.about if (key,) in places), None)
    if path is None or any(fault.place for fault in error.faults):
        return error.led_by(Words(f"{problem.id}：", f"{problem.id}: "))
    return error.at(places[path], *path)


def tell_as(form: Form) -> None:
    """How what is refused is told from now on, in this command."""
    _FORM.set(form)


def tell(error: Exception) -> None:
    """One line on stderr for each thing that is wrong; or one line of JSON, for programs."""
    if _FORM.get() == "json":
        typer.echo(json.dumps(as_json(error), ensure_ascii=False), err=True)
        return
    for line in unmarked(told_in(worded(error))).splitlines():
        typer.echo(f"vecpoly: {line}", err=True)


def as_json(error: Exception) -> dict[str, Any]:
    """A refusal as plain data: its kind, and each fault with code, place, path, numbers, texts and remedy."""
    faults = error.faults if isinstance(error, VecpolyError) else (Fault(said=worded(error), code="file"),)
    return {"error": type(error).__name__, "faults": [fault.as_json() for fault in faults]}


def worded(error: Exception) -> Words:
    """What went wrong, with the file's name where there is one."""
    if isinstance(error, VecpolyError) and str(error):
        return error.words
    if isinstance(error, OSError) and error.strerror:
        at = Words(f"{error.filename}：", f"{error.filename}: ") if error.filename else Words.same("")
        return at + of_system(error)
    return Words.same(str(error) or type(error).__name__)


def _hush() -> None:
    """Let Python's own flush at exit go nowhere."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@dataclass(slots=True)
class Tally:
    """Several jobs of which some may fail: the others are still done,
    and every failure and every alarm is told at the end."""

    failed: list[Exception] = field(default_factory=list)
    alarms: list[str] = field(default_factory=list)
    without: list[str] = field(default_factory=list)

    @contextmanager
    def job(self) -> Iterator[None]:
        """One of them."""
        try:
            yield
        except BrokenPipeError:
            raise
        except (VecpolyError, OSError) as error:
            self.failed.append(error)

    def weigh(self, problem: str, warning: Words | None, lang: Lang, conclusion: Words | None = None) -> None:
        """Note the alarm that a solution raised, if it did; or that no linkage satisfies what a synthesis asks."""
        for noted, words in ((self.alarms, warning), (self.without, conclusion)):
            if words is not None:
                noted.append(f"{problem}: {bare(words.of(lang))}")

    def settle(self) -> None:
        """Tell the failures, the alarms and the tasks without a solution, if there were any, and leave with the code of
        the gravest."""
        for error in self.failed:
            tell(error)
        for alarm in self.alarms:
            typer.secho(f"vecpoly: {alarm}", err=True, fg="red", bold=True)
        for told in self.without:
            typer.echo(f"vecpoly: {told}", err=True)
        if self.failed or self.alarms or self.without:
            raise typer.Exit(SUSPECT if self.alarms else REFUSED if self.failed else UNSOLVABLE)
