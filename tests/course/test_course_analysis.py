"""Chapters 8 and 9 of the course report: what they say of full rotation,
limits, peaks and transmission angles is true of the mechanism."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from math import cos, degrees, pi, radians, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.laws import few
from tests.studies import solved, studied
from vecpoly import oracle
from vecpoly.cycle import Spot, cycle, path, path_sentences
from vecpoly.findings.advice import advice
from vecpoly.findings.conditioning import Conditioning, conditioning, determinant
from vecpoly.findings.grashof import full_rotation
from vecpoly.findings.limits import limit
from vecpoly.findings.motion import motion
from vecpoly.findings.output_links import ends
from vecpoly.findings.study.study import study
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import load, loads
from vecpoly.report.course.analysis.conclusion import conclusion
from vecpoly.report.course.analysis.peak_remarks import remarks
from vecpoly.report.course.analysis.why_peaks import Cause, causes
from vecpoly.report.course.checks.comparison import Compared
from vecpoly.solution import solve

NONE = Compared((), (), ())


@cache
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


@pytest.mark.parametrize(
    ("name", "point"), [("B-24", "E"), ("B-26.5", "E"), ("B-29.5", "E"), ("A-26", "E"), ("A-30", "G")]
)
def test_a_path_bends_the_other_way_where_the_curvature_changes_its_sign(name: str, point: str) -> None:
    """v × a of the oracle, a hundredth of a degree to either side of every inflection, and nowhere else."""
    turn = cycle(load(name))
    found = path(turn, point)
    phi = np.radians(np.arange(0.0, 360.0, 0.25))
    bend = curvature(turn.mech, point, phi)
    assert len(found.inflections) == int(np.sum(bend[:-1] * bend[1:] < 0))
    for q in found.inflections:
        before, after = curvature(turn.mech, point, np.array([q - 1e-4, q + 1e-4]))
        assert before * after < 0
    assert "卵形" not in "".join(w.zh for w in path_sentences(turn, found))


def curvature(mech: Mechanism, point: str, phi: NDArray[np.float64]) -> NDArray[np.float64]:
    moved = oracle.solve(mech, phi)
    return np.asarray((np.conj(moved.velocity(point)) * moved.acceleration(point)).imag)


def test_a_figure_of_eight_through_a_pivot_and_a_convex_oval_are_told() -> None:
    eight, oval = cycle(load("A-26")), cycle(load("3-5"))
    assert "恰为固定铰链 $D$" in "".join(w.zh for w in path_sentences(eight, path(eight, "E")))
    convex = path(oval, "E")
    assert not convex.inflections and "卵形" in "".join(w.zh for w in path_sentences(oval, convex))


@pytest.mark.parametrize("name", few(["A-26", "B-24", "B-29.5", "D-1", "D-2", "3-5", "3-6", "3-12"], 4))
def test_at_a_limit_crank_and_coupler_are_in_one_line(name: str) -> None:
    """|AC| of the oracle is the sum or the difference of the lengths, as the sentence says."""
    it = studied(name)
    told = 0
    for spot, why in ((spot, limit(it, s.key, spot.phi)) for s in it.facts.strokes for spot in (s.lower, s.upper)):
        if why is None or why.kind not in ("folded", "stretched"):
            continue
        length = re.search(r"= ([\d.]+) mm", why.words.en)
        pair = re.search(r"\$([A-Z])([A-Z])\$ = \$l", why.words.en)
        assert length and pair
        moved = oracle.solve(it.mech, np.array([spot.phi]))
        assert 1e3 * float(abs(moved.position(pair[1]) - moved.position(pair[2]))[0]) == pytest.approx(
            float(length[1]), rel=5e-4
        )
        told += 1
    assert told >= 2


def test_limits_of_later_groups_have_their_reasons() -> None:
    """At every limit of A-26's link 5 the coupler's pin moves at right angles to it;
    the six-bar's slider stands because its rocker does."""
    it = studied("A-26")
    swing = next(s for s in it.facts.swings if s.key == "phi_5")
    for spot in (*swing.maxima, *swing.minima):
        moved = oracle.solve(it.mech, np.array([spot.phi]))
        along = moved.position("F") - moved.position("E")
        assert abs((np.conj(moved.velocity("E")) * along).real[0]) < 1e-6 * abs(along[0])
        why = limit(it, "phi_5", spot.phi)
        assert why is not None and why.words.zh == "$v_{E}$ ⊥ $EF$"
    shaper = studied("six-bar-dynamic")
    assert [getattr(limit(shaper, s.key, s.lower.phi), "kind", "") for s in shaper.facts.strokes] == ["square", "still"]


