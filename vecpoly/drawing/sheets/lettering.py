"""What the lettering of a figure will take, estimated from its marks before any letter has a place.

A letter stands out from the figure where what it names is near the edge; titles and scales stand below. Nothing is
placed here: scales are chosen by this, and the same for both languages.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...board.construction import Figure
from ...board.paper.extent import bounds, corners
from ...board.paper.marks import Mark, TurnArrow, Vector
from .slicing import Size

BARE, HIGH = 1.5, 5.5  # mm: what lines stand out by their width; what a line of type does
FIRST, LETTER, LONGEST = 3.5, 2.0, 13.5  # mm: of a label without letters, of each of its letters, of the longest label
TURN = 5.0  # mm that a label of a turning arrow stands farther out
BOTH = 0.75  # labels seldom stand out as far as they can on both sides
UNDER, FOLDED = 16.0, 70.0  # mm: title and scale below the figure; a longer title takes two lines
CHINESE, LATIN, SHORTEST = 4.2, 2.1, 33.0  # mm: of a character of a title; of the scale below it
RESERVE = 2.0  # mm


def lettered(figure: Figure) -> Size:
    """Width and height of a figure with its labels, title and scale (mm), as it is drawn."""
    (wide, high), title = labelled(figure), title_width(figure)
    return max(wide, min(title, FOLDED)), high + UNDER + (HIGH if title > FOLDED else 0.0)


def beside_title(figure: Figure) -> float:
    """The white (mm) in the width of a figure that is narrower than its title."""
    return max(min(title_width(figure), FOLDED) - labelled(figure)[0], 0.0)


def title_width(figure: Figure) -> float:
    """How long the title is in one line, or the scale below it."""
    zh, en = (len(title.replace("$", "")) for title in (figure.title.zh, figure.title.en))
    return max(CHINESE * zh, LATIN * en, SHORTEST)


def labelled(figure: Figure) -> Size:
    """Width and height with the labels alone."""
    low, high = bounds(figure.marks)
    left, right, foot, head = BARE, BARE, BARE, BARE
    for at, wide, tall in _labels(figure.marks):
        left, right = max(left, wide - (at - low).real), max(right, wide - (high - at).real)
        foot, head = max(foot, tall - (at - low).imag), max(head, tall - (high - at).imag)
    return (high - low).real + BOTH * (left + right) + RESERVE, (high - low).imag + BOTH * (foot + head)


def _labels(marks: Sequence[Mark]) -> list[tuple[complex, float, float]]:
    """Where each label belongs, and how far it may reach from there to the sides, and up or down."""
    found = []
    for mark in marks:
        label = getattr(mark, "label", "")
        spots = [(mark.a + mark.b) / 2] if isinstance(mark, Vector) else list(corners(mark))
        if not isinstance(label, str) or not label or not spots:
            continue
        reach = min(FIRST + LETTER * len(re.sub(r"[_{}^$]", "", label)), LONGEST)
        out = TURN if isinstance(mark, TurnArrow) else 0.0
        found.append((sum(spots) / len(spots), reach + out, HIGH + out))
    return found
