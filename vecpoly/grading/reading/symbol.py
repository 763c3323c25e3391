"""A symbol as people type it: ω5, omega_5, a^n_CB, vD, and which of a key it is."""

from __future__ import annotations

import re
from collections.abc import Iterable
from difflib import get_close_matches

from ...errors import UnknownNameError
from ...words import Words
from .characters import plain

_GREEK = {
    "ω": "omega",
    "θ": "theta",
    "ϑ": "theta",
    "ψ": "psi",
    "β": "beta",
    "α": "alpha",
    "ε": "alpha",
    "η": "eta",
    "φ": "phi",
    "ϕ": "phi",
    "μ": "mu",
    "ρ": "rho",
    "δ": "delta",
    "Δ": "d",
    "λ": "lambda",
    "γ": "gamma",
    "ϖ": "omega",
}  # ε: α in many a course


def squeezed(symbol: str) -> str:
    """Letters and digits alone: a^n_{CB} → anCB, ω₅ and \\omega_5 → omega5."""
    text = "".join(_GREEK.get(letter, letter) for letter in plain(symbol))
    return re.sub(r"[\s_^{}$·\\]", "", text)


def keyed(symbol: str, keys: Iterable[str]) -> str:
    """The key that a typed symbol means. Raises UnknownNameError, with the nearest,
    where there is none, or more than one.
    """
    known = list(keys)
    if symbol in known:
        return symbol
    want = squeezed(symbol)
    for same in (str, str.lower, _latin, _centre, _bar):
        found = [key for key in known if same(squeezed(key)) == same(want)]
        if len(found) == 1:
            return found[0]
        if found:
            raise UnknownNameError(
                Words(
                    f"“{symbol}”可指 {'、'.join(found)}；请写全",
                    f"'{symbol}' may be {', '.join(found)}; write it in full",
                ),
                code="ambiguous-symbol",
            )
    near = get_close_matches(want, known, n=4, cutoff=0.3) or known[:8]
    raise UnknownNameError(
        Words(
            f"没有所求的量 {symbol}；有 {'、'.join(near)}",
            f"nothing asked is called '{symbol}'; there are {', '.join(near)}",
        ),
        code="unknown-symbol",
    )


def _latin(text: str) -> str:
    """w5 for ω5, aA for A: what a keyboard without Greek letters gives."""
    return re.sub(r"^w(?=\d)", "omega", text.lower())


def _centre(text: str) -> str:
    """P14 for P41: a centre is that of two links, whichever is named first."""
    return re.sub(r"^p(\d)(\d)$", lambda found: "p" + "".join(sorted(found.groups())), text.lower())


def _bar(text: str) -> str:
    """CD for DC, or for l_DC: a bar has two ends, whichever is named first."""
    return re.sub(r"^l?([A-Z])([A-Z])(?=\d*$)", lambda found: "".join(sorted(found.groups())), text)
