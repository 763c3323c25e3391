"""A guide's resultant that crosses the guide past what is drawn of it: how long the pair is thought, must be said.

One reaction, inclined by φ, can act only where the parts of the pair touch. Past their ends both edges would press, and
friction would be φ times the sum of two reactions: the textbook's single resultant supposes a pair that is long enough.
"""

from __future__ import annotations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Block, FixedGuide
from ....diagram.guides import reaching
from ....diagram.posed import Way
from ....mechanism.model import Prismatic
from ....plane import Line, lines_meet, nominal
from ....words import Words, joined
from ..state import Statics

BESIDE = 4.0  # mm: no part of a guide is drawn farther beside its line
PARALLEL = 1e-6  # sine
TOUCHES = 0.05  # mm past its end that cannot be told from it

Part = tuple[float, float, Block | None]  # from, to along the guide; the block, where it is one


def say_past_guides(st: Statics) -> None:
    """Of every slide with friction whose resultant leaves what is drawn of the pair: that it is thought longer."""
    blocks: list[Words] = []
    guides: list[Words] = []
    longer = True
    for joint in st.mech.joints:
        if not isinstance(joint, Prismatic) or not st.phi(joint) or joint.pin_in_slot:
            continue
        force = st.push(joint.guide, joint.block)
        if force is None or abs(complex(nominal(force.vector))) < NO_LENGTH:
            continue
        line = _way(st.desk.guide_line(joint))
        here, part = complex(nominal(lines_meet(st.desk.guide_line(joint), force.line))), _drawn(st, joint, line)
        if part is None or part[0] - TOUCHES <= line.travel(here) <= part[1] + TOUCHES:
            continue
        symbol = Words.same(f"${force.named.symbol}$")
        if part[2] is None:
            guides.append(symbol)
        else:
            blocks.append(symbol)
            longer = longer and reaching(part[2], (complex(nominal(force.at)),)) != part[2]
    if blocks:
        st.board.remark(_said(blocks, Words("滑块", "block"), longer=longer))
    if guides:
        st.board.remark(_said(guides, Words("导路", "guide"), longer=False))


def _said(symbols: list[Words], what: Words, *, longer: bool) -> Words:
    names, many = joined(symbols), len(symbols) > 1
    drawn = Words("（受力图中已画长）", ", as its free body shows it") if longer else Words.same("")
    lines, cross = ("lines", "cross") if many else ("line", "crosses")
    return Words(
        f"{names.zh} 的作用线与导路的交点在图示{what.zh}之外：这里设{what.zh}足够长{drawn.zh}；"
        f"否则{what.zh}两端各受一反力，摩擦力更大。",
        f" The {lines} of {names.en} {cross} the guide's line outside of the {what.en} as drawn: the {what.en} is "
        f"thought long enough{drawn.en}; else both its ends would press, with more friction.",
    )


def _drawn(st: Statics, joint: Prismatic, line: Way) -> Part | None:
    """What is drawn of the pair: its block, or else the fixed guide in which a rod runs."""
    blocks: list[Part] = []
    guides: list[Part] = []
    pin = line.travel(complex(nominal(st.desk.at[joint.pin])))
    for mark in st.board.marks(View.MECHANISM):
        match mark:
            case Block(at=at, along=along, length=length) if _lies(line, at, along):
                middle = line.travel(at)
                blocks.append((middle - length / 2, middle + length / 2, mark))
            case FixedGuide(a=a, b=b) if a != b and _lies(line, (a + b) / 2, (b - a) / abs(b - a)):
                low, high = sorted((line.travel(a), line.travel(b)))
                guides.append((low, high, None))
            case _:
                pass
    return min(blocks or guides, key=lambda part: abs((part[0] + part[1]) / 2 - pin), default=None)


def _lies(line: Way, at: complex, along: complex) -> bool:
    return abs((line.along.conjugate() * along).imag) < PARALLEL and abs(line.off(at)) < BESIDE


def _way(line: Line) -> Way:
    return Way(complex(nominal(line.at)), complex(nominal(line.along)))
