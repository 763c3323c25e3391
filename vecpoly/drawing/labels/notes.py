"""Short texts of several lines: the words of a box, a note, a title too long for its figure."""

from __future__ import annotations

from functools import lru_cache

from ...typeset import Box, layout_words
from ...typeset.box import place, scaled
from ...typeset.words import is_han

LEADING = 1.3  # baseline to baseline, em
WIDE_SPACE = "\u3000"  # parts the names in a title strip
MARKS, PARTICLES = "，、：；", "的"  # behind which a line of Chinese may end without parting a word
WORTH = 1.2  # by how much larger type must become for a line to be folded


@lru_cache(maxsize=1024)  # the same titles and words of boxes come again and again
def lines(text: str, em: float) -> Box:
    """The lines of a text one under the other, centred; the origin on the first baseline."""
    boxes = [layout_words(line, em) for line in text.split("\n")]
    width = max(box.width for box in boxes)
    return place([((width - box.width) / 2, -LEADING * em * i, box) for i, box in enumerate(boxes)], width)


def fitted(text: str, em: float, width: float, height: float) -> Box:
    """The lines of a text, folded and made smaller only as far as their place asks."""
    boxes = [lines(one, em) for one in (text, folded(text, em, width))]
    factors = [
        min(1.0, max(width, 1.0) / box.width, max(height, 1.0) / box.height) if box.items else 1.0 for box in boxes
    ]
    box, factor = (boxes[1], factors[1]) if factors[1] > WORTH * factors[0] else (boxes[0], factors[0])
    return box if factor == 1.0 else scaled(box, factor)


def folded(text: str, em: float, width: float) -> str:
    """The text with each line on two of like length where it would be wider than `width` mm."""
    return "\n".join(_folded(line, em, width) for line in text.split("\n"))


def _folded(line: str, em: float, width: float) -> str:
    """On two lines: parted where a name ends, or else between words or behind a mark, or else wherever it may be."""
    if lines(line, em).width <= width:
        return line
    breaks = _breaks(line)
    for some in ([i for i in breaks if line[i - 1] == WIDE_SPACE], [i for i in breaks if _is_between(line, i)], breaks):
        halves = [f"{line[:i].rstrip()}\n{line[i:].lstrip()}" for i in some]
        best = min(halves, key=lambda half: lines(half, em).width, default=line)
        if lines(best, em).width <= width:
            return best
    return best


def _is_between(text: str, i: int) -> bool:
    """Whether two words or parts of a sentence meet here, for certain: Chinese writes most words without a space."""
    return text[i - 1] in f" {WIDE_SPACE}{MARKS}{PARTICLES}" or text[i] in "（【“与和及"


def _breaks(text: str) -> list[int]:
    """Where a line may end: at spaces and between Chinese characters, never inside a formula, beside an equals sign,
    before a number, a dash or punctuation."""
    return [
        i
        for i in range(1, len(text))
        if text[:i].count("$") % 2 == 0
        and text[i] not in "，。、：；）)】”,.:;=—– 0123456789"
        and text[:i].rstrip()[-1:] not in "（(=“"
        and (text[i - 1] in f" {WIDE_SPACE}{MARKS}" or (is_han(text[i]) and is_han(text[i - 1])) or text[i] in "（“")
    ]
