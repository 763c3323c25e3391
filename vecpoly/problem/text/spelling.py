"""Symbols as people write them, ω3, w_3, vE, a^n_{CB}, and the key that is meant: omega_3, v_E, an_CB."""

from __future__ import annotations

import re

from ...errors import UnknownNameError
from ...foundation.indices import DIGITS
from ...foundation.patterns import pattern
from ...names import parse_rel
from ...words import Words

RAISED = {"ⁿ": "n", "ᵗ": "t", "ᵏ": "k", "ʳ": "r", "ᶜ": "k"}  # the parts of an acceleration, set as a small letter
_SMALL = str.maketrans(
    {
        **dict(zip(DIGITS, "0123456789", strict=True)),
        **{sign: f"^{part}" for sign, part in RAISED.items()},
        "ω": "omega",
        "Ω": "omega",
        "α": "alpha",
        "ε": "alpha",
        "′": "'",
    }
)
_NOISE = pattern(r"[\s{}$()|/\\·]")
_TURN = pattern(r"(omega|omga|w|alpha|alfa|epsilon|eps)_?(\d+[a-z']?)", re.I)
_PART = pattern(r"(?P<kind>[pvars])(?:\^?_?(?P<part>[ntkr]))?_?(?P<at>[A-Z].*)")
_PART_BEHIND = pattern(r"(?P<kind>a)_?(?P<at>[A-Z][A-Za-z\d']*?)_?\^(?P<part>[ntkr])")
_RATE = {"o": "omega", "w": "omega", "a": "alpha", "e": "alpha"}


_GREEK = str.maketrans({"ω": "omega", "α": "alpha", "γ": "gamma"})


def plain(text: str) -> str:
    """The key behind a symbol in the letters of a textbook: ω_3 → omega_3, aⁿ_CB → an_CB; and behind one that has the
    letters and figures of a single key, ω3, a_{C}, v_C/B. Letters that may be others (w3, v_e) stay as they are."""
    key = re.sub(r"^a([ⁿᵗᵏʳᶜ])", lambda m: f"a{RAISED[m[1]]}", text).translate(_GREEK)
    guess = intended(text)
    return guess if guess and bare_letters(guess) == bare_letters(text) else key


def bare_letters(text: str) -> str:
    """The letters and figures of a symbol without what sets them: R₁₂, R_{12}, R_12 → R12."""
    return _NOISE.sub("", text.translate(_SMALL)).replace("_", "").replace("^", "")


def intended(text: str) -> str | None:
    """The key that such a spelling stands for; None where there is none."""
    bare = _NOISE.sub("", text.translate(_SMALL))
    for guess in _guesses(bare):
        try:
            return parse_rel(guess).key
        except UnknownNameError:
            continue
    return None


def did_you_mean(text: str) -> Words:
    """'; did you mean omega_3?', or nothing."""
    key = intended(text)
    return Words(f"；是否指“{key}”？", f"; did you mean '{key}'?") if key and key != text else Words.same("")


def _guesses(bare: str) -> list[str]:
    if turn := _TURN.fullmatch(bare):
        return [f"{_RATE[turn[1][0].lower()]}_{turn[2]}"]
    if re.fullmatch(r"a_?\d+", bare):
        return [f"alpha_{bare.lstrip('a_')}"]
    found = (
        _PART_BEHIND.fullmatch(bare)
        or _PART.fullmatch(bare)
        or _PART.fullmatch(bare[:1].lower() + bare[1:])
        or _PART.fullmatch(_capital(bare))
    )
    if found is None:
        return []
    kind = {"r": "p", "s": "p"}.get(found["kind"], found["kind"])
    return [f"{kind}{found['part'] or ''}_{found['at']}"]


def _capital(bare: str) -> str:
    """v_e → v_E: letters of points are capitals."""
    stem, line, rest = bare.partition("_")
    return f"{stem}{line}{rest.upper()}" if line else bare
