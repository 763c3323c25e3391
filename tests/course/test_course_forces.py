"""Forces over the cycle and in the course report:
who drives where, where friction locks, and equations that the oracle obeys."""

from __future__ import annotations

import re
from itertools import chain, pairwise
from math import degrees, pi, radians
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import few, often
from tests.oracle.test_oracle_forces_models import slider_crank
from tests.studies import studied
from vecpoly.algebra.formula import plain
from vecpoly.analytic.expr import Var, constants
from vecpoly.analytic.forces.balance import ForceModel, force_model
from vecpoly.cycle import Cycle, cycle, extremes
from vecpoly.cycle.facts.duties import Cause, duties, idle, stills
from vecpoly.cycle.sample import sample
from vecpoly.errors import AssemblyError, DeadPointError, LockedError, NoMethodError
from vecpoly.findings.load_drive import driven
from vecpoly.findings.study.study import Study
from vecpoly.mechanism.asked.forces import load_symbol
from vecpoly.mechanism.loads import Force, Friction, Loads, Moment
from vecpoly.printed.digits import drawn_number
from vecpoly.problem.load import load
from vecpoly.report.content import Objects
from vecpoly.report.course.analysis.force_words import one_sided, refusals, results, role_note
from vecpoly.report.course.analysis.forces import conclusion, forces
from vecpoly.report.course.analysis.stated import stated
from vecpoly.report.course.checks import refused
from vecpoly.report.course.modelling.forces import forces_group
from vecpoly.report.course.modelling.formulas import chapter
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results.drawn_views import drawn_views
from vecpoly.words import Words

LOADED = [
    "4-3a",
    "4-3c",
    "4-4",
    "4-5",
    "4-5-circles",
    "4-6",
    "4-7",
    "C-inertia",
    "six-bar-dynamic",
    "slider-crank-dynamic",
    "engine-card",
    "return-spring",
    "shaper-cut",
]


@st.composite
def turns(draw: st.DrawFn) -> Cycle:
    """A slider-crank with friction in all its joints, over a whole turn."""
    ab = draw(st.floats(0.03, 0.12))
    mech = slider_crank(
        ab, draw(st.floats(1.8, 5.0)) * ab, draw(st.floats(-0.4, 0.4)) * ab, 0.7, draw(st.sampled_from([-3.0, 3.0]))
    )
    friction = Friction(
        pins={letter: ab * draw(st.floats(0.005, 0.1)) for letter in "ABC"},
        slides={("3", "0"): draw(st.floats(0.02, 0.25))},
    )
    force = Force(name="F", link="3", point="C", direction=draw(st.floats(0, 2 * pi)), size=500.0)
    return cycle(mech, loads=Loads(forces=(force,), moments=(Moment(name="M_1", link="1"),), friction=friction))


@settings(max_examples=often(4))
@given(turns(), st.sampled_from(["M_1", "eta", "R_12", "R_43"]))
def test_no_value_on_a_dense_grid_lies_beyond_the_extremes(turn: Cycle, key: str) -> None:
    """Whatever breaks the column: self-locking, a change of the side of friction, the end of a piece."""
    values = np.asarray(
        turn.at(key if key in ("M_1", "eta") else f"{key}.abs", np.linspace(0, 2 * pi, 4001)), np.float64
    )
    known = values[np.isfinite(values)]
    assume(known.size > 100)
    found = extremes(turn, key)
    assert found.highest is not None and found.lowest is not None
    small = 1e-9 * float(np.abs(known).max())
    assert found.lowest.value <= known.min() + small and found.highest.value >= known.max() - small


