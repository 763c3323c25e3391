"""Branch statements in a lecturer's words: `C left of BD`, `C 在 AD 上方`,
`ABCD parallelogram`, `ABCD 为平行四边形`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.assembly.statements import Form, Shaped, SideOf, Statement
from ...mechanism.dimensions.placements import Side
from ...words import Words
from ..links.bodies import Bodies
from ..schema.faults import Faults, meant
from .opposed import check_opposed

_BESIDE = pattern(rf"({LETTER}) (?:is |on the )?(left of|right of|above|below) ({LETTER})({LETTER})?")
_BESIDE_ZH = pattern(rf"({LETTER})\s*在\s*({LETTER})({LETTER})?\s*的?\s*(左|右|上|下)(?:方|侧|边|面)?")
_CORNERS = rf"({LETTER})({LETTER})({LETTER})({LETTER})"
_SHAPED = pattern(rf"{_CORNERS}\s*(?:is an? |为|是)?\s*(anti-?parallelogram|parallelogram|反平行四边形|平行四边形)")
_SHAPED_FIRST = pattern(rf"(anti-?parallelogram|parallelogram|反平行四边形|平行四边形)\s*{_CORNERS}")
BRANCHES = (_BESIDE, _BESIDE_ZH, _SHAPED, _SHAPED_FIRST)  # for editors too
_SIDES = {
    "left of": Side.LEFT,
    "right of": Side.RIGHT,
    "above": Side.ABOVE,
    "below": Side.BELOW,
    "左": Side.LEFT,
    "右": Side.RIGHT,
    "上": Side.ABOVE,
    "下": Side.BELOW,
}
_EQUAL = 1e-9  # m


def read_branches(texts: Iterable[str], bodies: Bodies, faults: Faults) -> tuple[Statement, ...]:
    """The statements under `branch`; what is wrong with one is noted at its place."""
    branches: dict[str, Statement] = {}
    for i, text in enumerate(texts):
        with faults.at("branch", i):
            statement = read_branch(text, (*bodies.letters(), *bodies.pitch))
            if isinstance(statement, Shaped):
                check_figure(statement, bodies)
            check_opposed(text, statement, branches)
            branches[text] = statement
    return tuple(branches.values())


def read_branch(text: str, letters: Iterable[str]) -> Statement:
    """'C left of BD', 'C above AD', 'F left of E', 'C 在 AD 上方', 'ABCD parallelogram'."""
    statement = _read(text.strip())
    known = set(letters)
    for letter in statement.letters:
        if letter not in known:
            raise FaultError(
                Words(f"点“{letter}”不存在", f"point '{letter}' does not exist") + meant(letter, known),
                code="unknown-name",
            )
    if len(set(statement.letters)) < len(statement.letters):
        raise FaultError(
            Words(
                f"'{text}'：同一点出现两次，没有左右可分；请写不同的点，如 C left of BD",
                f"'{text}' names one point twice, and so no side of anything; name different points, e.g. C left of BD",
            ),
            code="contradiction",
        )
    return statement


def _read(text: str) -> Statement:
    if m := _BESIDE.fullmatch(text):
        return SideOf(point=m[1], side=_SIDES[m[2]], ref=(m[3], m[4]) if m[4] else (m[3],))
    if m := _BESIDE_ZH.fullmatch(text):
        return SideOf(point=m[1], side=_SIDES[m[4]], ref=(m[2], m[3]) if m[3] else (m[2],))
    if m := _SHAPED.fullmatch(text):
        return Shaped(corners=(m[1], m[2], m[3], m[4]), form=_form(m[5]))
    if m := _SHAPED_FIRST.fullmatch(text):
        return Shaped(corners=(m[2], m[3], m[4], m[5]), form=_form(m[1]))
    raise FaultError(
        Words(
            f"'{text}' 不是分支说明；请写如 'C 在 AD 上方'、'C left of BD' 或 'ABCD 为平行四边形'",
            f"'{text}' is no branch; write e.g. 'C above AD', 'C left of BD', 'F left of E', "
            "'C 在 AD 上方' or 'ABCD parallelogram'",
        ),
        code="spelling",
    )


def _form(word: str) -> Form:
    return Form.ANTIPARALLELOGRAM if word.startswith(("anti", "反")) else Form.PARALLELOGRAM


def check_figure(statement: Shaped, bodies: Bodies) -> None:
    """FaultError where the four-bar is none, or its opposite sides are not equal."""
    corners, name = statement.corners, "".join(statement.corners)
    sides = [(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    lengths = [_length(p, q, bodies, name) for p, q in sides]
    for i in (0, 1):
        if abs(lengths[i] - lengths[i + 2]) > _EQUAL:
            one, other = ("".join(sides[k]) for k in (i, i + 2))
            raise FaultError(
                Words(
                    f"{name} 不可能是{statement.form.words.zh}：对边 {one} = {1e3 * lengths[i]:g} mm，"
                    f"{other} = {1e3 * lengths[i + 2]:g} mm 不相等",
                    f"{name} is not {statement.form.words.en}: its opposite sides {one} = "
                    f"{1e3 * lengths[i]:g} mm and {other} = {1e3 * lengths[i + 2]:g} mm are "
                    "unlike; check the lengths, or say on which side a point lies",
                )
            )


def _length(p: str, q: str, bodies: Bodies, name: str) -> float:
    """The side PQ (m): of a link, or of the frame."""
    owners: list[Mapping[str, complex]] = [bodies.frame, *(draft.points for draft in bodies.drafts.values())]
    found = next((abs(points[p] - points[q]) for points in owners if p in points and q in points), None)
    if found is None:
        raise FaultError(
            Words(
                f"{name} 不是四杆回路：没有同时具有 {p}、{q} 的构件；请按回路顺序写四个铰链",
                f"{name} goes round no four-bar: no link has both {p} and {q}; write its "
                "four hinges in their order round the loop",
            )
        )
    return found
