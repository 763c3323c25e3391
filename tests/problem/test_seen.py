"""What words say of places a sketch has as data: the same letters, the same numbers; no sketch reads the words."""

from __future__ import annotations

import re
from math import degrees
from pathlib import Path

import pytest

import vecpoly.report.sizes
from tests.drawn_library import LIBRARY, given
from tests.each import each
from vecpoly.problem.values.given import Datum
from vecpoly.problem.values.seen import Counted, Leaning, OffItsGuide, Round, SetOff

OFF = re.compile(
    r"\$(\w+)\$ lies ([\d.]+) mm from \$(\w+)\$ along [^.;]+?( produced backwards)? "
    r"and ([\d.]+) mm to its (left|right)"
)
END = "[A-Z][a-z]*"
LINE = rf"(?:\$({END}){END}\$|the guide through \$({END})\$)"
LEANS = re.compile(rf"{LINE} is at ([\d.]+)° to the (?:\$x\$ axis|horizontal)(, clockwise)?")
ALONG = re.compile(rf"\$({END}){END}\$ is (?:in the direction of|(opposite to)) the \$x\$ axis")
SQUARE = re.compile(rf"{LINE} is (?:horizontal|(vertical))")
TO_GUIDE = re.compile(
    rf"\$({END})({END})\$ is (?:at ([\d.]+)° to|(in the direction of)|(opposite to)) the guide of link (\w+)"
    "(, clockwise)?"
)
COUNTS = re.compile(r"\$s_(\w)\$ counts (to the right|upwards) from the")
ROUND = re.compile(r"\$(r(?:_\w+)?)\$ = ([\d.]+) mm")


def said(text: str) -> float:
    return float(text.replace("−", "-"))


def told(datum: Datum) -> object:
    """What the English words say."""
    words = datum.of("en") if datum.words is not None and not datum.symbol else ""
    if found := OFF.search(words):
        point, along, start, back, off, side = found.groups()
        return point, start, said(along) * (-1 if back else 1), said(off) * (1 if side == "left" else -1)
    if found := LEANS.search(words):
        return found[1] or found[2], -said(found[3]) if found[4] else said(found[3])
    if found := ALONG.search(words):
        return found[1], 180.0 if found[2] else 0.0
    if found := SQUARE.search(words):
        return found[1] or found[2], 90.0 if found[3] else 0.0
    if found := TO_GUIDE.search(words):
        turn = said(found[3]) if found[3] else 180.0 if found[5] else 0.0
        return found[1], found[2], found[6], -turn if found[7] else turn
    if found := COUNTS.search(words):
        return found[1], found[2] == "upwards"
    if found := ROUND.search(words):
        return found[1], said(found[2])
    return None


def printed(size: float) -> object:
    """The same but for the sixth figure, which is the last that is printed."""
    return pytest.approx(size, rel=5.1e-6)


def seen(datum: Datum) -> object:
    """The same of the data."""
    match datum.seen:
        case SetOff(point=point, start=start, along=along, left=left):
            return point, start, printed(1e3 * along), printed(1e3 * left)
        case Leaning(at=at, turn=turn):
            return at, printed(degrees(turn))
        case OffItsGuide(at=at, end=end, link=link, turn=turn):
            return at, end, link, printed(degrees(turn))
        case Counted(link=link, upright=upright):
            return link, upright
        case Round(symbol=symbol, radius=radius):
            return symbol, printed(1e3 * radius)
    return None


@each(LIBRARY)
def test_what_words_say_of_places_is_handed_to_the_sketch_as_data(name: str) -> None:
    for datum in given(name).given.data:
        assert told(datum) == seen(datum), datum.of("en")


def test_no_file_of_the_sizes_of_mechanisms_looks_into_english_words() -> None:
    folder = Path(next(iter(vecpoly.report.sizes.__path__)))
    for path in folder.glob("*.py"):
        text = path.read_text(encoding="utf-8")
        assert '.of("en")' not in text and "words.en" not in text, path.name
