"""Whole-cycle numbers of a mechanism: columns over the drive's positions, exact extremes, facts, paths, tables.

turn = cycle(vecpoly.load("A-27"), n=361)
turn.column("omega_5"), turn.column("a_F")       # rad/s, complex m/s²
extremes(turn, "alpha_5").highest                 # to full accuracy, not on the grid
"""

from __future__ import annotations

from .column import Column
from .cycle import Cycle
from .extremes import Extremes, Spot, extremes
from .facts.force_words import force_sentences
from .facts.found import Facts, facts
from .facts.path import Path, Shape, path
from .facts.path_words import path_sentences
from .facts.sentences import sentences
from .table import Table, csv_bytes, table, xlsx_bytes
from .whole_cycle import cycle

__all__ = [
    "Column",
    "Cycle",
    "Extremes",
    "Facts",
    "Path",
    "Shape",
    "Spot",
    "Table",
    "csv_bytes",
    "cycle",
    "extremes",
    "facts",
    "force_sentences",
    "path",
    "path_sentences",
    "sentences",
    "table",
    "xlsx_bytes",
]
