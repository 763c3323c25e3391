"""The printed tables that a problem file names."""

from __future__ import annotations

from pathlib import Path

from ..errors import FaultError
from ..words import Words
from .faults import Faults
from .schema import ProblemSpec
from .source import Tree


def read_tables(spec: ProblemSpec, tree: Tree, faults: Faults) -> tuple[Path, ...]:
    """Files of printed tables, found beside the file that names them."""
    found = []
    for i, name in enumerate(spec.tables):
        with faults.at("tables", i):
            place = tree.places.get(("tables", i))
            file = (Path(place.file).parent if place else Path()) / name
            tree.reach.refuse_outside(file)
            if not file.is_file():
                raise FaultError(Words(
                    f"本文件旁没有数据表“{name}”（已查找 {file}）",
                    f"no table '{name}' beside this file (looked for {file})"))
            found.append(file)
    return tuple(found)
