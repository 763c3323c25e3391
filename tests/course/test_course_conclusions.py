"""Chapters 8 and 9 of the course report: peaks, lengths that are advised, and what was asked, told as they are."""

from __future__ import annotations

import re
from math import degrees, radians

import numpy as np
import pytest

from tests.studies import studied
from vecpoly import oracle
from vecpoly.cycle import cycle, extremes, facts
from vecpoly.findings.advice import advice
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.motion import motion
from vecpoly.findings.strokes import limits_and_ratio
from vecpoly.findings.study.study import study
from vecpoly.problem.load import load, loads
from vecpoly.report.course.analysis.conclusion import conclusion
from vecpoly.report.course.analysis.peak_remarks import remarks
from vecpoly.report.course.analysis.why_peaks import causes, flat
from vecpoly.report.course.checks.comparison import Compared
from vecpoly.solution import solve

NONE = Compared((), (), ())


def said(name: str) -> str:
    it = studied(name)
    groups = conditioning(it)
    return "\n".join(
        w.zh
        for w in (
            *motion(it, groups),
            *remarks(it, causes(it, groups)),
            *(w for g in groups for w in advice(it, g)),
            *conclusion(it, groups, NONE, (), "8.3"),
        )
    )


def test_the_analysis_of_unlike_numbers_is_not_alike_and_of_like_numbers_not_unlike() -> None:
    """A-26: l_BC = l_CD make ω2, ω3 and α2, α3 mirror images of each other;
    what is said of the one is said of the other."""
    told = {one.key: one for one in causes(studied("A-26"), conditioning(studied("A-26")))}
    for stem in ("omega", "alpha"):
        two, three = told[f"{stem}_2"], told[f"{stem}_3"]
        assert two.up == pytest.approx(three.up, rel=1e-9) and two.down == pytest.approx(three.down, rel=1e-9)
        assert two.words == three.words


@pytest.mark.parametrize("name", ["A-16", "A-26", "A-27", "B-24", "3-5", "D-1"])
def test_a_sine_is_no_peak(name: str) -> None:
    """Of every quantity in the table the greatest value is 1.8 times its rms on a grid of our own; further peaks are
    1.5 times it."""
    it = studied(name)
    phi = np.radians(np.arange(0.0, 360.0, 0.25))
    told = causes(it, conditioning(it))
    for key in {one.key for one in told}:
        usual = float(np.sqrt(np.mean(np.asarray(it.whole.at(key, phi), np.float64) ** 2)))
        sizes = [abs(one.spot.value) / usual for one in told if one.key == key]
        assert max(sizes) > 1.79 and min(sizes) > 1.49
    assert not {"omega_2", "omega_3", "omega_4"} & {one.key for one in told} or name != "3-5"


def test_what_has_no_peaks_is_told_in_numbers() -> None:
    it = studied("4-3a")
    groups = conditioning(it)
    assert not causes(it, groups)
    said_ = "".join(w.zh for w in flat(it, groups))
    assert "没有突出的峰值" in said_ and "1.41" in said_
    assert not list(flat(studied("A-26"), conditioning(studied("A-26"))))


def test_all_four_peaks_of_a_27_are_told() -> None:
    values = [
        round(one.spot.value, 1)
        for one in causes(studied("A-27"), conditioning(studied("A-27")))
        if one.key == "alpha_5"
    ]
    assert values == [679.6, -736.2, 433.3, -444.3]
    assert "由 178.0° 转到 202.9°" in said("A-27")


def test_peaks_about_a_singular_place_are_told_to_be_there() -> None:
    """B-24: five peaks of links 4 and 5 within 13.3° of the least γ45."""
    it = studied("B-24")
    text = next(w.zh for w in remarks(it, causes(it, conditioning(it))) if "γ_{45}" in w.zh)
    places = [float(x) for x in re.findall(r"([\d.]+)°", text.split("的峰值在")[0])]
    least, reach = (float(x) for x in re.findall(r"([\d.]+)°", text.split("的峰值在")[1])[:2])
    assert len(places) == 5 and max(abs(q - least) for q in places) <= reach + 0.05


