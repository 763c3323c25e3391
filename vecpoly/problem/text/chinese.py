"""Sentences of joints, of a point's side and of a cam's motion in Chinese, as the English ones that the readers know:
``滑块 4 在构件 5 的槽中滑动`` is ``4 slides in 5``. What stands behind in English (``turned 60 deg``) stays."""

from __future__ import annotations

import re

from ...foundation.indices import LETTER
from ...foundation.patterns import pattern

_NOUNS = "(?:构件|滑块|滑枕|导杆|套筒|直杆|杆|齿轮|齿条|凸轮|推杆|从动件|活塞|圆盘|销|点)"
_NOUN = pattern(rf"{_NOUNS}\s*(?=[A-Z\d])")
_LINE = rf"[xy] = [-\d.]+ ?\w+|{LETTER}{LETTER}|line through {LETTER} at [-\d.]+ ?[\w°]+"
_EQUALS = pattern(r" ?= ?")
_THROUGH = pattern(rf"过 ?({LETTER}) ?点? ?与 ?x ?轴成 ?([-\d.]+ ?[a-z°]+)角? ?的?(?:直线|导路)")
_MEANT = (  # N: a link, P: a point, G: a line
    ("N 在 N 的? ?槽?[中内上] ?(?:滑动|移动)", r"\1 slides in \2"),
    ("N 沿 G ?(?:滑动|移动)", r"\1 slides on \2"),
    ("N 沿 N 的?(?:槽|导路)? ?(?:滑动|移动)", r"\1 slides on \2"),
    ("N 的 P 点? ?沿 G ?(?:滑动|移动)", r"\2 of \1 slides on \3"),
    ("P 在 N 的? ?槽?[中内] ?(?:滑动|移动)", r"\1 runs in \2"),
    ("N 穿过 N", r"\1 passes through \2"),
    ("N [与和] N 的? ?齿条 在 P 点?处? ?啮合", r"\1 rolls on the rack of \2 at \3"),
    ("N [与和] N 的? ?齿轮 在 P 点?处? ?外?啮合", r"\1 rolls on the gear of \2 at \3"),
    ("N [与和] N 在 P 点?处? ?外?啮合", r"\1 rolls on \2 at \3"),
    ("N [与和] N 在 P 点?处? ?内啮合", r"\1 rolls inside \2 at \3"),
    ("N 在 P 点?处? ?沿 G ?滚动", r"\1 rolls on \3 at \2"),
    ("N 在 P 点?处? ?沿 G ?上方滚动", r"\1 rolls above \3 at \2"),
    ("N 在 P 点?处? ?沿 G ?下方滚动", r"\1 rolls below \3 at \2"),
    ("N [与和] N 在 P 点?处? ?(?:外?接触|外切)", r"\1 touches \2 at \3"),
    ("N [与和] N 在 P 点?处? ?(?:内接触|内切)", r"\1 touches \2 inside at \3"),
)
_SPOKEN = {"N": r"(\d+[a-z']?)", "P": f"({LETTER})", "G": f"({_LINE})", " ": r"\s*"}
_BEHIND = r"(?P<behind>\s+(?:with|turned|left|right|above|below) .+)?"
_LAWS = {"等加速等减速": "parabolic", "等速": "uniform", "余弦": "cosine", "正弦": "sine", "3-4-5": "3-4-5"}
_WHAT = {"推程": "rise", "升程": "rise", "回程": "return", "远休": "dwell", "近休": "dwell", "停歇": "dwell"}
_SIDES = {"左": "left of", "右": "right of", "上": "above", "下": "below"}
_SIDE = pattern(rf"(?:在\s*)?({LETTER}{LETTER})\s*的?(左|右|上|下)[侧方边]")
_MOTION = pattern(
    rf"(?P<what>{'|'.join(_WHAT)})止?(?:\s*(?P<by>[\d.]+ ?(?:mm|cm|m|deg|°)))??\s*(?P<angle>[\d.]+ ?(?:deg|rad|°))"
    rf"(?:\s*(?P<law>{'|'.join(_LAWS)})(?:加速度)?(?:运动)?)?"
)


def _form(said: str, spoken: dict[str, str]) -> re.Pattern[str]:
    return pattern("".join(spoken.get(sign, sign) for sign in said) + _BEHIND)


_FORMS = tuple((_form(said, _SPOKEN), english) for said, english in _MEANT)
_LOOSE = _LINE.replace(" = ", " ?= ?")
_WRITTEN = {"N": rf"{_NOUNS}?\s*\d+[a-z']?", "P": rf"{_NOUNS}?\s*{LETTER}", "G": f"(?:{_LOOSE}|过.+)", " ": r"\s*"}
SENTENCES = tuple(_form(said, _WRITTEN) for said, _ in _MEANT)  # as they are written, for editors


def joint(text: str) -> str:
    """A sentence of a joint in English; as it is where it is none of these."""
    said = _THROUGH.sub(r"line through \1 at \2", _NOUN.sub("", _EQUALS.sub(" = ", text.strip())))
    for form, english in _FORMS:
        if found := form.fullmatch(said):
            return found.expand(english) + (found["behind"] or "")
    return text


def side(text: str) -> str:
    """On which side of a line a point lies, in English: ``BC 左侧`` is ``left of BC``."""
    found = _SIDE.fullmatch(text.strip())
    return text if found is None else f"{_SIDES[found[2]]} {found[1]}"


def motion(text: str) -> str:
    """An entry of a cam's motion in English: ``推程 30 mm 120° 余弦`` is ``rise 30 mm in 120° cosine``."""
    found = _MOTION.fullmatch(text.strip())
    if found is None:
        return text
    by, law = found["by"], found["law"]
    return f"{_WHAT[found['what']]}{f' {by}' if by else ''} in {found['angle']}{f' {_LAWS[law]}' if law else ''}"