@settings(max_examples=often(8))
@given(turns(), st.integers(0, 1000))
def test_the_duties_cover_the_turn_and_agree_with_the_powers_everywhere(turn: Cycle, seed: int) -> None:
    found = duties(turn)
    assert sum(d.high - d.low for d in found) == pytest.approx(2 * pi)
    assert all(a.high == b.low for a, b in pairwise(found))
    phi = np.random.default_rng(seed).uniform(0, 2 * pi, 60)
    statics = sample(turn.mech, turn.loads, phi).statics
    for q, cause, f, m in zip(phi, statics.causes, statics.powers[0], statics.powers[-1], strict=True):
        if min(abs((q - edge + pi) % (2 * pi) - pi) for d in found for edge in (d.low, d.high)) < 1e-6:
            continue
        here = next(d for d in found if d.holds(float(q), 2 * pi))
        assert here.cause == cause
        if not cause:
            assert ("F" in here.drives, "M_1" in here.drives) == (f > 0, m > 0)


def test_the_self_locking_ranges_of_4_3_are_told_to_full_accuracy() -> None:
    """They begin where no moment is left, η = 0, and end at the dead points,
    where the slider turns back (the oracle calls 1e-9 of a rate rest)."""
    turn = cycle(load("4-3a"))
    first, drive, second, back = duties(turn)
    assert [d.cause for d in (first, drive, second, back)] == [Cause.LOCKED, Cause.NONE, Cause.LOCKED, Cause.NONE]
    for edge, inward in ((drive.low, 1e-10), (drive.high, -1e-10)):
        assert 0 < float(np.asarray(turn.at("eta", np.array([edge + inward]))).real[0]) < 1e-8
        assert np.isnan(turn.at("eta", np.array([edge - inward]))).all()
    offset, reach = 15.0, (230 - 80, 230 + 80)  # the crank in line with the rod
    exact = (pi + np.arcsin(-offset / reach[0]), 2 * pi - np.arcsin(offset / reach[1]))
    assert idle(turn, "F") == pytest.approx(exact, abs=1e-12)
    assert (back.low, back.high) == pytest.approx(exact, abs=1e-8) and (back.drives, back.resists) == (("M",), ("F",))


def test_the_side_of_friction_changes_where_the_rod_does_not_turn() -> None:
    assert [(round(degrees(s.phi), 9), s.who, s.letter) for s in stills(cycle(load("4-3a")))] == [
        (90.0, ("2", "3"), "C"),
        (270.0, ("2", "3"), "C"),
    ]


@pytest.mark.parametrize("name", few(LOADED, 5))
def test_the_printed_equations_of_equilibrium_hold_for_the_oracle_s_forces(name: str) -> None:
    """Σ F_x, Σ F_y, Σ M of every link, inertia forces and friction, at positions all round the cycle."""
    it = studied(name)
    loads = it.problem.loads
    assert loads is not None
    made = force_model(it.mech, loads, it.model, it.turned)
    assert made is not None and len(made.unknowns) == sum(len(link.equations) for link in made.links) == 3 * len(
        it.mech.bodies
    )
    phi = it.whole.low + (it.whole.high - it.whole.low) * np.random.default_rng(2).uniform(0.02, 0.98, 40)
    env, largest = environment(it, made, phi)
    sound = np.isfinite(largest)
    assert sound.sum() > 10
    for equation in (*made.inertia, *made.friction, *(e for link in made.links for e in link.equations)):
        gap = np.abs(np.broadcast_to(equation.left.value(env) - equation.right.value(env), phi.shape))[sound]
        assert np.max(gap / largest[sound]) < 1e-9, plain(equation.node)


