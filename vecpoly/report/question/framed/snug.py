"""Frames on a sheet that fixed parts of it cannot hold: it is cut as the figures need, and its white shared out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise

from ....drawing.sheets.mounting.spreading import Box, least
from ....drawing.sheets.slicing import Cut, Piece, Size, Slicing

PARTS = 20  # of a sheet's width and of its height: there cuts are made, wherever the figures leave them free


def snug(sizes: Sequence[Size], room: Size) -> Iterator[list[Box]]:
    """Every way to cut the room, each in boxes that fill it: those of figures of these sizes, in their order."""
    if sum(wide * high for wide, high in sizes) <= room[0] * room[1]:
        for _, _, piece in Slicing(sizes, room).shapes(0, len(sizes)):
            boxes = dict(_filled(piece, (0.0, 0.0, *room), sizes, room))
            yield [boxes[n] for n in range(len(sizes))]


def _filled(piece: Piece, box: Box, sizes: Sequence[Size], room: Size) -> Iterator[tuple[int, Box]]:
    """The box of each figure of a piece that fills this one."""
    if not isinstance(piece, Cut):
        yield piece, box
        return
    left, top, wide, high = box
    axis = 1 if piece.down else 0
    ends = _cuts([least(part, sizes)[axis] for part in piece.pieces], box[axis], box[2 + axis], room[axis] / PARTS)
    for part, (start, end) in zip(piece.pieces, pairwise(ends), strict=True):
        into = (left, start, wide, end - start) if piece.down else (start, top, end - start, high)
        yield from _filled(part, into, sizes, room)


def _cuts(needs: Sequence[float], start: float, length: float, step: float) -> list[float]:
    """Where pieces of these needs begin and end: each with its share of the white, at a multiple of the step where
    that leaves to every piece what it needs."""
    share, ends, spare = length / sum(needs), [start], start + length - sum(needs)
    for taken in list(accumulate(needs))[:-1]:
        wanted = round((start + share * taken) / step) * step
        lowest = ends[-1] + needs[len(ends) - 1]
        ends.append(min(max(wanted, lowest), spare + taken))
    return [*ends, start + length]
