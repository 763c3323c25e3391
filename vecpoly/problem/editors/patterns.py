"""What the values of a problem file look like: quantities by kind, sentences of joints, branches, symbols."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from ...units.patterns import NUMBER, SENSE, pattern
from ...units.reading import Dim
from ..joints.branches import BRANCHES
from ..joints.contacts import FORMS as CONTACTS
from ..joints.rolling import FORMS as ROLLING
from ..joints.slides import FORMS as JOINTS
from ..loads.laws.lawful import CONSTANT
from ..text.chinese import SENTENCES as CHINESE

Schema = dict[str, Any]
_SYMBOL = (
    r"^((p|v|a|an|at|ak|ar|a[ⁿᵗᵏʳᶜ]|l)_[A-Z][A-Za-z0-9'′]*|(omega|alpha|gamma|ω|α|γ)_\w+[a-z']?"
    r"|alpha|gamma|α|γ|centres|P_\w+|phi_[A-Z]\w*_(extended|overlapped)|(delta|lambda|rho)_\w+|eta|η|m_e\d*|dW_max"
    r"|delta|dT_\w+|power_\w+|t_(end|at_\S+)|phi_(max|min|end)|omega_at_\S+"
    r"|theta_c\w+|ratio_c|[A-Z][A-Za-z]?\w*|[hmJ](_\w+)?)$"
)


def quantity(dim: Dim, *others: str) -> Schema:
    """A quantity with its unit, or one of the other ways of writing (patterns without anchors);
    a bare 0 may be a number."""
    texts = "|".join([pattern(dim), *(f"^ *({other}) *$" for other in others)])
    return {"anyOf": [{"type": "string", "pattern": texts}, {"const": 0}]}


def angle_from() -> Schema:
    """60 deg, or 60 deg from AD."""
    return quantity(Dim.ANGLE, rf"{pattern(Dim.ANGLE)[3:-3]} +from +\S+", rf"{NUMBER} +from +\S+")


def angle_or_along() -> Schema:
    """180 deg, or along AB."""
    return quantity(Dim.ANGLE, r"(along +|沿 *)\S+")


def number(*others: str) -> Schema:
    """A pure number, as text or as a number."""
    return {
        "anyOf": [
            {"type": "number"},
            {"type": "string", "pattern": "|".join(f"^ *({one}) *$" for one in (NUMBER, *others))},
        ]
    }


def omega() -> Schema:
    """An angular velocity, or its sense alone."""
    return quantity(Dim.OMEGA, SENSE)


def either(one: Dim, other: Dim) -> Schema:
    """A quantity of one of two kinds."""
    return quantity(one, pattern(other)[3:-3])


def size() -> Schema:
    """A force, a moment, ? for the load that balances, a constant moment, or a table."""
    force, moment = pattern(Dim.FORCE)[3:-3], pattern(Dim.MOMENT)[3:-3]
    return {
        "anyOf": [
            {"type": "string", "pattern": rf"^ *({force}|{moment}|\?|{'|'.join(CONSTANT)}) *$"},
            {"const": 0},
            {"$ref": "#/$defs/TableSpec"},
        ]
    }


def sentences(forms: Iterable[re.Pattern[str]]) -> Schema:
    """Texts that the reader of the file takes, by the reader's own patterns."""
    return {"type": "array", "items": {"type": "string", "pattern": "|".join(f"^({_ecma(form)})$" for form in forms)}}


def joints() -> Schema:
    """Sliding and rolling joints, and contacts."""
    return sentences((*JOINTS, *ROLLING, *CONTACTS, *CHINESE))


def branch() -> Schema:
    """C above AD; C 在 AD 上方."""
    return sentences(BRANCHES)


def symbols() -> Schema:
    """What may be asked, as a symbol."""
    return {"type": "string", "pattern": _SYMBOL}


def _ecma(form: re.Pattern[str]) -> str:
    return re.sub(r"\?P<\w+>", "", form.pattern)