def environment(it: Study, made: ForceModel, phi: np.ndarray) -> tuple[dict[str, Any], Any]:
    """Every symbol of the equations: the motion by the printed formulas, the forces by the oracle;
    and the largest force."""
    statics = sample(it.mech, it.problem.loads, phi).statics
    env: dict[str, Any] = dict(it.model.values(phi))
    for equation in (*made.normals, *made.inertia, *made.springs):
        env[equation.left.symbol] = equation.right.value(env)  # type: ignore[attr-defined]
    env[made.unknowns[-1]] = statics.wet.load
    assert it.problem.loads is not None
    for one in it.problem.loads.all:
        if one.law is not None:
            env[load_symbol(one.name)] = statics.value(one.name)
    largest = np.abs(np.asarray(statics.wet.load))
    for touch in made.touches:
        index = next(
            i
            for i, p in enumerate(statics.system.pairs)
            if {p.a, p.b} == {touch.a, touch.b}
            and (p.text.en.split()[-1] == touch.letter or not p.text.en.startswith("pin"))
        )
        pair, units = statics.system.pairs[index], statics.wet.units[index]
        wrench = statics.wet.wrench(statics.system.pairs, index)
        sign = 1 if pair.b == touch.b else -1
        largest = np.maximum(largest, np.abs(wrench.force))
        rubbed = statics.wet.rubs[index] if pair.rub is not None else np.zeros(phi.shape)
        if len(touch.unknowns) == 2 and touch.unknowns[0].startswith("R"):
            env[touch.unknowns[0]], env[touch.unknowns[1]] = sign * wrench.force.real, sign * wrench.force.imag
            rub = sign * (pair.rub.couple if pair.rub else 0.0) * rubbed
        else:
            env[touch.unknowns[0]] = units[0]
            along = pair.along if pair.along is not None else 1.0
            rub = np.real(np.conj(along) * (pair.rub.force if pair.rub else 0.0)) * rubbed
            if len(touch.unknowns) == 2:
                place = env[f"x_{{{touch.letter}}}"] + 1j * np.asarray(env[f"y_{{{touch.letter}}}"])
                arm = pair.at - place
                env[touch.unknowns[1]] = wrench.couple + arm.real * wrench.force.imag - arm.imag * wrench.force.real
        for law in touch.friction:
            env[law.left.symbol] = rub  # type: ignore[attr-defined]
            speed = plain(law.right.node).rpartition("sgn")[2].strip(" \u2009()")
            if speed.startswith("v_"):
                env[f"v_{{{speed[2:]}}}"] = np.broadcast_to(np.asarray(pair.rate), phi.shape)
    return env, largest


def test_the_model_of_the_forces_is_a_section_of_its_own_with_the_friction_where_there_is_any() -> None:
    with_, without = forces_group(studied("4-3a")), forces_group(studied("six-bar-dynamic"))
    assert with_ is not None and without is not None
    assert [s.title.zh for s in with_.stages] == ["平衡方程", "摩擦", "求解"]
    assert [s.title.zh for s in without.stages] == ["惯性力", "平衡方程", "求解"]
    assert "ρ_C" in {c.symbol.replace("{", "").replace("}", "") for c in with_.constants}
    assert forces_group(studied("A-27")) is None


@pytest.mark.parametrize("name", few(["4-5", "plate-two-slides", "4-7"], 2))
def test_every_direction_of_a_load_in_the_equations_is_named_and_told_in_degrees(name: str) -> None:
    it, group = studied(name), forces_group(studied(name))
    assert group is not None
    named = {c.symbol for c in group.constants if re.fullmatch(r"θ_\{[A-Z]\w*\}", c.symbol)}
    assert named and all(f"${symbol}$" in group.opening.en and f"${symbol}$" in group.opening.zh for symbol in named)
    constants = chapter(it, Press("en", Objects()))["groups"][-1]["constants"]
    assert all(re.search(rf"{re.escape(symbol)}\$ = [−\d.]+°", constants) for symbol in named)


def test_the_words_say_where_a_load_plays_the_other_part_and_by_which_quotient_the_efficiency_is() -> None:
    told = results(studied("4-3a"))
    assert "$F$ 作负功，实为阻力" in told.zh and "174.3°～357.2°" in told.zh and "$η$ = $M_{0}/M$" in told.zh
    assert "357.2°～4.8°、162.6°～174.3°：自锁" in told.zh and "$C$ 处 $ω_{23}$ = 0" in told.zh
    assert "$R_{32}$、$R_{41}$ 与 $R_{12}$ 处处等值" in told.zh and "self-locking" in told.en
    assert role_note(studied("4-3a"), radians(285.2)).zh and not role_note(studied("4-3a"), radians(52)).zh


