"""QR codes of level Q, module by module as `segno` makes them, in a third of its time: all masks weighed together."""

from __future__ import annotations

from functools import cache, lru_cache
from typing import Any

import numpy as np
import segno
from numpy.typing import NDArray

Squares = NDArray[np.uint8]
Rows = tuple[bytes, ...]  # from the top; 1 black
MASKS, LARGEST = 8, 41  # modules of a side, up to which there is one alignment pattern and no version told
_EYE, _WHITE = bytes((1, 0, 1, 1, 1, 0, 1)), bytes(4)


@lru_cache(maxsize=4)
def modules(code: str) -> Rows:
    """The modules of the code that says this."""
    made = _made(code, 0)
    if len(made) > LARGEST:
        return _rows(_made(code, None))
    told, masks = _format(len(made)), _masks(len(made))
    each = np.where(told, 0, made) ^ masks[0] ^ masks
    best = min(range(MASKS), key=_penalties(each).__getitem__)
    return _rows(np.where(told, _formatted(len(made), best), each[best]))


def _made(code: str, mask: int | None) -> Squares:
    return _modules(segno.make(code, error="q", micro=False, boost_error=False, mask=mask))


def _modules(made: Any) -> Squares:
    return np.frombuffer(b"".join(made.matrix), np.uint8).reshape(len(made.matrix), -1)


def _rows(made: Squares) -> Rows:
    return tuple(row.tobytes() for row in made)


@cache
def _format(size: int) -> NDArray[np.bool_]:
    """Where it is told which mask was taken, with the module there that is always black: blank while masks are
    weighed."""
    told = np.zeros((size, size), np.bool_)
    for i in (*range(6), 7, 8, *range(size - 8, size)):
        told[8, i] = told[i, 8] = True
    told[8, 8] = True
    return told


@cache
def _formatted(size: int, mask: int) -> Squares:
    """A code of this size with this mask: of all of them the same stands where the mask is told."""
    return _modules(segno.make("0", version=(size - 17) // 4, error="q", micro=False, boost_error=False, mask=mask))


@cache
def _masks(size: int) -> Squares:
    """Which modules each mask turns; none of the patterns by which a reader finds its way."""
    i, j = np.indices((size, size))
    free = (i != 6) & (j != 6) & ~((i < 9) & ((j < 9) | (j > size - 9))) & ~((i > size - 9) & (j < 9))
    if size > 21:
        free &= (abs(i - (size - 7)) > 2) | (abs(j - (size - 7)) > 2)
    turns = (
        (i + j) % 2,
        i % 2,
        j % 3,
        (i + j) % 3,
        (i // 2 + j // 3) % 2,
        i * j % 2 + i * j % 3,
        (i * j % 2 + i * j % 3) % 2,
        ((i + j) % 2 + i * j % 3) % 2,
    )
    return np.array([free & (one == 0) for one in turns], np.uint8)


def _penalties(each: Squares) -> list[int]:
    """What ISO/IEC 18004:2015, 7.8.3.1, holds against each of these."""
    lines: Squares = np.concatenate((each, each.transpose(0, 2, 1)), axis=1)
    size = lines.shape[2]
    alike = lines[:, :, 1:] == lines[:, :, :-1]
    five = alike[:, :, :-3] & alike[:, :, 1:-2] & alike[:, :, 2:-1] & alike[:, :, 3:]
    begun = five[:, :, 0].sum(axis=1) + (five[:, :, 1:] & ~five[:, :, :-1]).sum(axis=(1, 2))
    runs = five.sum(axis=(1, 2)) + 2 * begun
    across, down = alike[:, :size], alike[:, size:].transpose(0, 2, 1)
    blocks = 3 * (across[:, 1:] & across[:, :-1] & down[:, :, 1:]).sum(axis=(1, 2))
    eyes = [40 * _eyes(one) for one in lines]
    dark = [10 * int(abs(float(one) / size**2 * 100 - 50) / 5) for one in each.sum(axis=(1, 2))]
    parts: tuple[Any, ...] = (runs, blocks, eyes, dark)
    return [int(sum(of)) for of in zip(*parts, strict=True)]


def _eyes(lines: Squares) -> int:
    """What looks like a finder pattern, with white of four modules before or behind; all about a code is white."""
    said = np.pad(lines, ((0, 0), (len(_WHITE), len(_WHITE)))).tobytes()
    count, at = 0, said.find(_EYE)
    while at != -1:
        end = at + len(_EYE)
        lone = said.startswith(_WHITE, at - len(_WHITE)) or said.startswith(_WHITE, end)
        count += lone
        at = said.find(_EYE, end if lone else at + 4)
    return count
