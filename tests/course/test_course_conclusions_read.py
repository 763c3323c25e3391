"""Conclusions are sentences that evaluate: no strings of numbers, no rule without its figure, no table of one row."""

from __future__ import annotations

import re
from math import degrees

import pytest

from tests.laws import few
from tests.studies import course_text, course_words, studied
from vecpoly.findings.conditioning import conditioning
from vecpoly.report.course.analysis.agreement import agreement
from vecpoly.report.course.analysis.conclusion import conclusion
from vecpoly.report.course.analysis.outputs import output
from vecpoly.report.course.analysis.stated import stated
from vecpoly.report.course.checks.comparison import Compared
from vecpoly.report.flow.table import DataTable
from vecpoly.words import Lang

NONE = Compared((), (), ())


def concluded(name: str) -> str:
    it = studied(name)
    return "\n".join(words.en for words in conclusion(it, conditioning(it), NONE, (), ""))


def test_the_conclusion_tells_the_least_transmission_angle_of_the_table_and_sets_it_beside_what_is_demanded() -> None:
    (one,) = conditioning(studied("D-3-knife"))
    assert one.gamma is not None and f"{degrees(one.gamma.least.value):.1f}" == "68.0"
    told = concluded("D-3-knife")
    assert "the minimum transmission angle is 68.0°" in told and "above the 40° usually demanded" in told
    assert "40° and more" not in told


def test_without_transmission_angles_the_least_determinant_is_told() -> None:
    share = min(one.ratio for one in conditioning(studied("3-9")))
    assert f"its determinant does not fall below {100 * share:.0f} %" in concluded("3-9")


@pytest.mark.parametrize("name", few(["D-3-knife", "stephenson-valve-gear"], 2))
def test_no_conclusion_strings_two_numbers_together_with_a_stroke(name: str) -> None:
    assert not re.search(r"\d[°)]?/[\d(]", concluded(name))


def test_how_far_the_drawing_is_from_exact_is_the_largest_deviation_of_the_table() -> None:
    it = studied("D-3-knife")
    answers = list(it.solution.answers.values())
    (v,) = (one for one in answers if one.key == "v_E")
    told = re.search(r"各值最多相差 ([\d.]+) %，点的位置最多相差 ([\d.]+) mm", agreement(answers).zh)
    assert told and float(told[1]) == pytest.approx(100 * abs(v.relative_deviation), abs=0.011)
    assert agreement([]).zh == "" == agreement([]).en


def test_what_agrees_in_all_digits_is_said_to_and_what_stands_still_turns_no_way() -> None:
    (same,), (still,) = stated(studied("8-2g")), stated(studied("oldham-coupling"))
    assert "agree in all digits told" in same.en and "no more than 0" not in same.en + same.zh
    assert "$α_3$ = 0。" in still.zh and "$ω_3$ = 10.0 rad/s，逆时针" in still.zh


def test_many_instant_centres_are_told_by_their_number() -> None:
    (said,) = stated(studied("3-1d"))
    listed = said.zh.partition("图解与解析相比")[0]  # behind it the few that are hardly found are named
    assert "全部 15 个瞬心" in listed and "(" not in said.zh and listed.count("$P_") == 2


def test_the_one_link_of_which_both_rates_are_asked_is_told_beside_the_output() -> None:
    (said,) = stated(studied("stephenson-valve-gear"))
    assert "$ω_4$ = " in said.zh and "$α_4$ = " in said.zh and "$ω_2$" not in said.zh


def test_an_output_that_goes_to_and_fro_is_told_by_its_greatest_sizes_with_all_their_places() -> None:
    (said,) = output(studied("D-3-knife"), "2")
    assert "$|v_{23}|$ 最大 0.1604 m/s（$φ_{1}$ = 18.4°、161.6°）" in said.zh and "无急回特性" in said.zh


def test_a_link_that_is_told_by_its_rates_alone_has_them_behind_a_colon_and_an_even_crank_has_no_sentence() -> None:
    (rates,), (both,) = (output(studied("3-9"), link) for link in "23")
    assert rates.en.startswith("Output link 2: the maximum $|ω_{2}|$ is ") and rates.zh.startswith("输出构件 2：$")
    assert both.en.startswith("Output link 3 oscillates") and both.en.count("; the maximum") == 1
    assert [*output(studied("3-9"), "1")] == []


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_what_would_be_a_table_of_one_row_is_a_sentence(lang: Lang) -> None:
    text, objects = course_words("D-3-knife", lang)
    for match in re.finditer(r'<table ref="(\w+)"', text):
        table = objects.named[match[1]]
        assert isinstance(table, DataTable)
        assert len(table.rows) > 1 or not re.match(r"(表|Table) [78]-", table.caption), table.caption
    for part in ("68.0°", "0.927"):
        assert part in text, part
    (up, down, quotient) = re.search(r"(\d\.\d\d)/(\d\.\d\d) = (\d\.\d\d)", text).groups()  # type: ignore[union-attr]
    assert float(up) / float(down) == pytest.approx(float(quotient), abs=0.006)
    assert ("均方根偏差为 " if lang == "zh" else " rms.") in text


def test_several_peaks_and_groups_still_have_their_tables() -> None:
    text, objects = course_text("A-27", "zh")
    captions = [one.caption for one in objects.named.values() if isinstance(one, DataTable)]
    assert sum("峰值及其成因" in one for one in captions) == 1 and "均方根值 $N_m$、$D_m$" in text
    assert sum("杆组线性方程组的行列式" in one for one in captions) == 1


def test_dead_points_are_told_where_they_are_and_an_end_of_the_working_range_is_no_maximum() -> None:
    it, told = studied("curv-3"), concluded("curv-3")
    places = [it.where(spot.phi).split(" = ")[1] for spot in it.facts.dead]
    assert len(places) == 2 and all(place in told for place in places)
    assert "not true maxima" in told
    travels = next(line for line in told.splitlines() if line.startswith("Point"))
    assert travels.count("an end of the working range") == 2


def test_a_moment_that_is_found_by_three_ways_is_told_once_with_the_difference() -> None:
    (told,) = (words.en for words in stated(studied("six-bar-dynamic")))
    assert told.count("$M_{1}$") == 1 and "(force polygons)" in told and "(Zhukovsky lever)" in told
    assert re.search(r"they (agree|differ by at most \d+\.\d %)", told)