def test_lengths_that_are_advised_run() -> None:
    """What is promised of them is true of the mechanism of a problem file of its own."""
    text = "".join(w.zh for g in conditioning(studied("A-26")) for w in advice(studied("A-26"), g))
    assert "在全部位置均可装配" in text
    other = cycle(loads("id: changed\nextends: A-26\nlinks: {4: {EF: 281.3 mm}, 5: {GF: 281.3 mm}}\n"))
    assert other.whole and min(t.least.value for t in facts(other).transmissions) > radians(39.99)
    found = extremes(other, "alpha_5")
    assert found.highest and found.lowest
    top = max(abs(found.highest.value), abs(found.lowest.value))
    said_ = re.search(r"\$\|α_\{5\}\|\$ 最大值由 [\d.]+ rad/s² 变为 ([\d.]+)", text)
    assert said_ and float(said_[1]) == pytest.approx(top, rel=1e-3)


def test_an_angle_that_is_forty_degrees_to_a_whole_degree_is_acceptable_and_gets_no_cure() -> None:
    it = studied("3-5")
    groups = conditioning(it)
    assert min(degrees(g.gamma.least.value) for g in groups if g.gamma) == pytest.approx(39.9, abs=0.05)
    assert not [w for g in groups for w in advice(it, g)]
    assert "略低于一般要求的 40°" in "".join(w.zh for w in conclusion(it, groups, NONE, (), ""))


CHANGED = """
id: changed
title: {{zh: 改, en: changed}}
frame: {{A: [0 mm, 0 mm], D: [87.5 mm, 0 mm], G: [153.5 mm, 41.7 mm]}}
links:
  1: {{AB: 24 mm}}
  2: {{BC: 64.16 mm, E: {{{placed}}}}}
  3: {{DC: 64.16 mm}}
  4: {{EF: 34.4 mm}}
  5: {{GF: 25 mm}}
input: {{link: 1, phi: 60 deg, omega: 1 rad/s ccw}}
branch: [C left of BD, F right of EG]
find: [omega_5]
"""


def test_lengths_with_which_the_next_group_cannot_be_assembled_are_not_advised() -> None:
    """B-24 with l_BC = l_CD = 64.16 mm, E on link 2 left either beside C or beside B:
    the oracle cannot assemble it all round."""
    text = "".join(w.zh for g in conditioning(studied("B-24")) for w in advice(studied("B-24"), g))
    shares = re.search(r"有 (\d+) %～(\d+) % 的位置不能装配", text)
    assert shares and "须同时改变后续杆组" in text
    link = studied("B-24").mech.link("2").points
    at, turn = abs(link["E"] - link["B"]), np.degrees(np.angle((link["E"] - link["B"]) / (link["C"] - link["B"])))
    phi = np.radians(np.arange(0.0, 360.0, 0.5))
    lost = []
    for placed in ("CE: 65 mm, angle: 120 deg from CB", f"BE: {1e3 * at:.9f} mm, angle: {turn:.9f} deg from BC"):
        changed = loads(CHANGED.format(placed=placed)).mechanism
        lost.append(100 * float(np.mean(np.isnan(oracle.solve(changed, phi, strict=False).angle("5")))))
    assert sorted(lost) == pytest.approx([float(share) for share in shares.groups()], abs=0.6)


def test_the_conclusion_opens_with_what_was_asked() -> None:
    """Drawn and exact at the given position: the exact by the oracle, the drawn off the sheet."""
    it = study(solve(load("3-5"), repeats=0))
    first = next(iter(conclusion(it, conditioning(it), NONE, (), "")))
    here = oracle.solve(it.mech)
    v, a = complex(here.velocity("F")), complex(here.acceleration("F"))
    assert v.real < 0 < a.real
    drawn = it.given.answers["v_F"].drawn
    assert f"= {drawn:.3f} m/s，向左" in first.zh and " m/s²，向右" in first.zh
    off = re.search(r"各值最多相差 ([\d.]+) %。", first.zh)
    assert off and 100 * abs(drawn / abs(v) - 1) <= float(off[1]) + 0.1 and "/" not in first.zh.replace("m/s", "")
    assert sum("0.7394" in w.zh for w in conclusion(it, conditioning(it), NONE, (), "")) == 1


