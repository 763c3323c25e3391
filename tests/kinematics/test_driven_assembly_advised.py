"""Where a group with a drive inside could be assembled in several ways, what the refusal advises is what decides."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from vecpoly import oracle
from vecpoly.errors import AssemblyError
from vecpoly.mechanism.model import Mechanism, Side, SideOf
from vecpoly.problem.load import load

ADVICE = re.compile(
    r"of which (\d+) fulfil what is said; say in 'branch' which, e\.g\. '((\w+) (\w+)(?: of)? (\w)(\w?))'"
)


@pytest.mark.parametrize("name", ["dump-hoist", "scissor-lift"])
def test_each_branch_that_is_advised_leaves_fewer_assemblies_until_one_is_left(name: str) -> None:
    mech, left = replace(load(name).mechanism, branches=(), guesses={}), 99
    while (refusal := refused(mech)) is not None:
        told = ADVICE.search(refusal.words.en)
        assert told and f"例如 '{told[2]}'" in refusal.words.zh, refusal
        ways, _, point, side, *letters = told.groups()
        ref = tuple(filter(None, letters))
        assert 1 < int(ways) < left and len({point, *ref}) == 1 + len(ref)
        left, more = int(ways), SideOf(point=point, side=Side(side), ref=ref)
        mech = replace(mech, branches=(*mech.branches, more))
    assert mech.branches


def refused(mech: Mechanism) -> AssemblyError | None:
    """What is said where the assembly is not decided."""
    try:
        oracle.solve(mech, order=0)
    except AssemblyError as refusal:
        return refusal
    return None
