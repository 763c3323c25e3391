"""The appendix: the problem file as written, and the data of all points and links."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...words import Words
from ..flow.listing import Listing
from .numbering import TINY, Press
from .results import tabled
from .study import Study

_COLUMNS = 12


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The listing and the tables; tables only for what chapter 5 does not show."""
    press.chapter = "A"
    text = study.problem.text
    return {"file": press.objects.add("listing", Listing(text)) if text else "", "tables": list(_tables(study, press))}


def _tables(study: Study, press: Press) -> Iterator[str]:
    """The points that chapter 5 leaves out, two to a table; slides and transmission angles."""
    rest = [c.key[2:] for c in study.whole.columns if c.key.startswith("p_") and c.key[2:] not in study.points]
    for pair in (rest[i:i + 2] for i in range(0, len(rest), 2)):
        names = "、".join(f"${letter}$" for letter in pair), " and ".join(f"${letter}$" for letter in pair)
        yield tabled(study, press, [f"{stem}_{letter}" for letter in pair for stem in "pva"],
                     Words(f"{names[0]} 点的位置、速度和加速度", f"Position, velocity and acceleration of {names[1]}"), TINY)
    slides = [c.key for c in study.whole.columns if c.key.startswith("s_")]
    told = [key for s in slides for key in (s, f"v_{s[2:]}", f"a_{s[2:]}")] + [t.key for t in study.facts.transmissions]
    for i in range(0, len(told), _COLUMNS):
        yield tabled(study, press, told[i:i + _COLUMNS], Words("移动副的相对运动和传动角", "Sliding motions and transmission angles"), TINY)
