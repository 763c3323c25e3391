"""The data of a sliding joint for 已知."""

from __future__ import annotations

import re
from math import degrees

from ...foundation.indices import LETTER
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism, Prismatic
from ...mechanism.offsets import offset_symbol
from ...units.reading import Dim, read
from ...words import Words
from ..links.draft import Draft
from ..links.guides import LINK
from ..problem import Shape
from ..values.given import Datum
from ..values.leaning import at_angle, side_of
from ..values.seen import Beside, Leaning

# what makes an angle with the guide
_OWN = {Shape.SLOT: Words("的滑道", "the slideway of "), Shape.ROD: Words("的杆", "the rod of ")}

RIGHT = 90.0  # degrees: an angle that has no sense
_LEVEL = Words("水平方向", "the horizontal")


OFFSET = "$e$"  # as it is said until all guides are known: see `offset_symbol`


def note_aside(m: re.Match[str], draft: Draft, block: str, guide: str) -> None:
    """Remember the offset of a guide for 已知."""
    side = "左" if m["side"] == "left" else "右"
    draft.say(
        Words(
            f"偏距 {OFFSET} = {m['offset']}（${m['off']}$ 在导路{side}侧）",
            f"offset {OFFSET} = {m['offset']} (${m['off']}$ to the {m['side']} of the guide)",
        ),
        Beside(letter=m["off"], block=block, guide=guide),
    )


def with_offset(datum: Datum, mech: Mechanism) -> Datum:
    """What is said of an offset, by its own symbol; any other datum as it is."""
    if not isinstance(seen := datum.seen, Beside) or datum.words is None:
        return datum
    slides = (joint for joint in mech.joints if isinstance(joint, Prismatic))
    joint = next(one for one in slides if (one.block, one.guide, one.aside) == (seen.block, seen.guide, seen.letter))
    symbol = f"${offset_symbol(mech, joint)}$"
    return replace(datum, words=Words(datum.words.zh.replace(OFFSET, symbol), datum.words.en.replace(OFFSET, symbol)))


def note_slide(m: re.Match[str], block: Draft, guide: str, pin: str) -> None:
    """Remember the data of a sliding joint for 已知."""
    if m["offset"]:
        note_aside(m, block, block.name, guide)
    note_fixed(m["guide"], block, pin)
    if m["turn"]:
        turn = round(degrees(read(m["turn"], Dim.ANGLE).si) % 180, 9)
        acute = min(turn, 180 - turn)
        own = _OWN.get(block.shape, Words("", ""))
        on = _guide_told(m["guide"])
        way = side_of(turn if turn <= RIGHT else turn - 180.0, on, RIGHT)
        block.say(
            Words(
                f"构件 {block.name} {own.zh}与{on.zh}成 {acute:g}°{way.zh}",
                f"{own.en}link {block.name} is at {acute:g}° to {on.en}{way.en}",
            )
        )


def _lies(text: str, turn: float) -> Words:
    """How a guide lies in the frame."""
    square = round(degrees(turn), 9) % 180
    if square in (0.0, RIGHT):
        return Words("竖直", "vertical") if square else Words("水平", "horizontal")
    return at_angle(text, turn, _LEVEL)


def note_fixed(guide: str, on: Draft, pin: str) -> None:
    """Remember where a fixed guide lies, in which a block slides or a pin runs."""
    if fixed := re.fullmatch(r"([xy]) = (.+)", guide):
        symbol = f"{fixed[1]}_{pin}"
        said = Words(f"${pin}$ 的导路 ${symbol}$ = {{}}", f"the guide of ${pin}$ at ${symbol}$ = {{}}")
        on.note(symbol, read(fixed[2], Dim.LENGTH).si, fixed[2], said)
    elif fixed := re.fullmatch(rf"line through ({LETTER}) at (.+)", guide):
        turn = read(fixed[2], Dim.ANGLE).si
        said = Words(f"过 ${fixed[1]}$ 的导路", f"the guide through ${fixed[1]}$ is ")
        on.say(said + _lies(fixed[2], turn), Leaning(at=fixed[1], turn=turn))


def _guide_told(guide: str) -> Words:
    """A line by its letters; a guide by the link that has it, or by itself where that is the frame."""
    if (found := re.match(rf"{LETTER}{LETTER}(?= of |$)", guide)) is not None:
        return Words(f" ${found[0]}$ ", f"${found[0]}$")
    if re.fullmatch(LINK, guide):
        return Words(f"构件 {guide} 的导路", f"its guide on link {guide}")
    return Words("导路", "its guide")