def test_equal_extremes_are_told_with_all_their_places() -> None:
    """A-26: the curve of E is symmetrical about the position of the crank along AD."""
    text, it = said("A-26"), studied("A-26")
    assert "47.2°、220.3°" in text and "123.1°、144.4°" in text and "关于过 $D$ 的一条直线对称" in text
    line = np.angle(it.mech.frame["D"] - it.mech.frame["A"])
    moved = [oracle.solve(it.mech, line + sign * np.linspace(0.1, 3.1, 31)) for sign in (1.0, -1.0)]
    assert np.allclose(np.abs(moved[0].velocity("E")), np.abs(moved[1].velocity("E")), rtol=1e-9)
    far = [np.abs(m.position("E") - it.mech.frame["D"]) for m in moved]
    assert np.allclose(far[0], far[1], rtol=1e-9)
    assert "对称；" not in said("B-24")


def test_strokes_are_the_differences_of_the_limits_that_are_printed() -> None:
    text = next(w.zh for w in motion(studied("A-26"), conditioning(studied("A-26"))) if "往复 2 次" in w.zh)
    limits = [(float(a), float(b)) for a, b in re.findall(r"([\d.]+)° \(([\d.]+)°\)", text)]
    strokes = [(float(a), float(b)) for a, b in re.findall(r"([\d.]+)° / ([\d.]+)°", text)]
    assert len(limits) == len(strokes) == 4
    for (one, at), (two, to), (swing, gap) in zip(limits, (*limits[1:], limits[0]), strokes, strict=True):
        assert swing == pytest.approx(abs(two - one), abs=1e-9) and gap == pytest.approx((to - at) % 360, abs=1e-9)


def test_the_margin_told_in_the_conclusion_is_the_oracle_s() -> None:
    """B-24: the rod EF a little longer than told cannot be assembled there, a little shorter it can."""
    it = studied("B-24")
    text = next(w.zh for w in conclusion(it, conditioning(it), NONE, (), "") if "对尺寸误差敏感" in w.zh)
    found = re.search(r"l_\{EF\}\$ 单独改变 \+([\d.]+) mm 时，在 \$φ_\{1\}\$ = ([\d.]+)°", text)
    assert found
    for more, stands in ((0.03, False), (-0.03, True)):
        length = 34.4 + float(found[1]) + more
        changed = loads(f"id: longer\nextends: B-24\nlinks: {{4: {{EF: {length} mm}}}}\n").mechanism
        angle = oracle.solve(changed, np.radians([float(found[2])]), strict=False).angle("5")
        assert bool(np.isfinite(angle).all()) is stands


def test_a_rocker_between_drive_and_output_is_called_intermediate_and_the_output_is_not() -> None:
    it = studied("3-5")
    rocker, slider = (limits_and_ratio(it, stroke) for stroke in it.facts.strokes)
    assert rocker.en.startswith("Intermediate link 3: ") and rocker.zh.startswith("中间构件 3：")
    assert slider.en.startswith("The travel $s_{56}$") and slider.zh.startswith("$s_{56}$")


@pytest.mark.parametrize("name", ["A-26", "B-24"])
def test_the_lengths_that_are_tried_stand_whole_in_the_sentence_on_them(name: str) -> None:
    told = [w.en for g in conditioning(studied(name)) for w in advice(studied(name), g)]
    tried = [text.partition(" would raise")[0].rpartition(". ")[2] for text in told if " would raise" in text]
    assert tried and all(re.fullmatch(r"(\$l_\{[A-Z]+\}\$ = )+[\d.]+ mm", one) for one in tried), tried
