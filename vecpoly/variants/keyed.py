"""The key of a variant as the register has it: what is demoted for one is demoted for all."""

from __future__ import annotations

from ..foundation.slotted import replace
from ..grading.key import AnswerKey
from .judge import Standard


def key_for(key: AnswerKey, standard: Standard) -> AnswerKey:
    """The key with the quantities of the standard demoted, and no others: all have the same work."""
    quantities = tuple(
        replace(one, demoted=one.key in standard.demoted if one.asked else one.demoted) for one in key.quantities
    )
    return replace(key, quantities=quantities)
