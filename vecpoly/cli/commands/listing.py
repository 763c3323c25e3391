"""vecpoly list: the library of problems, and the methods on file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

import typer

from ...words import Words, bare
from ..options import Lang, LangOption
from ..sources import group_told, source_told
from ..terminal import add, show, table

What = Annotated[Literal["problems", "methods"], typer.Argument(help="What to list.")]


def listing(what: What = "problems", lang: LangOption = "en") -> None:
    """List the library, its problems, design projects, searches and assignments, or the methods."""
    if what == "problems":
        _problems(lang)
    else:
        _methods(lang)


def _problems(lang: Lang) -> None:
    from ...problem.library import library, others

    names = {"zh": ("题号", "题目", "所在"), "en": ("id", "title", "in")}[lang]
    made = table("", [(name, "left") for name in names])
    for entry in library():
        add(made, (entry.id, bare(entry.title.of(lang)), entry.path.parent.name))
    show(made)
    names = {"zh": ("名称", "题目", "命令"), "en": ("name", "title", "command")}[lang]
    made = table("", [(name, "left") for name in names])
    for command, entry in others():
        add(made, (entry.id, bare(entry.title.of(lang)), f"vecpoly {command} {entry.id}"))
    show(made)


def _methods(lang: Lang) -> None:
    names = {
        "zh": ("步骤", "杆组或装置", "方法", "例题", "出处"),
        "en": ("stage", "group or device", "method", "example", "source"),
    }[lang]
    made = table("", [(name, "left") for name in names])
    for stage, group, title, example, source in _on_file(lang):
        add(made, (stage, group, bare(title.of(lang)), example, source_told(source, lang)))
    show(made)


def _on_file(lang: Lang) -> Iterator[tuple[str, str, Words, str, str]]:
    """Of each method its stage, what it is for, its title, its example and its source."""
    from ...methods.devices.registry import device_methods
    from ...methods.registry import methods
    from ...methods.synthesis.registry import design_methods

    for one in methods():
        yield one.stage.words.of(lang), group_told(one.group, lang), one.title, one.example, one.source
    for each in device_methods():
        yield Words("装置", "device").of(lang), each.device.kind, each.title, each.example, each.source
    for task in design_methods():
        yield Words("综合", "synthesis").of(lang), task.design.kind, task.title, task.example, task.source
