"""What is given and asked reads as a textbook's problem: joints in the figure, long lists by kinds."""

from __future__ import annotations

import json
import re

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from tests.found import DEVICES, FOUND
from tests.generators.library import problems
from tests.studies import solved
from vecpoly.board.paper.marks import LinkNumber, Point
from vecpoly.devices.structure import Structure
from vecpoly.problem.load import loads
from vecpoly.report.content import statement
from vecpoly.report.statement.asked import asked
from vecpoly.report.statement.further import further
from vecpoly.report.statement.groups import LONG
from vecpoly.report.values import is_worded
from vecpoly.words import Lang

STRUCTURES = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Structure)))
LANGS: tuple[Lang, ...] = ("zh", "en")


@each(STRUCTURES)
def test_links_and_joints_are_those_of_the_figure_and_no_list_of_them_is_given(name: str) -> None:
    one = drawn(name)
    subject = one.problem.subject
    assert isinstance(subject, Structure)
    for lang in LANGS:
        given = statement(one.solution, lang)["given"]
        assert not re.search(r"[RPHG]\$? = |转动副|revolute|移动副|prismatic", given)
        assert ("见图" if lang == "zh" else "see the figure") in given
    marks = one.solution.construction.figures[0].marks
    letters = {mark.label.replace("_", "") for mark in marks if isinstance(mark, Point)}
    numbers = {mark.number for mark in marks if isinstance(mark, LinkNumber)}
    assert {*subject.joints} <= letters and set(map(subject.number, subject.chain.links)) <= numbers


@each(IDS)
def test_every_quantity_asked_stands_in_the_line_of_what_is_asked(name: str) -> None:
    one = drawn(name)
    said = statement(one.solution, "en")["asked"]
    if "all instant centres" in said:
        return
    for key, answer in one.solution.answers.items():
        if is_worded(key, answer.reading.unit) or key in further(one.construction.readings):
            continue  # whether it is balanced, of which class it is; what would tell that there is a second solution
        symbol = answer.reading.symbol.replace("^{∞}", "")
        assert f"${symbol}$" in said, (key, said)


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("3-5", ("速度", "角速度", "加速度", "角加速度")),
        ("six-bar-dynamic", ("加速度", "角加速度", "惯性力、惯性力矩和力臂", "运动副反力")),
        ("2-6", ("活动构件数", "高副低代后：活动构件数")),
    ],
)
def test_a_long_list_of_questions_is_told_by_kinds(name: str, kinds: tuple[str, ...]) -> None:
    parts = statement(drawn(name).solution, "zh")["asked"].split("；")
    numbered = [f"({n}) " for n in range(1, len(parts) + 1)]
    assert all(part.startswith(number) for part, number in zip(parts, numbered, strict=True))
    assert [part.split(" ")[1] for part in parts][: len(kinds)] == list(kinds)


def test_a_short_list_is_told_as_it_is() -> None:
    short = [name for name in IDS if 1 < len(drawn(name).problem.asks) < LONG]
    assert short and not any("；" in statement(drawn(name).solution, "zh")["asked"] for name in short)


@pytest.mark.parametrize("name", [name for name in IDS if name[0] in "45"])
def test_a_force_is_not_taken_for_a_mobility(name: str) -> None:
    """The F of a wedge has the key that the mobility has elsewhere."""
    for lang, word in (("zh", "自由度"), ("en", "mobility")):
        assert word not in statement(drawn(name).solution, lang)["asked"]  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("field-influence", "影响系数的大小 $α$"),
        ("5-5", "下降时的效率 $η′$"),
        ("7-2a", "传动比的大小 $i_{0I}$、$i_{II,I}$"),
        ("7-6", "速度不均匀系数 $δ$、最大转速 $n_{max}$"),
        ("two-stroke-flywheel", "驱动功率 $P$"),
        ("8-3c", "导杆的摆角 $ψ$"),
    ],
)
def test_quantities_of_devices_are_asked_by_what_they_are(name: str, told: str) -> None:
    assert told in asked(solved(name), "zh")


@each([*IDS, *FOUND, *DEVICES])
def test_nothing_is_called_twice_in_the_line_of_what_is_asked(name: str) -> None:
    for lang in LANGS:
        said = statement(drawn(name).solution, lang)["asked"]
        assert not re.search(r"([\u4e00-\u9fff]{2,})\1|\b([a-z]+(?: [a-z]+)*) \2\b", said), said


def test_of_a_cam_nothing_is_asked_at_its_stations_where_nobody_names_them() -> None:
    data = {key: value for key, value in problems()["cam-roller-offset"].items() if key != "find"}
    asks = loads(json.dumps(data, ensure_ascii=False)).asks
    assert asks and not any("φ =" in ask.rel.symbol or re.search(r"_\d", ask.rel.key) for ask in asks)
