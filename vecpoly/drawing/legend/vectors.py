"""Which vector has which ink and shaft, where no letters stand at the vectors of a polygon."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import Point, Role, Vector
from ...board.paper.tones import key_of, whose
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...words import Lang, Words
from .entry import WIDE, Entry, drawn_as_on

_MOTION = pattern(r"\b([va])([nktr]?)_(\w+)")
_WHOLE = pattern(r"([va])_[A-Z]\d*")
_IMAGE = pattern(r"([a-z])\^?[′″]*")
_SHORT = 0.5  # mm: of what is shorter nothing can be seen
_ON = 0.05  # mm: an image no farther from a tip is on it


def key_of_vectors(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """An entry for each motion that the polygons of a sheet show in an ink of its own, in the order in which they are
    drawn: v_CB, a_CB, whose parts have its ink."""
    diagrams = (figure for figure in figures if figure.view is View.MECHANISM)
    points = {one.label for figure in diagrams for one in figure.marks if isinstance(one, Point)}
    found: dict[str, list[tuple[Figure, Vector]]] = {}
    for figure in figures:
        for mark in _unnamed(figure):
            found.setdefault(whose(key_of(mark)), []).append((figure, mark))
    for several in found.values():
        figure, mark = several[0]
        names = dict.fromkeys(" = ".join((_symbol(one.key), *_shared(on, one, points))) for on, one in several)
        found_too = any(one.role is Role.RESULT for _, one in several)
        sample = replace(mark, a=0j, b=complex(WIDE), role=Role.RESULT if found_too else mark.role)
        yield Entry(drawn_as_on(figure, (sample,), lang), Words.same(", ".join(f"${name}$" for name in names)))


def _unnamed(figure: Figure) -> Iterator[Vector]:
    if figure.view.images and figure.tones:
        vectors = (mark for mark in figure.marks if isinstance(mark, Vector) and not mark.label)
        yield from (mark for mark in vectors if abs(mark.b - mark.a) > _SHORT and whose(key_of(mark)) in figure.tones)


def _shared(figure: Figure, mark: Vector, points: set[str]) -> Iterator[str]:
    """The motions that this vector shows as well: those of the other points of the mechanism whose images are on its
    tip (a link moves without turning) and to which no vector is drawn: v_C beside v_B."""
    if (whole := _WHOLE.fullmatch(mark.key)) is None:
        return
    drawn = {one.key for one in figure.marks if isinstance(one, Vector)}
    tips = (one.label for one in figure.marks if isinstance(one, Point) and abs(one.at - mark.b) < _ON)
    images = (image[1].upper() for label in dict.fromkeys(tips) if (image := _IMAGE.fullmatch(label)) is not None)
    named = {f"{whole[1]}_{point}": f"{whole[1]}_{{{point}}}" for point in images}
    yield from (symbol for key, symbol in named.items() if key not in drawn and key[2:] in points)


def _symbol(key: str) -> str:
    """The symbol of the motion: a_{CB} of its parts aⁿ and aᵗ; that of Coriolis by itself; of a sum of parts, these."""
    kept = "nktr" if key.startswith("(") else "kr"
    return _MOTION.sub(lambda m: f"{m[1]}{f'^{m[2]}' if m[2] and m[2] in kept else ''}_{{{m[3]}}}", key.strip("()"))
