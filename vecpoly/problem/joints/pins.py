"""`pins`: which link carries the pin of a multiple joint, where the problem says it."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import FaultError
from ...mechanism.groups.assur import hinges
from ...mechanism.model import Mechanism
from ...words import Words
from ..schema.faults import Faults


def read_pins(spec: Mapping[str, str], mech: Mechanism, faults: Faults) -> dict[str, str]:
    """Letter → link; the frame by its printed number.
    Notes a fault where the letter is no multiple joint, or the link is not there."""
    found: dict[str, str] = {}
    for letter, number in spec.items():
        with faults.at("pins", letter):
            found[letter] = _carrier(letter, number, mech)
    return found


def _carrier(letter: str, number: str, mech: Mechanism) -> str:
    hinged = [name for name in hinges(mech).get(letter, ()) if name not in mech.substitutes]
    names = [name for name in hinged if name not in mech.slot_pins]
    if len(names) < 2 or len(hinged) < 3:  # two links, and a slot on which one of them presses, are enough
        raise FaultError(
            Words(
                f"{letter} 不是复合铰链（铰接于此的构件：{_numbers(mech, names) or '无'}），"
                "其销轴属于哪个构件没有区别；删去此项",
                f"{letter} is no multiple joint (links pinned there: "
                f"{_numbers(mech, names) or 'none'}), where it makes no difference which "
                "link carries the pin; leave the entry out",
            )
        )
    if mech.named(number) not in names:
        raise FaultError(
            Words(
                f"构件 {number} 不在铰链 {letter} 上；铰接于此的构件：{_numbers(mech, names)}，请写其中之一",
                f"link {number} is not at hinge {letter}; pinned there are {_numbers(mech, names)}: write one of them",
            )
        )
    return mech.named(number)


def _numbers(mech: Mechanism, names: list[str]) -> str:
    return ", ".join(mech.number(name) for name in names)
