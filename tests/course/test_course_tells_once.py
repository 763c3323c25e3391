"""A course report lists nothing twice: no datum, no column, no half of a symmetrical motion, no end that begins."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from math import cos, pi, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.course.test_course_numbers import Recorder
from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from tests.laws import few
from tests.presses import Made, press, shown
from tests.studies import course_words, in_small, machine, stations, studied
from vecpoly.cycle import Column, Table
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.shown import shown as in_prose
from vecpoly.report.answers.notes import unread_words
from vecpoly.report.answers.tables import readings_tables
from vecpoly.report.content import Objects
from vecpoly.report.course import appendix, statement
from vecpoly.report.course.analysis.why_peaks import causes, table
from vecpoly.report.course.checks import comparison
from vecpoly.report.course.machine import chapters
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results import chapter as results
from vecpoly.report.course.results.mirrored import half, mirror, told
from vecpoly.report.flow.results.blocked import BlockTable
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang, Words

NAMES = ("rack-drives-pinion", "shaper-flywheel", "3-12", "curv-5", "A-27", "slider-crank-dynamic", "7-2b", "3-7d")
MACHINES = ("shaper-flywheel", "press-flywheel", "slider-crank-dynamic")
GIVEN = ("shaper-flywheel", "3-12", "curv-3", "engine-card", "A-26", "7-1", "six-bar-dynamic")
_WHOLE = np.arange(0.0, 360.0, 10.0)


class Noted(Press):
    """A press that sets its tables and keeps them as they were asked for, too."""

    def __init__(self, lang: Lang) -> None:
        super().__init__(lang, Objects(), "5")
        self.made: list[Made] = []

    def table(self, title: Any, header: Any, rows: Any, align: str, **style: Any) -> str:
        wide = BlockTable.of(header, rows, style.get("blocks", 1), align, self.lang)
        self.made.append(Made(title, wide.header, wide.rows, style.get("style")))
        return super().table(title, header, rows, align, **style)


def columns(made: Made) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Each column with its head, of a table in several blocks all of them, one behind the other."""
    found: dict[str, list[str]] = {}
    for n, head in enumerate(made.header):
        found.setdefault(head, []).extend(row[n] for row in made.rows if row[n])
    yield from ((head, tuple(cells)) for head, cells in found.items() if head)


@pytest.mark.parametrize("name", few(GIVEN, 3))
def test_chapter_1_tells_every_datum_and_none_twice(name: str) -> None:
    it, kept = studied(name), press("zh")
    task = statement.task(it, kept)
    cells = [cell for made in kept.made for row in made.rows for cell in row]
    listed = re.findall(r"\$([^$]+)\$", "，".join([task["given"], *cells]))
    symbols = [re.sub("[{}]", "", one) for one in listed]
    for datum in it.problem.given.data:
        bare = re.sub("[{}]", "", datum.symbol)
        told = symbols.count(bare) or any(datum.of("zh").startswith(part) for part in task["given"].split("，"))
        assert told or datum.words is not None, datum
        assert not datum.symbol or sum(cell.strip("$") == datum.symbol for cell in cells) <= 1, datum


def test_the_appendix_lists_no_datum() -> None:
    text, objects = course_words("shaper-flywheel", "zh")
    captions = [one.caption for one in objects.named.values() if isinstance(one, DataTable)]
    assert [one for one in captions if "已知数据" in one] == [one for one in captions if re.match("表 1-1.*已知", one)]
    assert "题目给定的数据列于" not in text


@pytest.mark.parametrize("name", few(NAMES, 3))
def test_no_column_of_the_appendix_stands_in_chapter_5(name: str) -> None:
    """s_56, v_56, a_56 of a slider are x_E, v_Ex, a_Ex of its pin."""
    it, before, behind = studied(name), Noted("en"), Noted("en")
    with in_small():
        results.chapter(it, before)
    appendix.chapter(it, behind)
    known = {cells: head for made in before.made for head, cells in columns(made) if not head.startswith("$φ_{1}$")}
    again = [(head, known[cells]) for made in behind.made for head, cells in columns(made) if cells in known]
    assert not again