def test_every_position_that_cannot_be_drawn_has_its_reason() -> None:
    there, far = np.radians([0.0, 90.0, 165.0, 270.0]), Words("机构不能装配", "links that do not meet")
    told = refusals(studied("4-3a"), tuple((phi, far) for phi in there))
    assert told.zh == "0°、165°（自锁（驱动力克服不了摩擦））；90°、270°（$C$ 处 $ω_{23}$ = 0，摩擦力指向不定）"
    assert refusals(studied("A-27"), ((0.0, far),)).en == "0° (links that do not meet)"


def test_what_a_drawing_refuses_is_told_by_its_kind_and_not_by_every_reason_there_may_be() -> None:
    assert [refused.cause(kind("")).en for kind in (LockedError, DeadPointError, AssemblyError, NoMethodError)] == [
        "self-locking",
        "a dead point",
        "links that do not meet",
        "a figure larger than the sheet",
    ]


def test_the_conclusion_gives_what_was_asked_for() -> None:
    (given_,) = stated(studied("4-3a"))
    for text in ("$R_{32}$ = 1004 N，方向角 162.4°；$R_{12}$ = ", "$M$ = 64.3 N·m，顺时针", "各值最多相差 0.16 %"):
        assert text in given_.zh
    over, locked = conclusion(studied("4-3a"))
    assert "100.1 N·m（285.2°）" in over.zh and "0.8377" in over.zh and "162.6°～174.3°" in locked.zh
    assert tuple(conclusion(studied("A-27"))) == () == tuple(forces(studied("A-27")))


def test_the_conclusion_gathers_the_instant_centres_where_all_are_asked() -> None:
    (said,) = stated(studied("3-1a"))
    assert "all 6 instant centres, with their positions in 6.2" in said.en and "P_{12}" not in said.en


@pytest.mark.parametrize("name", ["press-flywheel", "A-27", "4-3a"])
def test_the_conclusion_lists_what_is_asked_and_nothing_else_in_the_order_asked(name: str) -> None:
    """The press asks for J_e ... φ_min and no rates; a sense stands for a sign, a point has its coordinates."""
    it = studied(name)
    (said,) = stated(it)
    listed = said.en.partition(" gives ")[2].partition(". Drawing and")[0].rstrip(".").split("; ")
    answers = [it.solution.answers[ask.rel.key] for ask in it.given.problem.asks]  # as chapter 6 has drawn them
    named = [re.findall(r"\$([^$]+)\$ [=(]", text) for text in listed]  # what is equal, together
    asked = [one.reading.symbol for one in answers]
    assert sorted(chain.from_iterable(named)) == sorted(asked)
    assert [first for first, *_ in named] == sorted((first for first, *_ in named), key=asked.index)
    told = {symbol: text for symbols, text in zip(named, listed, strict=True) for symbol in symbols}
    assert all(drawn_number(one).lstrip("−") in told[one.reading.symbol] for one in answers if one.turns)
    assert not any("= −" in text for text in listed if "clockwise" in text)


def test_a_rate_that_turns_clockwise_is_told_by_its_sense_and_a_point_by_its_place() -> None:
    (rates,), (places,) = stated(studied("3-9")), stated(studied("A-27"))
    assert "$α_3$ = 8.439 rad/s², clockwise" in rates.en
    assert "$F$ (−130.0, 164.4) mm" in places.zh


def test_a_slider_that_drives_has_dead_points_and_a_transmission_angle_of_its_own() -> None:
    found = driven(studied("4-3a"))
    assert found is not None and (found.link, found.pair) == ("3", ("1", "2")) and found.gamma is not None
    assert found.gamma[0] < 1e-6 and found.gamma[1] == pytest.approx(pi / 2, abs=1e-3)
    assert all(
        a < dead + k < b
        for dead in found.dead
        for k, (a, b) in zip((0.0,), [next(p for p in found.poor if p[0] < dead < p[1])], strict=True)
    )
    assert driven(studied("4-6")) is None and driven(studied("six-bar-dynamic")) is None


