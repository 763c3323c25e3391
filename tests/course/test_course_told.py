"""What a course report tells in words and draws in axes is what the oracle has:
extremes, strokes, angles, curves, scales."""

from __future__ import annotations

import cmath
import re
from functools import cache
from math import degrees

import numpy as np
import pytest

from tests.studies import studied
from vecpoly import oracle
from vecpoly.board.paper.marks import AngleMark, Point, Vector
from vecpoly.curves.over import curves
from vecpoly.cycle import cycle
from vecpoly.findings.conditioning import conditioning
from vecpoly.problem.load import load
from vecpoly.report.course.analysis.conclusion import conclusion
from vecpoly.report.course.checks.comparison import Compared
from vecpoly.report.course.modelling.axes import _added, _origin
from vecpoly.report.picture import picture
from vecpoly.words import Words

NAMES = ("3-9", "B-24")


@cache
def concluded(name: str) -> tuple[Words, ...]:
    return tuple(conclusion(studied(name), conditioning(studied(name)), Compared((), (), ()), (), ""))


def shown(text: str) -> float:
    return float(text.replace("−", "-"))


@cache
def dense(name: str) -> oracle.Motion:
    """The motion on a dense grid over the whole cycle."""
    turn = studied(name).turn
    return oracle.solve(studied(name).mech, np.linspace(turn.low, turn.high, 7201))


@pytest.mark.parametrize("name", NAMES)
def test_the_greatest_velocity_and_acceleration_told_of_a_point_are_those_of_the_cycle(name: str) -> None:
    told = [
        re.search(
            r"Point \$(\w)\$ travels.*; \$\|v_\{\w\}\|\$ has its maximum, ([\d.]+) m/s, "
            r"at .*\$\|a_\{\w\}\|\$, ([\d.]+) m/s",
            words.en,
        )
        for words in concluded(name)
    ]
    found = [match for match in told if match]
    assert found
    for match in found:
        for value, rates in (
            (match[2], dense(name).velocity(match[1])),
            (match[3], dense(name).acceleration(match[1])),
        ):
            assert shown(value) == pytest.approx(float(np.nanmax(np.abs(rates))), rel=2e-3), match[0]


@pytest.mark.parametrize("name", NAMES)
def test_the_places_told_of_the_greatest_velocity_are_where_it_is(name: str) -> None:
    for words in concluded(name):
        if match := re.search(r"\$(\w)\$ 点一个循环.*最大 ([\d.]+) m/s（\$φ_\{?1\}?\$ = ([\d.]+)°", words.zh):
            at = oracle.solve(studied(name).mech, np.radians([float(match[3])]))
            assert abs(complex(np.asarray(at.velocity(match[1]))[0])) == pytest.approx(float(match[2]), rel=2e-3)
    assert any("最大" in words.zh for words in concluded(name))


@pytest.mark.parametrize("name", (*NAMES, "A-27"))
def test_the_rates_told_of_an_output_link_are_those_of_the_cycle(name: str) -> None:
    """The range of what keeps its sense, the greatest size of what turns back."""
    told = "\n".join(words.en for words in concluded(name) if words.en.startswith("Output link"))
    rate = r"([ωα])_\{?(\d)\}?"
    ranges = re.findall(rf"\${rate}\$ varies from ([−\d.]+) rad/s\S* \(.*?\) to ([−\d.]+) rad/s", told)
    sizes = re.findall(rf"the maximum \$\|{rate}\|\$ is ([\d.]+) rad/s", told)
    assert ranges or sizes
    for letter, link, *limits in [*ranges, *((letter, link, top) for letter, link, top in sizes)]:
        values = np.asarray((dense(name).omega if letter == "ω" else dense(name).alpha)(link))
        size = float(np.abs(values).max())
        if len(limits) == 2:
            assert shown(limits[0]) == pytest.approx(float(values.min()), abs=2e-3 * size)
            assert shown(limits[1]) == pytest.approx(float(values.max()), abs=2e-3 * size)
            assert values.min() * values.max() > 0
        else:
            assert shown(limits[0]) == pytest.approx(size, rel=2e-3) and values.min() < 0 < values.max()


@pytest.mark.parametrize("name", NAMES)
def test_the_conclusion_tells_freedom_output_points_and_groups_once_each(name: str) -> None:
    en = [words.en for words in concluded(name)]
    assert (
        sum("has 1 degree of freedom" in text for text in en) == 1
        and sum(text.startswith("Output link") for text in en) >= 1
    )
    assert sum(text.startswith(("Conditioning of the groups", "All groups are well-conditioned")) for text in en) <= 1
    assert len(en) == len(set(en)) >= 4 and all(
        words.zh.endswith("。") and words.en.endswith(".") for words in concluded(name)
    )