def test_a_slide_that_moves_as_a_point_does_is_said_to() -> None:
    said = appendix.chapter(studied("rack-drives-pinion"), Noted("en"))["same"]
    assert "$s_{35}$ = $x_{C}$" in said and not list(appendix.told_as(studied("3-9")))


@pytest.mark.parametrize("name", few(MACHINES, 3))
def test_the_end_of_a_period_which_is_its_beginning_has_no_row(name: str) -> None:
    it, kept = studied(name), Noted("en")
    with in_small():
        chapters.chapters(it, kept, machine(name))
    tables = [made for made in kept.made if len(made.rows) > 6 and "" not in made.header]
    assert kept.made and not [made.title.en for made in tables if made.rows[0][1:] == made.rows[-1][1:]]


def made_of(values: Mapping[str, Sequence[float]], unit: str = "") -> Table:
    drive = Column(key="phi_1", symbol="φ_1", unit="rad", words=Words("角", "angle"))
    every = [drive, *(Column(key=key, symbol=key, unit=unit, words=Words(key, key)) for key in values)]
    return Table(tuple(every), np.column_stack([_WHOLE, *values.values()]))


@given(
    doubled=st.integers(0, 35),
    near=st.floats(0, 720),
    kinds=st.lists(st.sampled_from(["even", "odd"]), min_size=1, max_size=4),
    sizes=st.lists(st.floats(0.1, 50), min_size=4, max_size=4),
)
def test_the_half_that_is_listed_and_the_sentence_give_the_whole(
    doubled: int, near: float, kinds: list[str], sizes: list[float]
) -> None:
    """About a row, or between two; the half in which the mechanism is given."""
    at = np.radians(_WHOLE - 5.0 * doubled)
    waves = {
        "even": lambda a, b: a * np.cos(at) + b * np.cos(2 * at),
        "odd": lambda a, b: a * np.sin(at) + b * np.sin(2 * at),
    }
    made = made_of({f"q{n}": waves[kind](sizes[n], sizes[n - 1]) for n, kind in enumerate(kinds)})
    about = mirror(made)
    assert about is not None
    shown = half(made, about, near).values
    sign = [-1.0 if column in about.odd else 1.0 for column in made.columns[1:]]
    said = told(made, about, near)
    whole = float(re.search(r"换为 (\d+)°", said.zh)[1])  # type: ignore[index]
    listed = {round(angle % 360.0): values for angle, *values in shown}
    follows = {
        round((whole - angle) % 360.0): [s * v for s, v in zip(sign, values, strict=True)] for angle, *values in shown
    }
    for angle, *values in made.values:
        assert (listed | follows if round(angle) not in listed else listed)[round(angle)] == pytest.approx(
            values, abs=1e-4
        )
    assert len(shown) in (18, 19) and -180 <= shown[0, 0] < shown[-1, 0] <= 360
    apart = min(abs((angle - near + 180) % 360 - 180) for angle in shown[:, 0])
    assert apart <= 5 + 1e-6, "the given position is among the rows"
    assert all((f"${c.symbol}$" in said.zh) == (c in about.odd) for c in made.columns[1:])


@given(share=st.floats(0.01, 1.0), turn=st.floats(0.3, 2.8))
def test_what_is_not_symmetrical_is_listed_whole(share: float, turn: float) -> None:
    wave = [cos(pi * a / 180) + share * sin(2 * pi * a / 180 + turn) + share * cos(3 * pi * a / 180) for a in _WHOLE]
    assert mirror(made_of({"q": wave})) is None


