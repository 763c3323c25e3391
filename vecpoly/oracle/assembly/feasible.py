"""Where a mechanism can be assembled: ranges of the drive, and the refusal that tells them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ...errors import AssemblyError
from ...mechanism.model import Drive
from ...words import Words
from ..state import Reals
from ..steps import Step

Ranges = tuple[str, ...]
Spans = tuple[tuple[float, float], ...]
Closes = Callable[[Reals], NDArray[np.bool_]]
SAMPLES, HALVINGS = 1440, 40
WHOLE = 2 * np.pi
TOLD = 20  # halvings for ends that are told with two decimals
BESIDE = 1e-6  # rad, or m: just before and after a position
SEARCHED = 4.0  # scales to either side of a sliding drive's own position


def scan(closes: Closes, drive: Drive, scale: float, *, followed: bool) -> Ranges:
    """Ranges of the drive that close, as text: degrees from 0..360 on, or mm along the guide."""
    found = spans(closes, drive, scale, TOLD, followed=followed)
    return tuple(_text(*told_span(drive, low, high), drive.slide) for low, high in found)


def told_span(drive: Drive, low: float, high: float) -> tuple[float, float]:
    """A range as the problem tells the drive's angle, from 0..360° on (rad); a travel, or a whole turn, as it is."""
    if not drive.lead or high - low >= WHOLE * (1 - 1e-12):
        return low, high
    first = (low - drive.lead) % WHOLE
    return first, first + high - low


def spans(closes: Closes, drive: Drive, scale: float, halvings: int = HALVINGS, *, followed: bool = False) -> Spans:
    """Ranges of the drive (rad, or m along the guide) that close; followed: along a path from the own position.

    Sampled every quarter of a degree (or 1/180 of the scale within ±4 scales), ends refined by bisection. Angles begin
    within 0..360.
    """
    low, high = (drive.position - SEARCHED * scale, drive.position + SEARCHED * scale) if drive.slide else (0.0, WHOLE)
    if drive.slide and drive.between and drive.position > 0:
        low = max(low, 0.0)  # a cylinder has no negative length
    found = _closed(closes, low, high, halvings)
    if drive.slide or not found:
        return found
    first, last = found[0][0] == low, found[-1][1] == high
    if followed and first != last:
        return _beyond(closes, drive.position, halvings) or found
    if first and last and len(found) > 1:
        return (*found[1:-1], (found[-1][0], found[0][1] + WHOLE))  # one range across 0
    return found


def _closed(closes: Closes, low: float, high: float, halvings: int) -> Spans:
    """The ranges between these positions."""
    q = np.linspace(low, high, SAMPLES + 1)
    good = closes(q)
    change = np.flatnonzero(good[1:] != good[:-1])
    inside = np.where(good[change], q[change], q[change + 1])
    outside = np.where(good[change], q[change + 1], q[change])
    for _ in range(halvings if len(change) else 0):
        middle = (inside + outside) / 2
        fits = closes(middle)
        inside, outside = np.where(fits, middle, inside), np.where(fits, outside, middle)
    ends = [*([low] if good[0] else []), *inside.tolist(), *([high] if good[-1] else [])]
    return tuple(zip(ends[::2], ends[1::2], strict=True))


def _beyond(closes: Closes, own: float, halvings: int) -> Spans:
    """The range about the own position, of a mechanism that is followed along a path from there: it leads across 0 on
    one side and breaks off on the other, so that 0 and a whole turn are not one. It begins within 0..360. None where it
    does not close there on both sides."""
    before, after = _closed(closes, own - WHOLE, own, halvings), _closed(closes, own, own + WHOLE, halvings)
    if not before or not after:
        return ()
    low, high = before[-1][0], after[0][1]
    turn = WHOLE * float(np.floor(low / WHOLE))
    return ((low - turn, high - turn),)


def _text(low: float, high: float, slide: bool) -> str:
    first, last = ((1e3 * q if slide else np.degrees(q)) for q in (low, high))
    return f"{round(float(first), 2):g}..{round(float(last), 2):g} {'mm' if slide else 'deg'}"


def _printed(text: str) -> Words:
    """Such a range as it is printed: 66.39°～166.44°, from 66.39° to 166.44°."""
    (ends, unit) = text.rsplit(" ", 1)
    first, last = (f"{end}°" if unit == "deg" else end for end in ends.replace("-", "−").split(".."))
    return Words(f"{first}～{last}", f"{first} to {last}") + Words.same("" if unit == "deg" else f" {unit}")


def alone(closes: Closes, at: float, scale: float) -> bool:
    """Whether everything closes just before and just after this position of the drive (rad,
    or m), so that it stands alone."""
    return bool(closes(at + BESIDE * min(scale, 1.0) * np.array([-1.0, 1.0])).all())


def refusal(
    step: Step, where: str, gap: float, ranges: Ranges, *, alone: bool = False, carried: bool = False
) -> AssemblyError:
    """The error for links that do not close; alone: they do just before and after; carried: what is
    carried on along a path from the drive's own position does not close there."""
    zh, en = step.group.told.zh, step.group.told.en
    short, found = bool(np.isfinite(gap) and gap > 0), bool(np.isfinite(gap))
    at = (
        Words(f" 在 {step.joint} 处", f" at {step.joint}")
        if step.joint
        else Words(f" 在{step.group.name.zh.partition('（')[0]}的回路中", f" in the loops of the {step.group.name.en}")
    )
    what = Words(
        f"原动件位于 {where} 时，构件 {zh}{at.zh}不能装配",
        f"links {en} cannot be joined{at.en} where the drive stands at {where}",
    )
    if short:
        mm = f"{1e3 * gap:.4g} mm"
        what = Words(
            f"原动件位于 {where} 时，构件 {zh} 在运动副 {step.joint} 处不能相接，相差 {mm}",
            f"links {en} do not meet at joint {step.joint}: {mm} are missing where the drive stands at {where}",
        )
    numbers: dict[str, str | float] = {"position": where, "joint": step.joint}
    if short:
        numbers["missing"] = float(gap)
    room = _alone(short) if alone else _PLACED if carried and ranges else _room(ranges, found)
    return AssemblyError(what + room, numbers=numbers)


def _alone(short: bool) -> Words:
    why = (
        Words("", "")
        if short
        else Words(
            "，只是此时两运动副重合，方向不定",
            ", but two of their joints fall together there and leave their direction open",
        )
    )
    return Words(
        f"：在其前后均可装配{why.zh}；请略微移动原动件",
        f": they can just before and just after it{why.en}; move the drive a little",
    )


_PLACED = Words(
    "；齿轮、齿条的位置是按原动件的这一位置给出的，随它而定；请改变杆长或这些位置",
    "; the places of gears and racks are given for this position of the drive and go with it: "
    "change a length, or one of these places",
)


def _told(ranges: Ranges) -> Words:
    printed = [_printed(one) for one in ranges]
    return Words(" 或 ".join(one.zh for one in printed), " or ".join(one.en for one in printed))


def _room(ranges: Ranges, found: bool) -> Words:
    if ranges:
        known = _told(ranges)
        return Words(f"；原动件在 {known.zh} 内时可以装配", f"; they can where the drive is within {known.en}")
    if found:
        return Words("；在任何位置都不能装配", "; they can in no position")
    return Words(
        "；由所给 guesses 没有找到装配方式，请另取原动件位置或另给 guesses",
        "; no assembly was found from the guesses; choose another position of the drive, or other guesses",
    )
