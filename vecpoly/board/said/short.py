"""What is too short on paper to be measured: the step says so, and so does whoever tells the answer."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from ...algebra.formula import adjoined, letters_node, plain
from ...algebra.quantity import number
from ...algebra.rounding import in_tenths
from ...foundation.slotted import dataclass, replace
from ...words import Words
from ..construction import Reading, Scale, Step
from ..ruler import READABLE

FINEST = 0.05  # mm: what is shorter a rule shows as nothing
WORKED = 2  # equals signs of a line that tells how its result was found
MOST = 4  # lengths of a step that are named
TOO_SHORT = Words("过短，量取不可靠", "too short to be measured reliably")


@dataclass(frozen=True, slots=True, kw_only=True)
class Short:
    """A length (mm) that was read though it is too short: in which step, by its letters, at which scale."""

    step: int
    letters: str
    mm: float
    scale: Scale | None


def is_short(reading: Reading) -> bool:
    """Whether an answer was read off a length that is too short to be measured; one that vanishes is none, nor one that
    was computed and only laid off."""
    return reading.mm is not None and too_short(abs(reading.mm)) and _read(reading)


def too_short(mm: float) -> bool:
    """Whether a length shows on a rule, and is too short to be measured with it; what reads as 3.0 mm is not."""
    return FINEST <= mm < READABLE - FINEST


def _read(reading: Reading) -> bool:
    """Whether its line starts from the length on paper; of one without a way to its result it is taken to."""
    text = "" if reading.formula is None else plain(reading.formula)
    return text.count(" = ") < WORKED or reading.scale in text


def laid(mm: float) -> str:
    """A length that is laid off: 15.0, or what is less than a rule has."""
    return in_tenths(mm) if abs(mm) >= FINEST else number(mm, 1)


def about(mm: float) -> str:
    """A length that is hardly to be read: ≈ 1.3 mm."""
    return f"≈ {mm:.1f} mm"


def remarked(steps: Sequence[Step], short: Iterable[Short]) -> tuple[Step, ...]:
    """The steps, each with what was too short of the lengths that its lines or its table use."""
    found = dict[int, list[Short]]()
    for one in short:
        found.setdefault(_read_in(one, steps), []).append(one)
    return tuple(_with(step, found.get(step.number, [])) for step in steps)


def _read_in(one: Short, steps: Sequence[Step]) -> int:
    """The step whose lines use the length: an answer is read off the finished drawing, and its line stands earlier."""
    used = re.compile(rf"(?<![\w′^]){re.escape(plain(letters_node(one.letters)))}(?![\w′^])")
    lines = {step.number: any(used.search(plain(line)) for line in step.formulas) for step in steps}
    if lines.get(one.step) or any(step.listing for step in steps if step.number == one.step):
        return one.step
    return next((number for number, uses in reversed(lines.items()) if uses), one.step)


def _with(step: Step, short: Sequence[Short]) -> Step:
    if not short or not (step.formulas or step.listing):
        return step
    zh, en = _said(short)
    words = step.words
    return replace(
        step,
        words=Words(
            f"{words.zh[:-1]}（{zh}）：" if words.zh.endswith("：") else f"{words.zh}（{zh}。）",
            f"{words.en[:-1]} ({en}):" if words.en.endswith(":") else f"{words.en} ({en[0].upper()}{en[1:]}.)",
        ),
    )


def _said(short: Sequence[Short]) -> tuple[str, str]:
    named = [f"{_named(one.letters)} {about(one.mm)}" for one in short[:MOST]]
    zh, en = "、".join(named), ", ".join(named)
    if len(short) > MOST:
        zh, en = f"{zh} 等 {len(short)} 处", f"{en} and others, {len(short)} in all"
    at = _scale(short)
    return (
        f"{f'按 {at}，' if at else ''}图上 {zh}{'' if len(short) > MOST else ' '}{TOO_SHORT.zh}",
        f"on paper {en}, {TOO_SHORT.en}{f' at {at}' if at else ''}",
    )


def _named(letters: str) -> str:
    """The length by its ends; numbers of stations run together: 16–16′, where 1616′ would be one."""
    ends = letters.split()
    return "–".join(ends) if ends[0].isdigit() else f"${adjoined(*ends)}$"


def _scale(short: Sequence[Short]) -> str:
    """The scale that they have in common."""
    scales = {one.scale for one in short}
    scale = scales.pop() if len(scales) == 1 else None
    if scale is None or not scale.symbol or not scale.value:
        return ""
    return f"${scale.symbol}$ = {number(scale.told.value)} {scale.told.per_mm.replace('^2', '²')}"
