"""How a vector equation is drawn, in a sentence: what is laid off from where, and which two lines meet."""

from __future__ import annotations

from itertools import dropwhile

from ...algebra.formula import adjoined
from ...board.construction import View
from ...names import At, Rel
from ...plane import nominal
from ...vector.close import NO_ARROW
from ...vector.equation import Equation, Term
from ...words import Words
from ..desk import POLE, Desk

_NOTHING = Words("", "")


def laid_off(desk: Desk, view: View, eq: Equation, to: At) -> Words:
    """From $p^′$ lay off $p^′ n_3^′$ ($C→D$) and through $n_3^′$ draw the perpendicular to $DC$; ...: they meet in
    $c^′$. Nothing of an equation that is closed otherwise than by one line on each side."""
    sides = [_side(desk, view, chain) for chain in (eq.left, eq.right)]
    if not all(side.zh for side in sides):
        return _NOTHING
    tip, (one, two) = f"${desk.tip_label(view, to)}$", sides
    zh, en = ("，", ", ") if not any(" lay off " in side.en for side in sides) else ("；", "; ")
    second = two.en.replace(" draw ", " ") if " draw " in one.en else two.en
    first = one.en[0].upper() + one.en[1:]
    return Words(f"{one.zh}{zh}{two.zh}；两线交于 {tip}。", f" {first}{en}{second}; they meet in {tip}.")


def _side(desk: Desk, view: View, chain: tuple[Term, ...]) -> Words:
    """The known vectors of one side, tip to tail, and the line of the unknown one through their end, wherever in the
    equation that stands."""
    here, laid = POLE[view], list[Words]()
    known, sought = [[term for term in chain if _is_known(term) is wanted] for wanted in (True, False)]
    if len(sought) != 1 or any(term.drawn for term in dropwhile(_is_known, chain)):
        return _NOTHING
    for term in known:
        if not isinstance(term.rel, Rel) or (not term.drawn and term.mm is None):
            return _NOTHING
        if term.drawn:
            here = _end_of(desk, view, term.rel.to)
        elif term.mm is not None and abs(float(nominal(term.mm))) > NO_ARROW:
            laid.append(_vector(here, term))
            here = term.tip
    line = _line(sought[0])
    if not here or not line.zh:
        return _NOTHING
    through = Words(f"过 ${here}$ 作{line.zh}", f"through ${here}$ draw {line.en}")
    if not laid:
        return through
    zh, en = "，".join(one.zh for one in laid), ", ".join(one.en for one in laid)
    return Words(f"{zh}，{through.zh}", f"{en} and {through.en}")


def _is_known(term: Term) -> bool:
    return not term.unknowns


def _end_of(desk: Desk, view: View, at: At) -> str:
    """The letter at the end of a point's vector; the pole where that is nothing, as lengths from there are told."""
    return desk.start_label(view, at) if abs(nominal(desk.tip(view, at))) > NO_ARROW else POLE[view]


def _vector(here: str, term: Term) -> Words:
    """From where to where a known vector is laid off, and which way it points."""
    way = (f"（{term.direction.zh}）", f" ({term.direction.en})")
    line = f"${adjoined(here, term.tip)}$"
    return Words(f"自 ${here}$ 作 {line}{way[0]}", f"from ${here}$ lay off {line}{way[1]}")


def _line(term: Term) -> Words:
    """The line of a vector of unknown size: the perpendicular to BC, the parallel to the guide."""
    if term.along is None or term.unknowns != 1:
        return _NOTHING
    (sign, zh), en = (term.direction.zh[:1], term.direction.zh[1:]), term.direction.en[1:]
    if sign not in ("⊥", "∥"):
        return _NOTHING
    is_word = not zh.startswith("$")
    kind = Words("垂线", "perpendicular") if sign == "⊥" else Words("平行线", "parallel")
    return Words(
        f"{zh if is_word else f' {_close(zh)} '}的{kind.zh}", f"the {kind.en} to {'the ' * is_word}{_close(en)}"
    )


def _close(letters: str) -> str:
    """$ BC$ without the thin space that follows a sign."""
    return letters.replace("$ ", "$", 1)
