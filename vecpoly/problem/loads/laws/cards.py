"""The file of a table of sizes, put into the problem's values: columns as headed, rows of numbers as written."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .... import limits
from ....errors import FaultError, ProblemFileError, VecpolyError
from ....words import Words
from ...schema.faults import Place
from ...text.source import Tree, decoded

_MARKS = ",;\t，"


def with_cards(tree: Tree) -> Tree:
    """The tree with columns and rows beside the name of every table's file; raises ProblemFileError at its line."""
    for path, holder in _holders(tree):
        size = holder[path[-1]]
        if isinstance(size, dict) and isinstance(size.get("table"), str) and "rows" not in size:
            path = (*path, "table")
            place = tree.places.get(path, tree.places.get(path[:2], Place(tree.name)))
            try:
                columns, *rows = _cells(_text(tree, size["table"], place), size["table"])
            except (FaultError, ProblemFileError) as error:
                raise ProblemFileError(error.words, code=error.code, numbers=error.numbers).at(place, *path) from None
            holder[path[-2]] = size | {"columns": columns, "rows": rows}
    return tree


def _holders(tree: Tree) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    """Where a table may stand, as the path to it and the mapping that has it: the size of a load, a datum of a
    device."""
    loads, data = tree.data.get("loads"), tree.data.get("data")
    for name, load in loads.items() if isinstance(loads, dict) else ():
        if isinstance(load, dict) and "size" in load:
            yield ("loads", name, "size"), load
    if isinstance(data, dict):
        yield from ((("data", name), data) for name in data)


def _text(tree: Tree, name: str, place: Place) -> str:
    """The text of the file, which lies beside the one that names it, or which the resolver has."""
    if (data := tree.reach.held(name)) is not None:
        return decoded(data, name)
    file = Path(place.file).parent / name
    tree.reach.refuse_outside(file)
    if not file.is_file():
        raise FaultError(
            Words(
                f"本文件旁没有数据表“{name}”（已查找 {file}）；请把它放在题目文件旁",
                f"no table '{name}' beside this file (looked for {file}); put it there",
            ),
            code="file",
        )
    try:
        data = file.read_bytes()
    except OSError as error:
        raise VecpolyError(Words(f"{file}：不能读取：{error}", f"{file}: cannot be read: {error}")) from None
    if file not in tree.files:
        tree.files = (*tree.files, file)
    return decoded(data, str(file))


def _cells(text: str, name: str) -> list[list[str]]:
    """Rows of two cells, the header first; empty lines and those that begin with # are left out."""
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    mark = next((mark for mark in _MARKS if lines and mark in lines[0]), ",")
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, delimiter=mark)]
    except csv.Error as error:
        raise FaultError(Words(f"{name} 无法读取（{error}）", f"{name} cannot be read ({error})")) from None
    if len(rows) > limits.TABLE_ROWS:
        raise FaultError(
            Words(
                f"{name} 有 {len(rows)} 行；上限为 {limits.TABLE_ROWS} 行，请减少行数",
                f"{name} has {len(rows)} rows; the limit is {limits.TABLE_ROWS}, take fewer",
            ),
            code="out-of-range",
        )
    for number, row in enumerate(rows, 1):
        if len(row) != 2:
            raise FaultError(
                Words(
                    f"{name} 第 {number} 行有 {len(row)} 列；应为两列：位置（phi 或 s）和大小（F、M 或 p）",
                    f"{name}, row {number} has {len(row)} columns; a table of sizes has two: the place (phi or s), and "
                    "the size (F, M or p)",
                ),
                code="spelling",
            )
    if len(rows) < 3:
        raise FaultError(
            Words(
                f"{name} 只有 {len(rows)} 行；至少要有表头和两行数据",
                f"{name} has {len(rows)} rows; it needs a header and two rows of numbers at least",
            ),
            code="missing",
        )
    return rows
