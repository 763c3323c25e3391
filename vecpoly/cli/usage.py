"""A command line that cannot be read, told in Chinese:
an unknown option, a missing argument, a value of the wrong kind."""

from __future__ import annotations

import re
from typing import Any

import typer

UsageError: type[Exception] = typer.BadParameter.__mro__[1]

_SAID = tuple(
    (re.compile(english), chinese)
    for english, chinese in (
        (
            r"No such option:? '?([^'\s]+?)'?(?:\.)?(?:[ (]*(?:Did you mean|Possible options:) (.+?)\)?\??)?",
            "没有选项 {0}{1}",
        ),
        (r"No such command '(.+?)'\.(?: Did you mean (.+?)\??)?", "没有命令“{0}”{1}"),
        (r"Missing (?:argument|option|parameter):? ?'(.+?)'\.?.*", "缺少参数 {0}"),
        (
            r"Invalid value for '(.+?)': (?:Value error, )?'?(.+?)'? is not one of (.+?)\.?",
            "{0} 的值无效：“{1}”应为 {2} 之一",
        ),
        (r"Invalid value for '(.+?)': (.+?) is not in the range (.+?)\.?", "{0} 的值无效：{1} 不在范围 {2} 内"),
        (
            r"Invalid value for '(.+?)': '?(.+?)'? is not a valid (?:int|integer|float)(?: range)?\.?",
            "{0} 的值无效：“{1}”不是数",
        ),
        (r"Invalid value for '(.+?)': Input should be greater than or equal to (.+)", "{0} 的值无效：不得小于 {1}"),
        (r"Invalid value for '(.+?)': Input should be less than or equal to (.+)", "{0} 的值无效：不得大于 {1}"),
        (r"Invalid value for '(.+?)': Input should be a valid (?:integer|number).*", "{0} 的值无效：应为数"),
        (r"Invalid value for '(.+?)': (.+)", "{0} 的值无效：{1}"),
        (r"Option '(.+?)' requires an argument\.?", "选项 {0} 之后缺少值"),
        (r"Got unexpected extra arguments? \((.+)\)\.?", "多余的参数：{0}"),
    )
)


_PLAIN = (  # what the reader of options says of values, as an English sentence
    (re.compile(r"^Value error, "), ""),
    (re.compile(r"^Input should be greater than or equal to "), "it must not be below "),
    (re.compile(r"^Input should be less than or equal to "), "it must not be above "),
    (re.compile(r"^Input should be a valid integer.*"), "a whole number is expected."),
    (re.compile(r"^Input should be a valid number.*"), "a number is expected."),
)


def in_plain_english(error: Any) -> None:
    """The same error without the jargon of the library that reads options."""
    for pattern, plain in _PLAIN:
        error.message = pattern.sub(plain, error.message)


def in_chinese(error: Any) -> str:
    """What is wrong with the command line, and where to read how it is written."""
    english = error.format_message()
    ctx = error.ctx
    command = (ctx.command_path if ctx is not None else "").partition(" ")[2]
    return f"vecpoly: {_said(english)}；用 {' '.join(filter(None, ('vecpoly --lang zh', command, '--help')))} 查看用法"


def _said(english: str) -> str:
    for pattern, chinese in _SAID:
        if found := pattern.fullmatch(english):
            groups = [group or "" for group in found.groups()]
            if "Did you mean" in pattern.pattern and groups[1]:
                groups[1] = f"（是否指 {groups[1].strip(chr(39))}？）"
            return chinese.format(*groups)
    return f"命令行有误（{english}）"
