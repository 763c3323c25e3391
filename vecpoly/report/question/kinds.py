"""What the vector equations of a solution are called on a question sheet."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...board.construction import Figure, Pane, Step, View
from ...words import Lang, Words
from .equations import named

_FRICTION = (Words("（计入摩擦）", ", with friction"), Words("（不计摩擦）", ", without friction"))
_OF, _LINK = Words("（{}）", " ({})"), Words("构件 {}", "link {}")
_WITH = Words("，含 ${}$", ", with ${}$")
_LINKS = Words("构件 {}", "links {}")
_BODIES = re.compile(r"(\d+(?:-\d+)*)(?: ideal)?")  # 2, or a group: 2-3-4
_REACTION = re.compile(r"R['′]?_\{\d(\d)[,}]")  # R_{12}, on link 2
IDEAL = "ideal"  # name of a polygon without friction


def kinds(steps: Sequence[Step], lang: Lang, figures: Sequence[Figure] = ()) -> list[str]:
    """The kind of each; where one part of the analysis has it with friction and without, which of them it is; of
    several of one kind, what each is for. figures: in which they are drawn."""
    told = [kind(step, lang) for step in steps]
    ideal = [isinstance(step.view, Pane) and step.view.name == IDEAL for step in steps]
    twice = {name for name, without in zip(told, ideal, strict=True) if without and told.count(name) > 1}
    told = [
        name + _FRICTION[without].of(lang) if name in twice else name for name, without in zip(told, ideal, strict=True)
    ]
    told = [
        _one_of(name, step, lang, figures) if told.count(name) > 1 else name
        for name, step in zip(told, steps, strict=True)
    ]
    alike = {name: [one for one, own in zip(steps, told, strict=True) if own == name] for name in told}
    return [
        _apart(name, step, alike[name], lang) if len(alike[name]) > 1 else name
        for name, step in zip(told, steps, strict=True)
    ]


def _one_of(name: str, step: Step, lang: Lang, figures: Sequence[Figure]) -> str:
    """The kind of one of several: with what it is for, or that of the figure in which it is drawn."""
    if whose := _whose(step, lang):
        return f"{name}{_OF.of(lang).format(whose)}"
    titles = (one.title for one in figures if isinstance(step.view, Pane) and step.view == Pane(one.view, one.name))
    title = next(titles, None)
    return name if title is None else _within(title, step, lang)


def _apart(name: str, step: Step, alike: Sequence[Step], lang: Lang) -> str:
    """The kind with the first term by which an equation differs from all others that are called so."""
    others = {symbol for one in alike if one is not step for symbol in _terms(one)}
    sole = next((symbol for symbol in _terms(step) if symbol not in others), None)
    return name if sole is None else f"{name}{_WITH.of(lang).format(sole)}"


def _terms(step: Step) -> Sequence[str]:
    return step.equation.symbols if step.equation is not None else ()


def _whose(step: Step, lang: Lang) -> str:
    """What an equation is for: a vector of motion, or the link on which forces act."""
    symbols = step.equation.symbols if step.equation is not None else ()
    if symbols and symbols[0][0] in "va":
        return f"${symbols[0]}$"
    pane = step.view.name if isinstance(step.view, Pane) and step.view.view is View.FORCE else ""
    if (bodies := _BODIES.fullmatch(pane)) is not None:
        return (_LINKS if "-" in bodies[1] else _LINK).of(lang).format(bodies[1])
    acting = next((found for symbol in symbols if (found := _REACTION.match(symbol))), None)
    return _LINK.of(lang).format(acting[1]) if acting else ""


def kind(step: Step, lang: Lang) -> str:
    """Velocity equation; With friction: equilibrium of forces. An analysis of velocities need not be told beside it."""
    part, name = step.section.of(lang), named(step.view).of(lang)
    return name if part[:2] == name[:2] else _within(step.section, step, lang)


def _within(part: Words, step: Step, lang: Lang) -> str:
    """An equation of a part of the analysis, or of a figure."""
    name = named(step.view)
    if lang == "zh":
        return f"{part.zh}{'，' if '：' in part.zh else '：'}{name.zh}"
    return f"{part.en}{',' if ':' in part.en else ':'} {name.en[0].lower()}{name.en[1:]}"
