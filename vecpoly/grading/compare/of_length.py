"""A value that drawings hardly tell from another is held against the own length that it was computed from."""

from __future__ import annotations

from collections.abc import Mapping

from ..key import AnswerKey, Graded, Kind
from .band import Target, gap, widened
from .measured import Measured
from .outcome import Outcome
from .own import Follower


def contradicted(
    key: AnswerKey, given: Mapping[str, Measured], exact: Mapping[str, Outcome], follower: Follower
) -> dict[str, Target]:
    """What does not agree with the own length beside it, and what follows from that.

    Of what is demoted T says little: twice the right force may lie within it. Whoever measured the length rightly and
    writes another value has reckoned wrongly, whether or not own values are followed through.
    """
    found = {}
    for one in key.quantities:
        if not one.demoted or one.key not in given or not _measured(key.find(one.line), one, given, exact):
            continue
        target = of_length(one, key[one.line], given[one.line], follower)
        off = abs(gap(given[one.key].value, one, target))
        if off > key.allowance.wrong * widened(given[one.key], target):
            found[one.key] = target
    return found


def of_length(one: Graded, line: Graded, mine: Measured, follower: Follower) -> Target:
    """What follows from an own length: a value that is computed from one length alone is in proportion to it."""
    value = one.exact * abs(mine.value) / line.exact
    return Target(value=value, allowed=follower.allowed(one, abs(value)))


def _measured(line: Graded | None, one: Graded, given: Mapping[str, Measured], exact: Mapping[str, Outcome]) -> bool:
    """Whether the one length that a value is computed from was written, and is right."""
    return (
        line is not None
        and line.kind is Kind.READING
        and one.needs == (line.key,)
        and bool(line.exact)
        and line.key in given
        and exact[line.key].is_right
    )
