"""A cycle that keeps its assembly through change points passes to the other side of its dyad: the course report says
where σ is turned, and with σ turned there its formulas are the motion of the solver."""

from __future__ import annotations

import numpy as np
import pytest

from tests.studies import course_text, studied, words_of
from vecpoly import loads, oracle, solve
from vecpoly.analytic.build import model
from vecpoly.analytic.equations import Model
from vecpoly.findings.side_changes import side_changes
from vecpoly.findings.study.study import Study, study
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import At
from vecpoly.words import Lang

OF_LIBRARY = ("parallelogram-locomotive", "curv-6")
LINKAGE = """
id: change-points
title: change points
frame: {{A: [0 mm, 0 mm], D: [{x} mm, {y} mm]}}
links:
  1: {{AB: 60 mm}}
  2: {{BC: 130 mm, M: {{along: BC, at: 40 mm}}}}
  3: {{DC: 60 mm}}
input: {{link: 1, phi: {phi} deg, omega: 5 rad/s}}
branch: [ABCD {kind}]
find: [v_C, a_C, omega_2, omega_3]
"""
OTHERS = tuple(
    LINKAGE.format(x=x, y=y, phi=phi, kind=kind)
    for x, y in ((130, 0), (50, 120))
    for phi in (20, 250)
    for kind in ("parallelogram", "antiparallelogram")
)
UNLIKE = """
id: no-change-points
title: no change points
frame: {A: [0 mm, 0 mm], D: [140 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 120 mm}, 3: {DC: 100 mm}}
input: {link: 1, phi: 60 deg, omega: 5 rad/s}
branch: [C left of BD]
find: [v_C]
"""


def subject(text: str) -> Study:
    """What the course report is about."""
    return studied(text) if text in OF_LIBRARY else study(solve(loads(text), by="exact", repeats=0, precise=False))


def modelled(mech: Mechanism, phi: float) -> Model:
    """Its formulas, set up with the places that the solver has there: σ is of the side on which C lies there."""
    motion = oracle.solve(mech, phi, order=0)
    letters = {letter for link in mech.links for letter in link.points}
    places = {letter: complex(motion.position(At(letter))) for letter in letters} | dict(mech.frame)
    return model(mech, places, {link.name: float(motion.angle(link.name)) for link in mech.links})


def sign(of: Model) -> float:
    """σ of the one group that has it."""
    (found,) = (one.size for group in of.groups for one in group.constants if one.symbol == "σ")
    return found


@pytest.mark.parametrize("text", [*OF_LIBRARY, *OTHERS])
def test_with_its_sign_turned_where_it_is_said_the_model_is_the_motion(text: str) -> None:
    it = subject(text)
    (group,) = (one for one in it.model.groups if side_changes(it, one))
    places = side_changes(it, group)
    phi = np.radians(np.arange(3.0, 363.0, 7.0))
    near = np.min(np.abs(np.exp(1j * phi[:, None]) - np.exp(1j * np.array(places))), axis=1) < 0.02
    turned = np.prod([np.sign((one - it.mech.drive.position) * (one - phi)) for one in places], axis=0)
    for at, side in zip(phi[~near], turned[~near], strict=True):
        there = modelled(it.mech, at)
        assert sign(there) == side * sign(it.model), np.degrees(at)
        found = there.values(np.array([at]))
        exact = complex(oracle.solve(it.mech, at, order=0).position(At("C")))
        assert np.abs(np.asarray(found["x_{C}"]) + 1j * np.asarray(found["y_{C}"]) - exact).max() < 1e-9, np.degrees(at)
    assert len(places) == 2


def test_a_linkage_that_passes_no_change_point_keeps_its_sign() -> None:
    it = subject(UNLIKE)
    assert [side_changes(it, group) for group in it.model.groups] == [()] * len(it.model.groups)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_course_report_says_where_the_sign_is_turned(lang: Lang) -> None:
    told = {"zh": "$σ$ 在变点 $φ_{1}$ = 0°、180° 处变号", "en": "sign at the change points $φ_{1}$ = 0° and 180°"}
    for name in OF_LIBRARY:
        assert told[lang] in course_text(name, lang)[0].replace("φ_1", "φ_{1}"), name
    assert {"zh": "变号。", "en": "$σ$ changes its sign"}[lang] not in words_of(subject(UNLIKE), lang)[0]
