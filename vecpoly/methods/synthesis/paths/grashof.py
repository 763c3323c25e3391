"""The condition for a crank with the dividers: lengths end to end, what each link gives as the frame, a range."""

from __future__ import annotations

from ....algebra.quantity import Quantity
from ....board.paper.marks import Dot, Role
from ....board.paper.titled import SUMS_OF_LENGTHS
from ....designs.grashof import ENDS, LEAST, MIDDLE, MOST, Grashof
from ....designs.quantities import FOUR_BAR
from ....designs.verdict import Verdict
from ....plane import Points, nominal
from ....words import Words
from ..draft import SHEET, Draft
from ..linkage import point
from ..registry import design_method

ROW, SHIFT = 16.0, 4.0  # mm: from line to line; a length that is laid off backwards lies below


@design_method(
    Grashof,
    title=Words("曲柄存在条件和机架变换", "Grashof condition and inversions of the chain"),
    source="机械原理, Grashof's condition",
    sheet=SUMS_OF_LENGTHS,
    example="8-1",
)
def draw_grashof(draft: Draft, design: Grashof) -> None:
    """l_min + l_max beside the sum of the others; the frames; the range of CD."""
    lengths = {named.key: draft.shared(named, 1e3 * getattr(design, named.key).si) for named in FOUR_BAR}
    least, *middle, most = sorted(lengths, key=lambda key: float(getattr(design, key).si))
    board = draft.board
    board.section(Words("杆长条件", "The condition of lengths"))
    board.step(
        Words(
            "选 $μ_l$，在一直线上接连截取最短杆和最长杆，在另一直线上接连截取其余两杆，比较两和：",
            "Choose $μ_l$; lay off the shortest and the longest link end to end on one line, the other two on another, "
            "and compare:",
        ),
        SHEET,
    )
    ends = _sum(draft, 0, (least, most), lengths)
    others = _sum(draft, 1, (middle[0], middle[1]), lengths)
    one = draft.length(draft.of_this(ENDS), board.measure(*ends, "O M"), "O M")
    two = draft.length(draft.of_this(MIDDLE), board.measure(*others, "O′ N"), "O′ N")
    board.remark(_types(float(nominal(one.value)) <= float(nominal(two.value)), least))
    _range(draft, lengths)
    draft.candidate(Verdict.VALID, tuple(draft.on_paper(lengths[key]) for key in ("AB", "BC", "AD")), A=ends[0])


def _sum(draft: Draft, row: int, keys: tuple[str, ...], lengths: dict[str, Quantity]) -> tuple[Points, Points]:
    """Links end to end."""
    start = at = point(draft, ("O", "O′", "O″", "O‴")[row], -1j * ROW * row)
    for key in keys:
        end = draft.board.lay_off(at, 1 + 0j, draft.on_paper(lengths[key]))
        draft.board.join(SHEET, at, end, Role.LINK)
        draft.board.plot(SHEET, end, "", Dot.POINT)
        draft.board.note(SHEET, (at + end) / 2, Words.same(key))
        at = end
    return start, point(draft, "MNPR"[row], at)


def _types(crank: bool, least: str) -> Words:
    """What each link gives as the frame."""
    if not crank:
        return Words(
            "最短杆与最长杆之和大于其余两杆之和，没有曲柄：以任一杆为机架都是双摇杆机构。",
            " The shortest and the longest are longer than the others: no crank, a double rocker with any frame.",
        )
    ring = ["AB", "BC", "CD", "AD"]
    n = ring.index(least)
    before, after, opposite = ring[n - 1], ring[(n + 1) % 4], ring[(n + 2) % 4]
    return Words(
        f"满足杆长条件：以 ${before}$ 或 ${after}$（最短杆的邻杆）为机架得曲柄摇杆机构，最短杆 ${least}$ 为曲柄；以 "
        f"${least}$ 为"
        f"机架得双曲柄机构；以 ${opposite}$ 为机架得双摇杆机构。",
        f" The condition holds: with ${before}$ or ${after}$, beside the shortest, as the frame it is a crank-rocker "
        f"with "
        f"the crank ${least}$; with ${least}$ a double crank; with ${opposite}$ a double rocker.",
    )


def _range(draft: Draft, lengths: dict[str, Quantity]) -> None:
    """As the frame CD gives a double rocker from |AB + BC − AD| (a double crank below) up to AB + BC + AD."""
    board = draft.board
    short, long = sorted(("BC", "AD"), key=lambda key: float(nominal(lengths[key].value)))
    board.section(Words("以 $CD$ 为机架", "With $CD$ as the frame"))
    sums = f"l_AB + l_{{{short}}}"
    board.step(
        Words(
            f"$CD$ 与最短杆 $AB$ 相对。$CD$ 最短且 $l_CD + l_{{{long}}} ≤ {sums}$ 时为双曲柄机构，否则为双摇杆机构；"
            f"$CD$ 最长时须小于其余三杆之和。截取 ${sums}$，再反向截取 $l_{{{long}}}$，得机架长 $l_f$ 的"
            "下限；三杆接连截取，得上限（均不含端点：下限处为转折点，上限处成一直线）：",
            f"The link $CD$ is opposite $AB$, the shortest. Where it is shortest itself and $l_CD + l_{{{long}}} ≤ "
            f"{sums}$ it gives a double crank, else a double rocker; it must be below the sum of the others. Lay off "
            f"${sums}$ and back from its end $l_{{{long}}}$: the lower bound of the frame $l_f$; all three end to "
            "end: the upper one (ends excluded: a change point, and a straight line).",
        ),
        SHEET,
    )
    start, end = _sum(draft, 2, ("AB", short), lengths)
    back = board.lay_off(end, -1 + 0j, draft.on_paper(lengths[long]))
    back = point(draft, "Q", back - 1j * SHIFT)
    board.join(SHEET, end - 1j * SHIFT, back, Role.GIVEN)
    board.join(SHEET, end, end - 1j * SHIFT, Role.CONSTRUCTION)
    draft.length(draft.of_this(LEAST), board.measure(start, back + 1j * SHIFT, "O″ Q"), "O″ Q")
    first, last = _sum(draft, 3, ("AB", short, long), lengths)
    draft.length(draft.of_this(MOST), board.measure(first, last, "O‴ R"), "O‴ R")
