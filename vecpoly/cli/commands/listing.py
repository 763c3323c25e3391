"""vecpoly list: the library of problems, and the methods on file."""

from __future__ import annotations

from typing import Annotated, Literal

import typer

from ...words import bare
from ..options import Lang, LangOption
from ..terminal import add, show, table

What = Annotated[Literal["problems", "methods"], typer.Argument(help="What to list.")]


def listing(what: What = "problems", lang: LangOption = "en") -> None:
    """List the library of problems, or the methods."""
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
    from ...methods.devices.registry import device_methods
    from ...methods.registry import methods
    from ...methods.synthesis.registry import design_methods

    names = {
        "zh": ("步骤", "杆组或装置", "方法", "例题", "出处"),
        "en": ("stage", "group or device", "method", "example", "source"),
    }[lang]
    made = table("", [(name, "left") for name in names])
    for method in methods():
        add(
            made,
            (method.stage.words.of(lang), method.group, bare(method.title.of(lang)), method.example, method.source),
        )
    for one in device_methods():
        add(
            made,
            ({"zh": "装置", "en": "device"}[lang], one.device.kind, bare(one.title.of(lang)), one.example, one.source),
        )
    for task in design_methods():
        add(
            made,
            (
                {"zh": "综合", "en": "synthesis"}[lang],
                task.design.kind,
                bare(task.title.of(lang)),
                task.example,
                task.source,
            ),
        )
    show(made)