def test_the_name_of_every_loop_follows_from_its_lengths() -> None:
    kinds = {
        "A-27": ["双曲柄"],
        "B-24": ["曲柄摇杆"],
        "3-4a": ["双摇杆", "双摇杆"],
        "A-16": ["转动导杆", "转动导杆"],
        "3-7a": ["摆动导杆"],
        "D-2": ["对心曲柄滑块"],
        "six-bar-dynamic": ["摆动导杆", "不满足曲柄存在条件"],
    }
    for name, expected in kinds.items():
        told = [w.zh for w in full_rotation(studied(name))]
        assert len(told) == len(expected) and all(kind in text for kind, text in zip(expected, told, strict=True)), name


@pytest.mark.parametrize(
    ("name", "last"),
    few(
        [
            ("A-16", ("5",)),
            ("A-26", ("5",)),
            ("A-27", ("5",)),
            ("A-30", ("4", "6", "8")),
            ("B-24", ("5",)),
            ("3-5", ("5",)),
            ("3-6", ("3",)),
        ],
        4,
    ),
)
def test_the_output_is_the_end_of_the_chain(name: str, last: tuple[str, ...]) -> None:
    assert ends(studied(name)) == last
    for link in last:
        assert re.search(f"输出构件 {link}[：整往每]", said(name).replace(f"{link} ", link))


@pytest.mark.parametrize("name", few(["A-16", "A-26", "A-27", "A-30", "B-24", "3-5", "3-6"], 2))
def test_a_determinant_is_a_product_of_lengths_and_the_sine_of_gamma(name: str) -> None:
    """So one bound, 40° to a whole degree, decides for both, and the verdict is one."""
    it = studied(name)
    phi = np.radians(np.arange(0.0, 360.0, 7.0))
    for one in (g for g in conditioning(it) if g.gamma is not None):
        assert one.gamma is not None
        sine = np.sin(np.asarray(it.whole.at(one.gamma.key, phi), np.float64))
        share = determinant(it, one.group, phi) / sine
        assert np.ptp(share) < 1e-9 * share.max()
        assert one.is_poor == (one.gamma.least.value < radians(39.5))


def test_the_peaks_of_one_rate_may_have_opposite_causes() -> None:
    """A-27: at 90.7° the pin is fast, at 190.3° the arm is short."""
    it = studied("A-27")
    told = [one for one in causes(it, conditioning(it)) if one.key == "omega_5"]
    assert [one.words.en for one in told] == ["numerator large", "divisor small"]
    for one in told:
        moved = oracle.solve(it.mech, np.array([one.spot.phi]))
        arm = moved.position("F") - moved.position("G")
        across = abs((np.conj(arm) * moved.velocity("F")).imag[0]) / abs(arm[0])
        assert across / abs(arm[0]) == pytest.approx(abs(one.spot.value), rel=1e-9)
    assert "3.858 m/s" in said("A-27") and "84.37 mm" in said("A-27") and "32.85 mm" in said("A-27")


@pytest.mark.parametrize("name", few(["A-26", "B-24", "A-30", "A-27"], 4))
def test_the_lengths_advised_give_the_angle_that_is_promised(name: str) -> None:
    """The distance of the outer pins, taken from the oracle, with the advised equal lengths in the cosine rule."""
    it = studied(name)
    moved = oracle.solve(it.mech, np.radians(np.arange(0.0, 360.0, 0.05)))
    frame = it.mech.frame
    count = 0
    for text in (w.en for g in conditioning(it) for w in advice(it, g)):
        found = re.search(r"By \$([A-Z])([A-Z])\^2\$", text)
        if not found:
            continue
        p, q = (moved.position(x) if x not in frame else frame[x] for x in found.groups())
        far = np.abs(p - q)
        equal = re.search(r"\$ = ([\d.]+) mm(?: would|\))", text)
        angle = re.search(r"minimum angle of this group to ([\d.]+)°|= ([\d.]+)° at best", text)
        assert equal and angle
        length = float(equal[1]) / 1e3
        gamma = np.degrees(np.arccos(1 - far**2 / (2 * length**2)))
        assert float(np.minimum(gamma, 180 - gamma).min()) == pytest.approx(float(angle[1] or angle[2]), abs=0.15)
        count += 1
    assert count