@pytest.mark.parametrize(("lang", "said"), [("zh", "$φ_1$ 换为 360° − $φ_1$ 时"), ("en", "360° − $φ_1$ in place of")])
def test_an_in_line_slider_crank_is_listed_for_half_a_turn(lang: Lang, said: str) -> None:
    kept, whole = Noted(lang), Noted(lang)
    with in_small():
        parts = results.sections(studied("rack-drives-pinion"), kept)
        results.sections(studied("curv-5"), whole)
    assert said in parts[0]["words"].replace("{", "").replace("}", "")
    assert [made.rows[-1][0] for made in kept.made] == ["180", "90"], "the second in two blocks"
    assert whole.made[0].rows[-1][0] == "350"


def test_a_straight_path_is_said_and_has_no_figure() -> None:
    for name, drawn in (("rack-drives-pinion", False), ("3-9", True)):
        kept = Noted("zh")
        with in_small():
            motion = next(one for one in reversed(results.sections(studied(name), kept)) if one["before"])
        where = kept.through_all(motion["before"])
        assert f"{'以及该点的轨迹' if drawn else '简图'}见{where}" in motion["words"]
        assert ("、" in where) is drawn


@pytest.mark.parametrize("name", few(("shaper-flywheel", "A-26", "A-27"), 3))
def test_the_quotient_of_a_peak_is_that_of_the_two_numbers_beside_it(name: str) -> None:
    it, kept = studied(name), press()
    table(it, kept, causes(it, conditioning(it)))
    (made,) = kept.made
    for row in made.rows:
        assert float(row[7]) == pytest.approx(float(row[5]) / float(row[6]), abs=0.006)
        assert len(row[2].strip("−").replace(".", "").lstrip("0")) >= 4, "with its zeros, as in the table of extremes"
    assert len({shown(row[2]) for row in made.rows}) > 1


def test_a_value_in_prose_has_the_figures_of_the_table() -> None:
    it = studied("curv-5")
    assert in_prose(it, "alpha_2", -0.98797) == "−0.9880 rad/s²" and in_prose(it, "alpha_2", 0.5) == "0.5 rad/s²"


@each(DRAFTED)
def test_no_error_is_told_as_half_of_what_was_read_or_more(name: str) -> None:
    """α_4 = 0.3 rad/s² beside an expected error of 77 %."""
    one = drafted(name)
    for made in readings_tables(one, "en") if one is not None else ():
        told = [n for n, head in enumerate(made.header) if head in ("Expected error /%", "Expected error")]
        shares = [row[n] for n in told for row in made.rows]
        shares = [cell.removesuffix(" %") for cell in shares if re.fullmatch(r"[\d.]+( %)?", cell)]
        assert all(float(cell) < 50 for cell in shares), shares


def test_what_could_not_be_read_is_said_once_below_the_table() -> None:
    one = drafted("A-26")
    assert one is not None and unread_words(one.answers.values(), "zh").startswith("$α_4$ 的误差达读数的一半以上")
    rows = {row[0]: row for made in readings_tables(one, "zh") for row in made.rows}
    assert rows["$α_4$"][-2:] == ("—", "—") and rows["$α_5$"][-1] != "—"


def test_of_the_comparison_one_curve_is_drawn_of_what_deviates_most() -> None:
    it, kept, found = studied("3-9"), Recorder(), stations("3-9")
    chapter = comparison.chapter(it, kept, found)
    shares = {line[0]: float(line[3]) for line in kept.lines}
    assert len(chapter["figures"]) == 1 and shares[chapter["farthest"]] == max(shares.values())


@pytest.mark.parametrize(("name", "along"), [("shaper-flywheel", "x"), ("slider-crank-dynamic", "")])
def test_a_force_along_one_line_is_said_to_be_and_has_no_hodograph(name: str, along: str) -> None:
    kept = Noted("en")
    with in_small():
        balance = chapters.chapters(studied(name), kept, machine(name))["told"][-1]["sections"][0]
    assert (f"nearly along ${along}$" in balance["words"][0]) is bool(along)
    assert ("hodograph" in balance["words"][0]) is not bool(along)
    assert len(balance["figures"]) == (2 if along else 3)
