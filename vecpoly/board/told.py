"""A construction as a readable list: its steps, and under each the acts with what they gave and what they needed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, assert_never

from ..quantity import number
from ..words import Lang
from . import acts as done
from .acts import Act

if TYPE_CHECKING:
    from .construction import Construction

WIDE = 34  # characters of the column of what is done


def told(construction: Construction, lang: Lang = "zh") -> str:
    """Steps and acts, one a line; lengths and places in mm on paper."""
    return "\n".join(_lines(construction, lang))


def _lines(construction: Construction, lang: Lang) -> Iterator[str]:
    acts = construction.acts
    for step in construction.steps:
        yield f"{step.number}. {_bare(step.words.of(lang))}"
        for act in acts:
            if act.head.step == step.number and (line := _line(act, lang)):
                needed = ", ".join(dict.fromkeys(acts[n].key or str(n) for n in act.inputs))
                yield f"   {act.number:4d}  {line:{WIDE}s}{'  ← ' + needed if needed else ''}".rstrip()


def _line(act: Act, lang: Lang) -> str:
    """What was done and what it gave; nothing for acts that only leave ink."""
    named = _NAMES[type(act)][0 if lang == "zh" else 1]
    match act:
        case done.Locate() | done.Image():
            return f"{named} {act.key} ({_mm(act.at)})"
        case done.LayOff():
            return f"{named} {act.key} {number(act.mm)} mm"
        case done.Meet():
            return f"{named} ({_mm(act.at)})"
        case done.Measure():
            return f"{named} {act.key} = {number(act.mm)} mm"
        case done.Compute():
            return f"{named} {act.key} = {number(act.value)} {act.unit}".rstrip()
        case done.Answer():
            value = number(act.value.real) if not isinstance(act.value, complex) else number(abs(act.value))
            return f"{named} {act.key} = {value} {act.unit}".rstrip()
        case done.Arrow() | done.Parallel() | done.Follow() | done.Transfer() | done.Touch():
            return f"{named} {act.key}" if act.key else ""
        case (done.Plot() | done.Join() | done.Turn() | done.Rule() | done.Swing() | done.Corner() | done.Tint() | done.Gauge() | done.Depict()):
            return ""
        case _:
            assert_never(act)


def _mm(at: complex) -> str:
    return f"{at.real:.2f}, {at.imag:.2f}"


def _bare(text: str) -> str:
    """A sentence without the signs of its symbols."""
    return text.translate({ord(sign): None for sign in "${}"})


_NAMES: dict[type, tuple[str, str]] = {
    done.Locate: ("定点", "point"), done.Image: ("作影像", "image"), done.LayOff: ("量取", "lay off"), done.Meet: ("交点", "meet"),
    done.Measure: ("量得", "measure"), done.Compute: ("计算", "compute"), done.Answer: ("结果", "answer"), done.Arrow: ("矢量", "vector"),
    done.Parallel: ("作方向线", "direction of"), done.Follow: ("沿已有矢量", "along"), done.Transfer: ("移画", "transfer"), done.Touch: ("作切线", "tangent"),
    done.Plot: ("", ""), done.Join: ("", ""), done.Turn: ("", ""), done.Rule: ("", ""), done.Swing: ("", ""), done.Corner: ("", ""),
    done.Tint: ("", ""), done.Gauge: ("", ""), done.Depict: ("", ""),
}  # fmt: skip
