"""Templates that lecturers edit: filled in a sandbox, and their slips told with file and line."""

from __future__ import annotations

import traceback
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import ChoiceLoader, FileSystemLoader, StrictUndefined, TemplateError, TemplateNotFound, TemplateSyntaxError
from jinja2.exceptions import SecurityError
from jinja2.runtime import Context
from jinja2.sandbox import ImmutableSandboxedEnvironment

from ..errors import ReportTemplateError
from ..limits import POWER
from ..words import Words

BIG = 1e6  # a number in a template


class Sandbox(ImmutableSandboxedEnvironment):
    """Nothing behind what a template is given, nothing changed, and no product that fills the memory."""

    intercepted_binops = frozenset({"*", "**"})

    def call_binop(self, context: Context, operator: str, left: Any, right: Any) -> Any:
        """Products of numbers of a page's size only."""
        if not all(isinstance(one, int | float) and abs(one) < BIG for one in (left, right)) or (
            operator == "**" and abs(right) > POWER
        ):
            raise SecurityError(f"'{operator}' takes numbers below {BIG:g} (powers up to {POWER})")
        return super().call_binop(context, operator, left, right)


@cache
def environment(folders: tuple[Path, ...], escaped: bool = True) -> Sandbox:
    """Templates from these folders, the first that has one:
    no template reaches Python behind what it is given, or changes it."""
    loaders = [FileSystemLoader(folder) for folder in folders]
    return Sandbox(
        loader=ChoiceLoader(loaders),
        autoescape=escaped,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def filled(name: str, folders: Sequence[Path], context: Mapping[str, Any], escaped: bool = True) -> str:
    """The template with this name, filled. Raises ReportTemplateError with file and line where it is wrong,
    TemplateNotFound where there is none."""
    with _told(name):
        return environment(tuple(folders), escaped).get_template(name).render(context)


@contextmanager
def _told(name: str) -> Iterator[None]:
    try:
        yield
    except TemplateNotFound as missing:
        if str(missing) == name:
            raise
        raise ReportTemplateError(
            Words(
                f"模板 {name} 引用了不存在的模板 {missing}",
                f"template {name} includes a template that does not exist: {missing}",
            ),
            code="template",
        ) from None
    except TemplateSyntaxError as error:
        raise _wrong(error.filename or error.name or name, error.lineno, error.message or "") from None
    except (
        TemplateError,
        TypeError,
        AttributeError,
        ValueError,
        ArithmeticError,
        LookupError,
        RecursionError,
    ) as error:
        place = _place(error)
        if place is None:
            raise
        raise _wrong(*place, str(error)) from None


def _place(error: Exception) -> tuple[str, int] | None:
    """File and line of the template in which this was raised; None where our own code is at fault."""
    frames = traceback.extract_tb(error.__traceback__)
    inner = [frame for frame in frames if frame.filename.endswith(".j2")]
    return (inner[-1].filename, inner[-1].lineno or 0) if inner else None


def _wrong(file: str, line: int, said: str) -> ReportTemplateError:
    return ReportTemplateError(
        Words(
            f"模板 {file}，第 {line} 行：{said}；请改正模板",
            f"template {file}, line {line}: {said}; correct the template",
        ),
        code="template",
        numbers={"line": line},
    )
