"""--help in the language of the command: the English page as typer makes it, the Chinese one from the table of
`chinese`."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any
from unicodedata import east_asian_width

from typer.core import TyperCommand

from ..foundation.patterns import pattern
from .chinese import HELP, LABELS
from .tongue import tongue

_WIDTH = 80
_LABEL = pattern("|".join(rf"(?<![\w-]){re.escape(label)}(?!\w)" for label in LABELS))
_ANY = pattern(r"\{([^{}]+)\}(\.\.\.)?")  # {FILE...}...
_EXTRA = pattern(r"  \[(?P<said>[^\]]*)\]$")
_SAID = (("required", "必需"), ("env var: ", "环境变量："), ("default: ", "默认 "))


class Command(TyperCommand):
    """A command whose help is in the language of the command line."""

    def get_help(self, ctx: Any) -> str:
        """The help page."""
        return in_chinese(self, ctx) if tongue() == "zh" else super().get_help(ctx)


def in_chinese(command: Any, ctx: Any) -> str:
    """The Chinese help page of a command or of the whole program."""
    pieces = " ".join(command.collect_usage_pieces(ctx))
    page = [f"用法：{ctx.command_path} {_labelled(pieces)}", ""]
    for paragraph in HELP[english_of(command)].split("\n\n"):
        page += [*_wrapped(paragraph, 2), ""]
    records = [(param.param_type_name, param.get_help_record(ctx), param) for param in command.get_params(ctx)]
    for title, kind in (("参数", "argument"), ("选项", "option")):
        page += _section(
            title,
            [
                (_labelled(found[0]), _record(param, found[1]))
                for name, found, param in records
                if name == kind and found
            ],
        )
    shown = [
        (name, HELP[english_of(one)].split("\n\n")[0])
        for name, one in getattr(command, "commands", {}).items()
        if not one.hidden
    ]
    return "\n".join([*page, *_section("命令", shown)]).rstrip()


def english_of(command: Any) -> str:
    """A command's English help as it stands in the table: its paragraphs, in which a line may end anywhere."""
    paragraphs = inspect.cleandoc(command.help or "").split("\n\n")
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)


def _labelled(text: str) -> str:
    """What stands in place of values, in Chinese, without the types that a program would name."""
    return _LABEL.sub(lambda found: LABELS[found[0]], _ANY.sub(r"\1", text)).rstrip()


def _record(param: Any, record: str) -> str:
    """The Chinese of an option's help, with its default behind it."""
    found = _EXTRA.search(record)
    said = "；".join(found["said"].split("; ")) if found else ""
    for english, chinese in _SAID:
        said = said.replace(english, chinese)
    return HELP[param.help] + (f"（{said}）" if said else "")


def _section(title: str, rows: list[tuple[str, str]]) -> list[str]:
    if not rows:
        return []
    left = min(max(_columns(name) for name, _ in rows), 26) + 4
    lines = [f"{title}："]
    for name, text in rows:
        first, *rest = _wrapped(text, left)
        lines += [
            f"  {name}".ljust(left - 1) + " " + first.lstrip() if _columns(name) + 4 <= left else f"  {name}\n{first}",
            *rest,
        ]
    return [*lines, ""]


def _wrapped(text: str, indent: int) -> list[str]:
    """Lines of a Chinese text; a word of Latin letters is not broken, and no line begins with a stop."""
    lines, line = list[str](), ""
    for part in _parts(" ".join(text.split("\n")) if text.isascii() else text.replace("\n", "")):
        if line and _columns(line + part) > _WIDTH - indent and part not in "，。；：）、":
            lines, line = [*lines, line], ""
        line += part if line or part != " " else ""
    return [" " * indent + one.rstrip() for one in [*lines, line]]


def _parts(text: str) -> Iterator[str]:
    return (found[0] for found in re.finditer(r"[!-~]+| |.", text))


def _columns(text: str) -> int:
    return sum(2 if east_asian_width(sign) in "WF" else 1 for sign in text)
