"""Which column of a table holds whose number, name and class, by its head."""

from __future__ import annotations

import re
import unicodedata

NUMBER = (
    "学号", "学生编号", "学生学号", "考号", "number", "student number", "student no", "student id", "id", "no",
    "matriculation",
)  # fmt: skip
NAME = ("姓名", "学生姓名", "名字", "name", "student name", "full name")
TEAM = (
    "班级", "班", "行政班", "行政班级", "教学班", "教学班级", "班级名称", "所在班级", "班名",
    "class", "class name", "group", "team", "section",
)  # fmt: skip
_ASIDE = re.compile(r"[(\[【〔].*?[)\]】〕]")  # 姓名（汉字）, Name [as on the card]


def bare(head: str) -> str:
    """A head by which it is known: without blanks, case, and what is said aside."""
    text = unicodedata.normalize("NFKC", head).lower()
    return _squeezed(_ASIDE.sub("", text)) or _squeezed(text)


def is_one(head: str, known: tuple[str, ...]) -> bool:
    """Whether this is one of these heads, however it is spaced."""
    return bare(head) in {_squeezed(one) for one in known}


def _squeezed(text: str) -> str:
    return "".join(text.replace("_", "").split()).strip(".:*")
