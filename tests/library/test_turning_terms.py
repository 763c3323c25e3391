"""A term of an equation that says α l stands there only where the link is turned faster or slower."""

from __future__ import annotations

import re

from tests.drawn_library import drawn, given
from tests.each import each
from vecpoly import oracle

OF_LINK = re.compile(r"\$α_\{?(\w+?)\}? l_")
DRIVEN_EVENLY = ("3-11", "oldham-coupling", "A-16", "inclined-cross-slide")
OTHERS = ("swinging-block-offset-rod", "pinion-drives-rack", "stepped-planet")


@each((*DRIVEN_EVENLY, *OTHERS))
def test_no_equation_has_a_tangential_term_of_a_link_that_turns_evenly(name: str) -> None:
    mech = given(name).mechanism
    motion = oracle.solve(mech)
    alphas = {str(mech.number(link)): float(motion.alpha(link)) for link in mech.numbered}
    tables = [step.equation for step in drawn(name).construction.steps if step.equation is not None]
    assert tables
    for link in (found[1] for table in tables for told in table.magnitudes if (found := OF_LINK.match(told))):
        assert abs(alphas[link]) > 1e-9, link