def test_the_range_that_gives_forty_degrees_is_the_cosine_rule() -> None:
    """The lecturer's number for A-27: BD ≥ 230.9 mm."""
    least = 1e3 * sqrt(0.35**2 + 0.32**2 - 2 * 0.35 * 0.32 * cos(radians(40)))
    assert f"{least:.1f} 至" in said("A-27") and "$A$、$B$、$D$ 共线" in said("A-27")


@pytest.mark.parametrize("name", few(["A-16", "A-26", "A-27", "A-30", "B-29.5", "D-1", "3-5"], 4))
def test_smooth_motion_is_not_called_impact_and_angles_have_one_decimal(name: str) -> None:
    text = said(name)
    assert "冲击倾向" not in text and "既无刚性冲击也无柔性冲击" in text
    assert not re.search(r"\d\.\d{3,}°", text) and "360°" not in text.replace("360° 折回", "")


def test_the_two_places_of_a_least_angle_are_both_told() -> None:
    from vecpoly.findings.transmission import transmission

    it = studied("A-16")
    assert "0°、180°" in transmission(it, it.facts.transmissions).zh


def test_a_transmission_angle_is_acute_in_table_facts_and_terminal() -> None:
    from vecpoly.cli.whole_turn import _row
    from vecpoly.cycle import table

    turn = cycle(load("A-26"))
    values = table(turn, ("gamma_45",)).values[:, 1]
    assert 34.6 < values.min() < 34.8 and values.max() <= 90.0
    assert _row(turn, "gamma_45")[2].startswith("90") and _row(turn, "gamma_45")[4].startswith("34.66")


def test_a_dwell_is_seen() -> None:
    """A-30: from 152.2° to 218.7° link 4 moves by a third of a degree."""
    it = studied("A-30")
    stays = np.degrees(np.unwrap(oracle.solve(it.mech, np.radians(np.linspace(152.2, 218.7, 400))).angle("4")))
    assert np.ptp(stays) == pytest.approx(0.34, abs=0.02) and "近似停歇" in said("A-30")


FREE = """
id: free
title: {zh: 移动导杆机构, en: A slide that drives a slotted link}
frame: {D: [0 mm, 80 mm]}
links:
  1: {block: A}
  2: {slot: D}
  3: {block: A}
joints: [1 slides on y = 0 mm, 3 slides in 2]
input: {link: 1, s: 50 mm, v: 1 m/s}
find: [omega_2, alpha_2]
"""


def test_a_slide_without_limits_is_told_so() -> None:
    it = study(solve(loads(FREE), repeats=0))
    assert it.facts.unlimited == (True, True)
    told = [w.zh for w in motion(it, conditioning(it))]
    assert any("不受杆组限制" in text for text in told) and not any("死点" in text or "只能在" in text for text in told)
    assert not any("死点" in w.zh for w in conclusion(it, conditioning(it), NONE, (), ""))


def test_a_link_that_turns_back_is_not_said_to_have_no_return() -> None:
    it = studied("3-3")
    low = it.extremes("omega_3").lowest
    assert low is not None and low.value < 0
    output = next(w for w in conclusion(it, conditioning(it), NONE, (), "") if "输出构件 3" in w.zh)
    assert "中途反转" in output.zh and "无急回" not in output.zh


def test_the_drive_s_sweep_over_k_is_a_turn() -> None:
    for name in ("A-26", "B-24", "3-5", "D-1"):
        for stroke in studied(name).facts.strokes:
            assert stroke.forth + stroke.back == pytest.approx(2 * pi)
            assert (
                "$K$ = "
                f"{degrees(max(stroke.forth, stroke.back)):.1f}°/{degrees(min(stroke.forth, stroke.back)):.1f}° "
                f"= {stroke.ratio:.3f}" in said(name)
            )


def test_peaks_of_a_group_that_is_solved_by_iteration_are_remarked_on() -> None:
    it = study(solved("class-iii"))
    vars(it)["whole"] = replace(it.whole, whole=True)  # as if its crank went right round
    iterated = next(group for group in it.model.groups if group.loops is not None)
    poor = Conditioning(group=iterated, least=0.001, largest=0.1, lows=(1.0,), tops=(0.0,))
    peaks = [Cause(key=key, spot=Spot(poor.phi, 1.0), by=poor, down=0.2, up=1.0) for key in ("omega_2", "alpha_2")]
    assert poor.is_poor
    assert any("$ω_{2}$ (" in words.en and "$α_{2}$ (" in words.en for words in remarks(it, peaks))
