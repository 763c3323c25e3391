"""Names of objects: what GeoGebra takes for a label, and what stands beside the object on the page."""

from __future__ import annotations

import re

from ...board.place import View
from ...foundation.indices import ON_LINE
from ...names import subscripted

# a polygon's letters are told from each other by its kind
INDEX = {View.MECHANISM: "", View.VELOCITY: "v", View.ACCELERATION: "a"}
_END = re.compile(r"([^\W\d_])('*)(\d*)('*)")
_GREEK = {"omega": "ω", "alpha": "α", "gamma": "γ", "phi": "φ", "mu": "μ"}


class Labels:
    """The labels of one file, each given once."""

    def __init__(self) -> None:
        self._given: set[str] = set()

    def point(self, letter: str, view: View) -> str:
        """The label of a lettered point: B, C_{2}, c_{2v}, c_{2a}."""
        base, rest = letter[:1], re.sub(r"[^0-9A-Za-z]", "", letter[1:].translate(ON_LINE))
        return self.new(base, rest + INDEX[view])

    def quantity(self, key: str, end: str = "") -> str:
        """The label of a quantity: ω_{2}, v_{C2B}, an_{CB}."""
        base, _, index = key.partition("_")
        return self.new(_GREEK.get(base, base), re.sub(r"[^0-9A-Za-z]", "", index.translate(ON_LINE)) + end)

    def new(self, base: str, index: str) -> str:
        """base_{index}, with a number behind it where the name is in use."""
        for n in range(1, 10_000):
            tail = index + (f"n{n}" if n > 1 else "")
            label = f"{base}_{{{tail}}}" if tail else base
            if label not in self._given:
                self._given.add(label)
                return label
        raise AssertionError(base)


def named(key: str) -> str:
    """A quantity by its key, with the letter that is printed: ω_2, α."""
    base, low, index = key.partition("_")
    return f"{_GREEK.get(base, base)}{low}{index}"


def length(ends: str) -> str:
    """A length by its two ends as TeX: $p'd'$, $n_{2}'c_{2}'$."""
    each = _END.findall(ends.replace("′", "'"))
    if "".join("".join(parts) for parts in each) != ends.replace("′", "'"):
        return caption(ends)
    one = (f"{letter}{first}{last}" + (f"_{{{index}}}" if index else "") for letter, first, index, last in each)
    return f"${''.join(one)}$"


def caption(letter: str) -> str:
    """A letter with its index and prime as TeX: $c_{2}'$."""
    plain = letter.translate(ON_LINE).translate(str.maketrans("′", "'", "^{}"))
    primes = "'" * plain.count("'")
    base, _, index = subscripted(plain.replace("'", "")).partition("_")
    return f"${base}{primes}" + (f"_{{{index}}}" if index else "") + "$"
