"""Loads and positions without an answer are refused with the reason:
locking, joints at rest, links that part, bad loads."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.laws import often
from tests.oracle.test_oracle_forces_models import CASES, CRANK, PUSH, ROUGH, case, crank, slider_crank
from vecpoly.errors import EquilibriumError, LockedError, NoSlipSenseError, UnknownNameError
from vecpoly.mechanism.loads import Force, Friction, Loads, Moment
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import solve
from vecpoly.oracle.forces import forces


def test_a_driving_force_that_is_locked_out_locks_whichever_load_is_unknown() -> None:
    """F given and M_1 sought, or M_1 given and F sought: one and the same state, or locked in both."""
    q = np.radians(np.linspace(0.2, 179.8, 1797))
    q = q[solve(crank(), q, order=1).velocity("C").real < -1e-6]  # where F drives
    given = forces(crank(), Loads(forces=(PUSH,), moments=(CRANK,), friction=ROUGH), q, strict=False)
    moment = replace(CRANK, size=-50.0)
    sought = forces(
        crank(), Loads(forces=(replace(PUSH, size=None),), moments=(moment,), friction=ROUGH), q, strict=False
    )
    locked = np.isnan(given.value("M_1"))
    assert 50 < locked.sum() < 600
    assert (locked == np.isnan(sought.value("F"))).all()
    free = ~locked
    assert np.allclose(given.value("M_1")[free] * sought.value("F")[free], -50.0 * 1000.0, rtol=1e-9)
    assert (given.value("eta")[free] > 0).all() and np.allclose(
        given.value("eta")[free], sought.value("eta")[free], rtol=1e-9
    )


def test_locked_mechanism_is_refused_with_the_load_and_the_efficiency() -> None:
    loads = Loads(forces=(PUSH,), moments=(CRANK,), friction=ROUGH)
    with pytest.raises(LockedError, match=r"F cannot move .* at 173°: .* efficiency would be -"):
        forces(crank(173.0), loads)
    sought = Loads(forces=(replace(PUSH, size=None),), moments=(replace(CRANK, size=-50.0),), friction=ROUGH)
    with pytest.raises(LockedError, match=r"no F, however large, moves .* binds at \d+(\.\d+)? % of its size"):
        forces(crank(173.0), sought)


def test_a_crank_that_drives_never_locks() -> None:
    q = np.radians(np.linspace(0.137, 360.137, often(361, 1801)))
    q = q[solve(crank(), q, order=1).velocity("C").real > 1e-6]  # where F resists
    result = forces(crank(), Loads(forces=(PUSH,), moments=(CRANK,), friction=ROUGH), q)
    assert (
        q.size > often(160, 800)
        and (result.value("M_1") > result.value("M_1_0")).all()
        and (result.value("M_1_0") > 0).all()
    )


def refused(error: type[Exception], match: str, mech: Mechanism, **changes: Any) -> None:
    """Loads of the slider-crank with these changes are refused with one clear sentence."""
    loads = replace(Loads(forces=(PUSH,), moments=(CRANK,)), **changes)
    with pytest.raises(error, match=match):
        forces(mech, loads)


def test_loads_without_one_answer_are_refused() -> None:
    refused(EquilibriumError, "2 loads have no size .F, M_1.; exactly one", crank(), forces=(replace(PUSH, size=None),))
    refused(EquilibriumError, "0 loads have no size; exactly one", crank(), moments=())
    refused(
        EquilibriumError,
        "F acts on '9', which is no moving link; known: 1, 2, 3",
        crank(),
        forces=(replace(PUSH, link="9"),),
    )
    refused(EquilibriumError, "F acts on '0'", crank(), forces=(replace(PUSH, link="0"),))
    refused(UnknownNameError, "link 3 has no point B", crank(), forces=(replace(PUSH, point="B"),))
    refused(EquilibriumError, "friction at B is -0.005", crank(), friction=Friction(pins={"B": -0.005}))
    refused(
        EquilibriumError, "M_3 cannot balance .* link 3 does not turn", crank(), moments=(Moment(name="M_3", link="3"),)
    )
    refused(
        EquilibriumError,
        "P cannot balance .* does not move in its direction",
        crank(),
        moments=(),
        forces=(PUSH, Force(name="P", link="3", point="C", direction=np.pi / 2)),
    )


def test_an_unknown_key_or_pair_is_refused() -> None:
    result = forces(crank(), Loads(forces=(PUSH,), moments=(CRANK,)))
    with pytest.raises(UnknownNameError, match="no quantity R_13 here; known: M_1, eta"):
        result.value("R_13")
    with pytest.raises(UnknownNameError, match="there is no R_13: the two links do not touch"):
        result.line("1", "3")


def test_friction_without_relative_motion_has_no_sense() -> None:
    mech = slider_crank(0.08, 0.23, 0.0, np.pi)  # dead centre: the slider stands
    rough = Friction(slides={("3", "0"): 0.1})
    refused(
        NoSlipSenseError, "slide of 3 on 4: friction between links 4 and 3 has no sense.*180°", mech, friction=rough
    )
    result = forces(mech, Loads(forces=(PUSH,), moments=(CRANK,), friction=rough), [3.0, np.pi], strict=False)
    assert np.isnan(result.value("M_1")).tolist() == [False, True]
    assert np.isnan(result.value("M_1_0")).tolist() == [False, False]
    refused(NoSlipSenseError, "the drive stands still", crank(rate=0.0), friction=ROUGH)


@pytest.mark.parametrize(
    ("mech", "remedies"),
    [
        (slider_crank(0.08, 0.23, 0.0, np.pi), ("请另取位置，", "choose another position,")),
        (crank(rate=0.0), ("请给出原动件的速度，", "give the drive a rate,")),
    ],
)
def test_the_remedy_for_friction_without_a_sense_is_the_same_in_both_languages(
    mech: Mechanism, remedies: tuple[str, str]
) -> None:
    with pytest.raises(NoSlipSenseError) as caught:
        forces(mech, Loads(forces=(PUSH,), moments=(CRANK,), friction=ROUGH))
    assert remedies[0] in caught.value.words.zh and remedies[1] in caught.value.words.en


def test_a_drive_at_rest_is_balanced_without_friction() -> None:
    loads = Loads(forces=(PUSH,), moments=(CRANK,))
    result = forces(crank(rate=0.0), loads)
    assert result.value("M_1") == pytest.approx(CASES["4-3a"]["values"]["M_1_0"], rel=1e-9)
    assert result.value("M_1_power") == pytest.approx(result.value("M_1_0"), rel=1e-12)


def test_a_contact_that_would_have_to_pull_parts() -> None:
    mech, loads = case("4-4")
    lifted = replace(loads, forces=(replace(loads.forces[0], direction=loads.forces[0].direction + np.pi),))
    with pytest.raises(EquilibriumError, match=r"links 2 and 1 part at their contact K .* a pull of \d+"):
        forces(mech, lifted)
    assert np.isnan(forces(mech, lifted, strict=False).value("M_1"))
