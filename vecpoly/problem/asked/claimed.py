"""Printed answers said beside a problem, v_D=0.49 or "omega_3=2.1 rad/s", in place of those in its file."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...errors import UnknownNameError
from ...names import parse_rel
from ..build import build
from ..load import locate, tree_of
from ..problem import Problem
from ..reach import Reach
from ..schema.faults import Place
from ..text.overlay import overlay
from ..text.source import Tree

CLAIM = re.compile(r"([^\s=]+)\s*=\s*(.+)")
_BARE = re.compile(r"[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def load_claimed(where: str, claims: Sequence[str], *, allow_outside: bool = False) -> Problem:
    """The problem with these printed answers; a bare number is in the SI unit of its symbol.

    Raises ProblemFileError for symbols and units that do not belong to the problem.
    """
    found = [CLAIM.fullmatch(claim.strip()) for claim in claims]
    printed = [{"symbol": one[1], "value": _with_unit(one[1], one[2].strip())} for one in found if one]
    places = {
        ("printed", i, *key): Place(claim) for i, claim in enumerate(claims) for key in ((), ("symbol",), ("value",))
    }
    path = locate(where)
    reach = Reach(path.parent, allow_outside)
    return build(overlay(tree_of(path, reach=reach), Tree(str(path), {"printed": printed}, places, reach=reach)), path)


def _with_unit(symbol: str, value: str) -> str:
    if not _BARE.fullmatch(value):
        return value
    try:
        return f"{value} {parse_rel(symbol).unit}"
    except UnknownNameError:
        return value  # a force, an efficiency: read as it is written
