"""A number as written, with its digits: decimal points and commas, powers of ten, percent."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ...words import Words

_BODY = r"(?:\d[\d.,]*\d|\d)[.,]?|[.,]\d+"
_TIMES = r"10(?P<zeros>0*)(?!\s*(?:[\d^({]|[.,]\d|\*\*|[+-]\s*\d))"  # ×10, ×100: no power of ten that is told
_RAISED = r"10\s*(?:\^|\*\*)?\s*[({]?\s*(?P<power>[+-]?\d{1,2})\s*[)}]?"
NUMBER = re.compile(
    rf"(?P<sign>[+-]?)\s*(?P<body>{_BODY})"
    rf"(?:\s*[×x*·]\s*(?:{_TIMES}|{_RAISED})|[eE](?P<shifted>[+-]?\d{{1,2}})(?!\d))?"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Number:
    """value: as written, with its sign; signed: whether a sign stood there;
    last: one unit of the last digit; digits: significant ones.
    """

    value: float
    signed: bool
    last: float
    digits: int


def number(found: re.Match[str]) -> Number | Words:
    """The number of a match of NUMBER, or why it is none."""
    power = _power(found)
    body = _point(found["body"], led=power is not None)
    if isinstance(body, Words):
        return body
    decimals = len(body.partition(".")[2])
    significant = body.replace(".", "").lstrip("0")
    sign = -1.0 if found["sign"] == "-" else 1.0
    return Number(
        value=sign * float(f"{body}e{power or 0}"),
        signed=bool(found["sign"]),
        last=float(f"1e{(power or 0) - decimals}"),
        digits=len(significant),
    )


def _power(found: re.Match[str]) -> int | None:
    """The power of ten that stands behind a number: of ×100 the second; None where there is none."""
    if found["zeros"] is not None:
        return 1 + len(found["zeros"])
    told = found["power"] or found["shifted"]
    return int(told) if told else None


def _point(body: str, *, led: bool) -> str | Words:
    """The digits with a decimal point; a comma is one only where it can be nothing else: `led`, before a power of
    ten, it parts no thousands."""
    commas, points = body.count(","), body.count(".")
    if commas and points:
        return _mixed(body)
    if points > 1:
        return _refused(body)
    if not commas:
        return body
    whole, _, rest = body.partition(",")
    if commas > 1:
        return body.replace(",", "") if _grouped(body, ",") else _refused(body)
    if len(rest) == 3 and not led and whole.lstrip("0") and len(whole) <= 3:
        return Words(
            f"“{body}”中的逗号是小数点还是千位分隔符，无从判断",
            f"the comma of '{body}' may be a decimal one or one of thousands",
        )
    return f"{whole}.{rest}"


def _mixed(body: str) -> str | Words:
    """1,234.5 and 1.234,5: the last one is the decimal one, and stands once."""
    decimal, group = (".", ",") if body.rfind(".") > body.rfind(",") else (",", ".")
    whole, _, rest = body.partition(decimal)
    return f"{whole.replace(group, '')}.{rest}" if _grouped(whole, group) and group not in rest else _refused(body)


def _grouped(whole: str, sign: str) -> bool:
    return re.fullmatch(rf"\d{{1,3}}(?:{re.escape(sign)}\d{{3}})+", whole) is not None


def _refused(body: str) -> Words:
    return Words(f"“{body}”不是一个数", f"'{body}' is not one number")
