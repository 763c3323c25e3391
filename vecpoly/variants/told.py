"""What a pilot found, in sentences."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..grading.told.slip import said_of
from ..limits import ROSTER
from ..problem.asked.asks import AskNamed, AskRel
from ..problem.problem import Problem
from ..problem.values.vary import parameters
from ..words import Words, bare, many
from .conditions import Condition
from .pilot import Pilot


def told(name: str, pilot: Pilot) -> Iterator[Words]:
    """The yield, and what the others fail on."""
    most = sorted(pilot.failed.items(), key=lambda item: -item[1])
    zh = "、".join(f"{condition.words.zh} {100 * share:.1f} %" for condition, share in most)
    en = ", ".join(f"{condition.words.en} {100 * share:.1f} %" for condition, share in most)
    yield Words(
        f"{name}：随机取值的 {100 * pilot.passed:.1f} % 合格" + (f"；不合格的原因：{zh}" if zh else ""),
        f"{name}: {100 * pilot.passed:.1f} % of the draws pass" + (f"; the others fail: {en}" if en else ""),
    )
    if pilot.room < ROSTER:
        count = max(1, int(float(f"{pilot.room:.2g}")))
        yield Words(
            f"能使读数互相拉开距离的学生约 {count} 名；更多时请{Condition.APART.remedy.zh}",
            f"about {count} student{'s' * (count > 1)} can be told apart by their readings; for more, "
            f"{Condition.APART.remedy.en}",
        )


def said_already(problem: Problem) -> Iterator[Words]:
    """Where the text of the problem tells a value that now differs from student to student."""
    known = parameters(problem)
    for one in problem.ranges:
        written = known.get(one.name, "")
        if len(written) > 1 and any(_tells(text, written) for text in (problem.statement.zh, problem.statement.en)):
            yield Words(
                f"{problem.id}：题目正文中写有 {one.name} = {written}，而它现在因人而异；请从 statement 中删去",
                f"{problem.id}: the statement says {one.name} = {written}, which now differs from student to "
                f"student; take it out",
            )


def _tells(text: str, written: str) -> bool:
    """Whether a text tells a value, however its unit is spelt there: 165 deg, 165°."""
    return _squeezed(written) in _squeezed(text)


def _squeezed(text: str) -> str:
    for spelt, sign in (("deg", "°"), ("度", "°"), ("*", "·"), ("^2", "²"), ("^3", "³")):
        text = text.replace(spelt, sign)
    return "".join(text.split())


def asks_otherwise(problem: Problem) -> Iterator[Words]:
    """Where what is asked stands in another file than the text of the problem, which asks what it always did."""
    places = {} if problem.written is None else problem.written.places
    find = places.get(("find",))
    texts = [places[at].file for at in (("statement",), ("statement", "zh"), ("statement", "en")) if at in places]
    if find is not None and texts and find.file not in texts:
        asked = ", ".join(ask.rel.key for ask in problem.asks if isinstance(ask, AskRel | AskNamed))
        file = Path(texts[0]).name
        yield Words(
            f"{problem.id}：题目正文取自 {file}，而这里所求为 {asked}；请在 find 旁另写 statement，使正文与所求一致",
            f"{problem.id}: the statement is that of {file}, but here {asked} are asked; write a statement beside find "
            "that asks for these",
        )


def demoted(pilot: Pilot) -> Iterator[Words]:
    """What is graded by follow-through only, and which slips no number shows."""
    if keys := [key for key in pilot.asked if key in pilot.standard.demoted]:
        names = ", ".join(keys)
        yield Words(
            f"降为连带评分（多数情况下太短或误差太大，不按精确值评分）：{names}",
            f"demoted to follow-through (in most variants too short, or drawn too badly, to be held against "
            f"the exact value): {names}",
        )
    shown = {*map(said_of, pilot.shown)}  # on another figure
    said = dict.fromkeys(one for one in map(said_of, sorted(pilot.standard.hidden, key=str)) if one not in shown)
    if said:
        zh, en = "、".join(bare(one.zh) for one in said), "; ".join(bare(one.en) for one in said)
        yield Words(f"读数上看不出的错误：{zh}", f"slips that no answer shows: {en}")
    if pilot.standard.twins:
        count = len(pilot.standard.twins)
        yield Words(
            f"{count} 对错误的读数相同，只能给出其一",
            f"{many(count, 'pairs')} of slips {'gives' if count == 1 else 'give'} the same readings; either may be "
            "named",
        )