@pytest.mark.parametrize(("name", "link"), [("3-9", "3"), ("B-24", "5"), ("A-27", "5")])
def test_the_sense_told_of_a_link_is_that_of_the_oracle(name: str, link: str) -> None:
    motion = oracle.solve(studied(name).mech)
    told = {
        match[1] + match[2]: (match[3], match[4])
        for words in concluded(name)[:1]
        for match in re.finditer(r"\$([ωα])_\{?(\d)\}?\$ = ([^;]*?), (counter-clockwise|clockwise)", words.en)
    }
    for sign, value in (("ω", motion.omega(link)), ("α", motion.alpha(link))):
        assert told[sign + link][1] == ("counter-clockwise" if float(np.real(value)) > 0 else "clockwise"), sign


# -- chapter 3: axes and angles ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["3-9", "A-27", "3-5"])
def test_the_axes_stand_at_the_origin_and_every_angle_is_that_of_its_link(name: str) -> None:
    it = studied(name)
    figure = picture(it.problem, it.solution.construction, 125.0, 68.0)
    assert figure is not None
    place, per_m = it.mech.frame[_origin(it)], 1 / figure.scale.value
    marks = list(_added(it, figure, place))
    axes = [mark for mark in marks if isinstance(mark, Vector)]
    assert [cmath.phase(mark.b - mark.a) for mark in axes] == pytest.approx([0.0, cmath.pi / 2]) and all(
        abs(mark.a - place * per_m) < 1e-9 for mark in axes
    )
    assert [mark.label for mark in marks if isinstance(mark, Point)] == ["x", "y"]
    angles = {mark.label: mark for mark in marks if isinstance(mark, AngleMark)}
    motion, turning = (
        oracle.solve(it.mech),
        [link for link in it.mech.links if len(link.points) > 1 and f"φ_{{{link.name}}}" in angles],
    )
    assert turning and len(angles) >= len(turning)
    for link in turning:
        mark, (p, q) = angles[f"φ_{{{link.name}}}"], list(link.points)[:2]
        ray = complex(motion.position(q)) - complex(motion.position(p))
        assert abs(mark.at - complex(motion.position(p)) * per_m) < 1e-6 and mark.start == 0.0
        assert abs(cmath.rect(1, mark.sweep) - ray / abs(ray)) < 1e-9 and 0 < mark.sweep <= 2 * cmath.pi, link.name


# -- curves -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "keys"), [("A-27", ("omega_5", "alpha_5")), ("3-5", ("v_F", "a_F", "phi_3"))])
def test_a_curve_goes_through_the_oracle_s_values_and_within_its_axes(name: str, keys: tuple[str, ...]) -> None:
    problem = load(name)
    turn = cycle(problem, n=91)
    plot = curves(turn, keys)
    assert len(plot.figure.axes) >= len(keys)
    lines = {
        line.get_gid() or line.get_label(): (panel, line)
        for panel in plot.figure.axes
        for line in panel.get_lines()
        if np.size(line.get_xdata()) >= 80
    }
    assert len(lines) == len(keys)
    for key, (panel, line) in zip(keys, lines.values(), strict=True):
        x, y = np.asarray(line.get_xdata(), float), np.asarray(line.get_ydata(), float)
        motion = oracle.solve(problem.mechanism, np.radians(x))
        exact = {
            "o": motion.omega,
            "a": motion.alpha if key.startswith("alpha") else motion.acceleration,
            "v": motion.velocity,
            "p": motion.angle,
        }[key[0]](key.split("_")[1])
        truth = (
            np.unwrap(np.asarray(exact, float)) * degrees(1)
            if key.startswith("phi")
            else np.abs(np.asarray(exact))
            if key[0] in "va" and not key.startswith("alpha")
            else np.asarray(exact)
        )
        assert np.allclose(
            (y - truth + 180) % 360 - 180 if key.startswith("phi") else y - truth,
            0.0,
            atol=1e-6 * max(1.0, float(np.nanmax(np.abs(y)))),
        ), key
        (left, right), (low, high) = panel.get_xlim(), panel.get_ylim()
        assert left <= x.min() and x.max() <= right and low <= np.nanmin(y) and np.nanmax(y) <= high
        assert high - low < 2.3 * max(
            float(np.nanmax(y) - np.nanmin(y)), 0.6 * float(np.nanmax(np.abs(y)))
        )  # it fills its panel


@pytest.mark.parametrize(
    ("name", "phi", "told"),
    [
        ("3-9", np.radians(37.463), "37.5°"), ("3-9", np.radians(37.46), "37.46°"), ("3-9", np.radians(90), "90°"),
        ("elliptic-trammel", 1.714983, "1715.0 mm"),
    ],
)  # fmt: skip
def test_a_position_of_the_drive_is_told_as_given_or_to_a_tenth_everywhere(name: str, phi: float, told: str) -> None:
    it = studied(name)
    assert it.place(phi) == told and it.where(phi).endswith(f" = {told}")