def test_limits_from_one_side_are_marked_and_only_drawn_figures_are_named() -> None:
    assert "*" in one_sided(studied("4-3a")).zh and not one_sided(studied("six-bar-dynamic")).zh
    assert drawn_views(studied("4-3a").solution.construction).zh == "机构位置图、速度多边形、各构件的受力图和力多边形"
    assert "the acceleration polygon" in drawn_views(studied("six-bar-dynamic").solution.construction).en


# crank and rod (m), eccentricity (m), ω (rad/s), friction circles (m), friction of the guide, direction of the force
# (rad)
BENDS = {
    "eta": (
        0.10751400163082947,
        0.4454901445629513,
        0.008757957062696829,
        -3.0,
        (0.008532552479544625, 0.0031039743750338722, 0.001305763529989833),
        0.2414588530419424,
        3.3929904695744773,
    ),
    "R_12": (
        0.0760639462230231,
        0.368262365551111,
        -0.021653299265658794,
        3.0,
        (0.0026336371567705287, 0.0034393083548112813, 0.0063613606616915236),
        0.11411580136490711,
        3.453198983306014,
    ),
}


@pytest.mark.parametrize("key", few(tuple(BENDS), 2))
def test_a_top_at_a_bend_or_beside_a_sliver_without_equilibrium_is_found_where_it_is(key: str) -> None:
    """η bends where the slide changes the side of its guide;
    a locked stretch and the answers beside it lie 1e-7 rad apart."""
    ab, rod, away, rate, circles, f, direction = BENDS[key]
    friction = Friction(pins=dict(zip("ABC", circles, strict=True)), slides={("3", "0"): f})
    force = Force(name="F", link="3", point="C", direction=direction, size=500.0)
    turn = cycle(
        slider_crank(ab, rod, away, 0.7, rate),
        loads=Loads(forces=(force,), moments=(Moment(name="M_1", link="1"),), friction=friction),
    )
    values = np.asarray(turn.at(key if key == "eta" else f"{key}.abs", np.linspace(0, 2 * pi, 4001)), np.float64)
    found = extremes(turn, key)
    assert found.highest is not None and found.highest.value >= np.nanmax(values) * (1 - 1e-9)


TWICE_AT_ONE_PLACE = ["compound-hinge-six-bar", "return-spring", "4-3a"]  # two hinges at C; F_s and M_s; nothing twice


@pytest.mark.parametrize("name", few(TWICE_AT_ONE_PLACE, 2))
def test_no_symbol_of_the_equations_of_forces_means_two_things(name: str) -> None:
    """Friction moments at a multiple joint, springs F_s and M_s: one letter, one quantity."""
    it = studied(name)
    assert it.problem.loads is not None
    made = force_model(it.mech, it.problem.loads, it.model, it.turned)
    assert made is not None
    given_ones = [e for e in (*made.normals, *made.inertia, *made.springs, *made.friction) if isinstance(e.left, Var)]
    symbols = [*(e.left.symbol for e in given_ones if isinstance(e.left, Var)), *made.unknowns]
    assert len(symbols) == len({*symbols})
    sides = [s for e in (*given_ones, *(e for one in made.links for e in one.equations)) for s in (e.left, e.right)]
    sizes = {(c.symbol, c.size) for side in sides for c in constants(side)}
    assert len(sizes) == len({symbol for symbol, _ in sizes})


def test_moments_of_friction_at_a_multiple_joint_are_told_apart_by_the_links() -> None:
    it = studied("compound-hinge-six-bar")
    assert it.problem.loads is not None
    made = force_model(it.mech, it.problem.loads, it.model, it.turned)
    assert made is not None and [touch.rub for touch in made.shared_pins] == ["M_{fC,23}", "M_{fC,34}"]
    assert {touch.rub for touch in made.touches} >= {"M_{fA}", "M_{fB}", "M_{fE}"}
    third = next(one for one in made.links if one.link == "3").equations[-1]
    assert "M_fC,23 − M_fC,34" in plain(third.node)
    section = forces_group(it)
    assert (
        section is not None and "$M_{fC,23}$ 为 $C$ 处构件 2 对构件 3 的摩擦力矩" in section.stages[1].parts[0].said.zh
    )
