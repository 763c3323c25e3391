"""What is asked follows from what is given: nothing that decides it stands only in the solution."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any, get_args

import pytest

import vecpoly
from tests.drawn_library import IDS, LIBRARY, drawn
from tests.each import Later, each
from tests.found import DEVICES, FOUND
from tests.generators.library import QUANTITY, data_of, problems
from vecpoly.board.paper.marks import Point
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.mechanism.profiles import CamProfile
from vecpoly.problem.library import find
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.report.picture import picture
from vecpoly.report.question.sketch import sketched
from vecpoly.report.statement.centrodes import centrodes_asked
from vecpoly.report.statement.given_data import friction_heads, given_data
from vecpoly.words import Lang

Path = tuple[str | int, ...]
OTHERS = {**FOUND, **DEVICES}
_ACCELERATION = re.compile(r"(?:a[rk]?|alpha)_")
_RATE, _SENSELESS = re.compile(r"\$[ωvn]_\w+\$ = "), re.compile(r"\$∠\w{3}\$ = [−\d.]+°$")


def _data(problem: Problem, lang: Lang = "zh") -> list[str]:
    return [one.of(lang) for one in given_data(problem)]


@each(LIBRARY)
def test_where_accelerations_are_asked_the_drive_is_told_to_be_uniform_or_how_it_speeds_up(name: str) -> None:
    problem = load(name)
    if not isinstance(problem.subject, Mechanism) or problem.machine is not None:
        return
    if not any(_ACCELERATION.match(ask.rel.key) for ask in problem.asks):
        return
    for told, steady in ((_data(problem), "匀速"), (_data(problem, "en"), "constant")):
        rates = [one for one in told if _RATE.match(one)]
        speeding = any(one.startswith(("$α", "$a_", "$a^")) for one in told)
        assert rates and (speeding or all(steady in one for one in rates))


@each(LIBRARY)
def test_an_angular_acceleration_and_an_angle_of_a_link_have_a_sense(name: str) -> None:
    problem = load(name)
    if not isinstance(problem.subject, Mechanism):
        return
    for told in _data(problem):
        assert not _SENSELESS.fullmatch(told)
        assert not told.startswith("$α_") or "时针" in told or re.search(r"= 0(\.0+)? ", told)


@each(LIBRARY)
def test_where_centrodes_are_asked_their_positions_are_told(name: str) -> None:
    problem = load(name)
    curvature = problem.curvature
    told = centrodes_asked(problem)
    if curvature is None or curvature.centrodes is None:
        assert not told.zh and not told.en
        return
    drive = problem.mechanism.drive.symbol
    for words in (told.zh, told.en):
        assert f"${drive}$".replace("{", "").replace("}", "") in words.replace("{", "").replace("}", "")
        assert str(curvature.centrodes.positions) in words


def test_a_drive_that_speeds_up_is_not_uniform_and_one_that_only_moves_is_not_said_to_be() -> None:
    path = find("3-6")
    assert path is not None
    text = path.read_text("utf-8")
    assert any("匀速" in one for one in _data(loads(text)))
    faster = re.sub(r"(omega: [^,}]+)", r"\1, alpha: 5 rad/s^2", text, count=1)
    told = _data(loads(faster))
    assert not any("匀速" in one for one in told) and any(one.endswith("（逆时针）") and "α_1" in one for one in told)


@pytest.mark.parametrize(("name", "symbols"), [("cam-knife-load", ("ρ_O", "φ_{T}")), ("4-3a", ("ρ_A", "φ_{34}"))])
def test_the_first_radius_and_the_first_angle_of_friction_are_named(name: str, symbols: tuple[str, str]) -> None:
    problem = load(name)
    heads = friction_heads(problem, given_data(problem), "zh")
    assert tuple(heads) == symbols and [one.strip() for one in heads.values()] == ["摩擦圆半径", "摩擦角"]


def test_a_slider_that_drives_has_no_speed_where_only_curvatures_are_asked() -> None:
    assert not any(one.startswith("$v_") for one in _data(load("curv-7")))
    assert any(one.startswith("$v_") for one in _data(load("elliptic-trammel")))


def test_a_face_beside_its_letter_is_told_by_the_line_beside_which_it_lies() -> None:
    assert "构件 2 的平底与 $CG$ 平行，在有向线 $CG$ 左侧 9 mm" in _data(load("4-5"))
    assert "the face of link 2 is parallel to $AE$, 6 mm to the left of it" in _data(load("cam-moves-flat-arm"), "en")


def test_a_pitch_line_is_told_by_the_pin_or_the_line_through_which_it_runs() -> None:
    assert "构件 2 的齿条节线过 $B$" in _data(load("crank-rack-pinion"))
    assert "the pitch line of the rack of link 3 coincides with $DC$" in _data(load("rack-on-a-rocker"), "en")


@pytest.mark.parametrize("name", ["straight-roberts", "cognates"])
def test_the_coordinates_of_a_coupler_point_are_told_to_be_those_of_the_coupler(name: str) -> None:
    assert "$E$ 的坐标以 $B$ 为原点，$x$ 轴沿 $BC$，$y$ 轴在其左侧" in _data(load(name))


def test_a_guide_bar_that_is_not_square_to_its_guide_leans_to_one_side() -> None:
    assert "构件 3 的滑道与导路成 60°（自导路顺时针量）" in _data(load("3-14"))
    assert any(one == "构件 3 的滑道与导路成 90°" for one in _data(load("3-7d")))


_PROFILED = tuple(name for name in LIBRARY if name.startswith("cam-") or name.endswith("cam"))


@each(Later(lambda: [name for name in _PROFILED if name in IDS and _cams(load(name))]))
def test_a_sketch_does_not_show_the_centre_of_curvature_of_a_profile(name: str) -> None:
    one = drawn(name)
    for sketch in (picture, sketched):
        figure = sketch(one.problem, one.solution.construction, 120.0, 90.0)
        assert figure is not None
        letters = {mark.label for mark in figure.marks if isinstance(mark, Point)}
        assert letters and "" not in letters and not letters & {cam.centre for cam in _cams(one.problem)}


def _cams(problem: Problem) -> tuple[CamProfile, ...]:
    return problem.subject.cams if isinstance(problem.subject, Mechanism) else ()


KNOWN = problems() | {name: data_of(text) for name, text in OTHERS.items()}
NOT_TOLD = ("stations", "bodies", "rays")  # where is drawn, and what is only sketched; rays by their directions
DECIDING = ("links", "joints", "loads", "friction", "masses", "counterweights", "data")


@each(KNOWN)
def test_every_number_of_a_file_is_told(name: str) -> None:
    """One that is changed a little changes what is given, or is refused: nobody can solve what is not told."""
    data = {key: value for key, value in KNOWN[name].items() if key != "statement"}
    before = told_of(data)
    if before is None:
        return  # its table is a file beside it
    for path, span, number in numbers_in({key: data[key] for key in DECIDING if key in data}):
        if float(number) and not {*path} & {*NOT_TOLD}:
            after = told_of(changed(data, path, span, f"{float(number) * 1.003:.7g}"))
            assert after is None or after != before, f"{' '.join(map(str, path))}: {number} is not told"


def told_of(data: dict[str, Any]) -> list[str] | None:
    """All that is given, in both languages; None where the file is refused."""
    try:
        problem = loads(json.dumps(data, ensure_ascii=False))
    except VecpolyError:
        return None
    return [f"{one.of(lang)}{one.table}" for one in given_data(problem) for lang in get_args(Lang)]


def numbers_in(value: object, path: Path = ()) -> Iterator[tuple[Path, tuple[int, int], str]]:
    """Where each quantity of a file stands, and its number."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in inner:
        yield from numbers_in(one, (*path, key))
    if isinstance(value, str):
        yield from ((path, found.span(1), found[1]) for found in QUANTITY.finditer(value))


def changed(value: Any, path: Path, span: tuple[int, int], number: str) -> Any:
    """The same file with another number there."""
    if not path:
        return value[: span[0]] + number + value[span[1] :]
    first, *rest = path
    if isinstance(value, dict):
        return value | {first: changed(value[first], tuple(rest), span, number)}
    return [changed(one, tuple(rest), span, number) if n == first else one for n, one in enumerate(value)]


def test_moments_of_inertia_about_one_letter_have_symbols_of_their_own() -> None:
    told = _data(vecpoly.loads(FOUND["masses-at-one-pin"]))
    assert {"$J_{B1}$ = 0.02 kg·m²", "$J_{B2}$ = 0.01 kg·m²", "$J_{S3}$ = 0.02 kg·m²"} <= {*told}
