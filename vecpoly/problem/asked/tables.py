"""The printed tables that a problem file names."""

from __future__ import annotations

from pathlib import Path

from ...errors import FaultError
from ...words import Words
from ..schema.faults import Faults
from ..schema.models import ProblemSpec
from ..text.held import Held
from ..text.source import Tree


def read_tables(spec: ProblemSpec, tree: Tree, faults: Faults) -> tuple[Path | Held, ...]:
    """Files of printed tables, found beside the file that names them."""
    found: list[Path | Held] = []
    for i, name in enumerate(spec.tables):
        with faults.at("tables", i):
            if (data := tree.reach.held(name)) is not None:
                found.append(Held(name, data))
                continue
            place = tree.places.get(("tables", i))
            file = (Path(place.file).parent if place else Path()) / name
            tree.reach.refuse_outside(file)
            if not file.is_file():
                raise FaultError(
                    Words(
                        f"本文件旁没有数据表“{name}”（已查找 {file}）",
                        f"no table '{name}' beside this file (looked for {file})",
                    )
                )
            found.append(file)
    return tuple(found)
