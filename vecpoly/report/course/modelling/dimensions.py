"""The kinematic diagram true to a round scale, and the lengths of all links, in nature and as they stand on it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from ....algebra.quantity import number
from ....algebra.rounding import in_tenths
from ....board.construction import Figure
from ....board.paper.scales import round_up
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....mechanism.model import FRAME, Circle, Mechanism, Rolling
from ....words import Words
from ...picture import scaled, to_scale
from ..numbering import SMALL, Press

_HEADER = {"zh": ["构件", "尺寸 /mm", "图上长度 /mm"], "en": ["Link", "Dimensions, mm", "On paper, mm"]}
_MOST = 4  # points of a link of which all distances are told


def rounded(figure: Figure) -> Figure:
    """The figure reduced a little further, to a round scale."""
    if not to_scale(figure):
        return figure
    scale = round_up(figure.scale.value)
    return replace(
        figure,
        marks=tuple(scaled(m, figure.scale.value / scale) for m in figure.marks),
        scale=replace(figure.scale, value=scale),
    )


def dimensions(study: Study, press: Press, figure: Figure | None) -> str:
    """One line for every link with two points or more, or teeth, the frame last."""
    if figure is None or not to_scale(figure):
        return ""
    comma = "，" if press.lang == "zh" else ", "
    rows = [
        (
            Words("机架", "frame").of(press.lang) if name == FRAME else study.name(name),
            comma.join(f"${symbol}$ = {number(round(1e3 * size, 9), 5)}" for symbol, size in found),
            comma.join(in_tenths(size / figure.scale.value) for _, size in found),
        )
        for name, found in _sizes(study)
        if found
    ]
    title = Words(
        f"各构件的尺寸（图上长度按 ${figure.scale.symbol}$ = {number(figure.scale.value)} {figure.scale.per_mm}）",
        f"Dimensions of the links (on paper at ${figure.scale.symbol}$ = "
        f"{number(figure.scale.value)} {figure.scale.per_mm})",
    )
    return press.table(title, _HEADER[press.lang], rows, "cll", style=SMALL) if rows else ""


def listed(study: Study, figure: Figure | None) -> frozenset[str]:
    """The symbols of what that table tells, without braces; none where there is no table."""
    if figure is None or not to_scale(figure):
        return frozenset()
    return frozenset(symbol.replace("{", "").replace("}", "") for _, found in _sizes(study) for symbol, _ in found)


def _sizes(study: Study) -> Iterator[tuple[str, list[tuple[str, float]]]]:
    """Each link, the frame last, with the symbols and lengths (m) that are told of it."""
    for name in (*(body for body in study.mech.bodies if body not in study.mech.substitutes), FRAME):
        yield name, [*_distances(study, name), *_radii(study.mech, name)]


def _radii(mech: Mechanism, link: str) -> Iterator[tuple[str, float]]:
    """Of the pitch circles of a link, r_2, and of the frame, r."""
    symbol = "r" if link == FRAME else f"r_{{{mech.number(link)}}}"
    rolling = [joint for joint in mech.joints if isinstance(joint, Rolling)]
    circles = [*(one.gear for one in rolling), *(one.on for one in rolling if isinstance(one.on, Circle))]
    yield from dict.fromkeys((symbol, one.radius) for one in circles if one.link == link)


def _distances(study: Study, link: str) -> Iterator[tuple[str, float]]:
    """Between all points of a link, of many from the first; lettered as the problem does."""
    points = study.mech.frame if link == FRAME else study.mech.link(link).points
    given = {d.symbol for d in study.problem.given.lengths}
    letters = list(points)
    for one, two in (
        combinations(letters, 2) if len(letters) <= _MOST else ((letters[0], other) for other in letters[1:])
    ):
        size = abs(points[one] - points[two])
        first, second = (
            (two, one) if f"l_{two}{one}" in given else (one, two) if f"l_{one}{two}" in given else sorted((one, two))
        )
        if size > 1e-9 * study.mech.scale:
            yield f"l_{{{first}{second}}}", size
