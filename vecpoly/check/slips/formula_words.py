"""Slips in the terms of a formula, in words."""

from __future__ import annotations

from collections.abc import Sequence

from ...names import Kind
from ...words import Words
from ..table.target import Part, Target
from .formula import MISSING, ONCE, SIGN, TRIG, Slipped, Term


def told(target: Target, slipped: Sequence[Slipped]) -> Words:
    """The term l_BC ω_2 lacks its ω_2 and has φ_3 for φ_2 in its x component; the term l_CE ω_2 …"""
    parts = [_of_term(one, target.part in (Part.X, Part.Y)) for one in slipped]
    return Words("；".join(part.zh for part in parts), "; ".join(part.en for part in parts))


def _of_term(one: Slipped, whole: bool) -> Words:
    name = _name(one.term)
    zh, en = [], []
    for slip, where in sorted(one.slips, key=lambda pair: -len(pair[1])):
        words = _slip(one.term, slip)
        axis = "" if whole or len(where) > 1 else where
        zh.append(f"{axis} 分量{words.zh}" if axis else words.zh)
        en.append(f"{words.en} in its {axis} component" if axis else words.en)
    return Words(
        f"{name} 项{'，'.join(zh)}".replace("项x", "项 x").replace("项y", "项 y"), f"the term {name} {' and '.join(en)}"
    )


def _name(term: Term) -> str:
    return f"${term.bar.name} {_rate(term)}$"


def _rate(term: Term) -> str:
    return ("α" if term.kind is Kind.ALPHA else "ω") + f"_{{{term.bar.link}}}" + ("^2" if term.normal else "")


def _slip(term: Term, slip: str) -> Words:
    link, rate = term.bar.link, _rate(term)
    match slip:
        case _ if slip == MISSING:
            return Words(f"漏乘 ${rate}$", f"lacks its ${rate}$")
        case _ if slip == ONCE:
            return Words(f"误用 $ω_{{{link}}}$ 代替 ${rate}$", f"has $ω_{{{link}}}$ for ${rate}$")
        case _ if slip == SIGN:
            return Words("正负号相反", "has the wrong sign")
        case _ if slip == TRIG:
            return Words("正弦、余弦互换", "has sine and cosine interchanged")
    return Words(f"误用 $φ_{{{slip}}}$ 代替 $φ_{{{link}}}$", f"has $φ_{{{slip}}}$ for $φ_{{{link}}}$")
