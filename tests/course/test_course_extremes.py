"""What a curve marks as its greatest and least value is what the text and the table tell, at the same place."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from tests.laws import few
from tests.pocket import sums
from tests.studies import machine, studied
from vecpoly.algebra.quantity import number
from vecpoly.curves import peaks
from vecpoly.cycle import Column
from vecpoly.findings.machine.running import Running
from vecpoly.findings.strokes import _angles
from vecpoly.mechanism.asked.machine import equivalents
from vecpoly.report.course.machine.flywheel import _divided
from vecpoly.report.course.machine.work import _told
from vecpoly.report.course.results.plots import curve
from vecpoly.words import Lang

BOTH: tuple[Lang, ...] = ("zh", "en")

NAMES = ("A-27", "3-5", "B-24", "shaper-flywheel")


@pytest.mark.parametrize("name", few(NAMES, 4))
def test_a_curve_marks_the_extremes_that_are_told(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The least J_e of a shaper occurs twice a turn: the curve names both places."""
    it, marked = studied(name), list[tuple[str, float, float]]()
    told = peaks.told

    def heard(alike: Sequence[peaks.Spot], drive: Column, of: str) -> str:
        marked.extend((key, *spot) for spot in alike)
        return told(alike, drive, of)

    monkeypatch.setattr(peaks, "told", heard)
    reduced = [equivalents(it.mech)[0].inertia.key] if name == "shaper-flywheel" else []
    for key in (*(f"{stem}_{link}" for link in it.links for stem in ("omega", "alpha")), *reduced):
        if it.varies(key):
            curve(it, "en", [key])
    sure = 0
    for key, place, value in marked:
        found, info = it.extremes(key), it.whole.info(key)
        assert found.highest is not None and found.lowest is not None
        tops = [(it.turn.drive.factor * top.phi, info.factor * top.value) for top in (found.highest, found.lowest)]
        ends = any(top.end for top in (found.highest, found.lowest))
        assert (place, value) in tops or ends or any(abs(value - top) < 1e-9 * abs(tops[0][1]) for _, top in tops), key
        sure += (place, value) in tops
    assert sure >= 4
    if reduced:
        at = [place for key, place, _ in marked if key == reduced[0]]
        assert any(abs(place - 196.8) < 0.1 for place in at) and any(abs(place - 343.2) < 0.1 for place in at)


def test_four_figures_are_four_figures() -> None:
    assert [peaks.figures(value) for value in (9.9996, 9.9994, 0.099996, 99.996, -9999.6)] == [
        "10.00",
        "9.999",
        "0.1000",
        "100.0",
        "−10000",
    ]


def test_two_equally_high_spots_are_told_at_the_first_of_them() -> None:
    spots = [(10.0, 1.0 - 1e-7), (100.0, -1.0), (190.0, 1.0), (280.0, -1.0 - 1e-7)]
    assert [alike for alike, _ in peaks.extremes(spots)] == [[spots[0], spots[2]], [spots[1], spots[3]]]


@pytest.mark.parametrize(("forth", "back"), [(200.27, 159.73), (180.2, 179.8), (260.234, 99.766), (213.85, 146.15)])
def test_k_follows_from_the_angles_printed(forth: float, back: float) -> None:
    one, other, ratio = _angles(forth, back)
    assert f"{forth / back:.3f}" == ratio and abs(float(one) / float(other) - float(ratio)) <= 0.5e-3


@pytest.mark.parametrize("name", few(["press-flywheel", "shaper-flywheel", "engine-flywheel"], 3))
def test_the_surplus_of_work_and_the_flywheel_follow_from_the_figures_printed(name: str) -> None:
    """ΔW = E_max − E_min, and J_F = ΔW / (ω² δ), in the table both calculation and result."""
    run = machine(name).motion
    assert isinstance(run, Running) and run.steady is not None and run.cuts is not None and run.found is not None
    read = [one for lang in BOTH for one in sums(_told(studied(name), run).of(lang))]
    results = (run.by_areas, run.found.flywheel)
    told = _divided((run.surplus, run.cuts.cut), run.steady)
    for line, result in zip(told, results, strict=True):
        assert result is not None
        read += sums(f"J_F = {line} = {number(result, 5)} kg·m²")
    assert told[0].partition(" / ")[2] == told[1].partition(" / ")[2], "divided by one number with one count of figures"
    assert len(read) == 4 and all(one.holds for one in read), [one.text for one in read if not one.holds]
