"""A YAML file as plain text values, each with its place: line numbers for every error."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path as FilePath
from pathlib import PurePath
from typing import Any

from .. import limits
from ..errors import ProblemFileError
from ..words import Words
from .characters import refuse_unwanted
from .faults import Path, Place
from .reach import Reach

PROSE = frozenset({"statement", "source", "errata", "note"})  # below these keys people write sentences

Value = Any  # str | None | list[Value] | dict[str, Value]; what is in a file is known only after validation


@dataclass(slots=True)
class Tree:
    """The values of a file (every scalar as its text) and the place of every key and item."""

    name: str
    data: dict[str, Value]
    places: dict[Path, Place] = field(default_factory=dict)
    text: str = ""
    files: tuple[FilePath, ...] = ()  # from which it was read
    reach: Reach = field(default_factory=Reach)  # which other files it may name


def read_text(path: FilePath) -> str:
    """The text of a file. Refuses by size before reading; UTF-8 only, with or without a byte order mark."""
    try:
        size = path.stat().st_size
        if size > limits.FILE:
            raise ProblemFileError(Words(f"{path}：{size / 1e6:.1f} MB，不是题目文件；上限为 {limits.FILE / 1e6:.0f} MB",
                                         f"{path}: {size / 1e6:.1f} MB is no problem file; the limit is {limits.FILE / 1e6:.0f} MB"), code="too large")
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise ProblemFileError(
            f"{path}, line {line}: byte {error.start} (0x{error.object[error.start]:02x}) is not UTF-8; "
            "save the file with the encoding UTF-8"
        ) from None
    except OSError as error:
        raise ProblemFileError(f"{path}: cannot be read: {error.strerror}") from None


def read(path: FilePath) -> Tree:
    """The values of a file."""
    tree = parse(read_text(path), str(path))
    tree.files = (path,)
    return tree


def parse(text: str, name: str) -> Tree:
    """Text to values with places. Raises ProblemFileError for anything that is no plain YAML mapping."""
    refuse_unwanted(text, name)
    node = _compose(text, name)
    tree = Tree(name, {}, text=text)
    data = None if node is None else _Reader(tree).value(node, ())
    if data is None:
        raise ProblemFileError(f"{name}, line 1: the file is empty; 'vecpoly new' writes one to start from")
    if not isinstance(data, dict):
        raise ProblemFileError(f"{name}, line 1: the file must be a mapping (key: value), not {_kind(data)}")
    tree.data = data
    return tree


def _compose(text: str, name: str) -> Any:
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError, YAMLError

    try:
        return YAML(typ="rt", pure=True).compose(text)
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        at = f", line {mark.line + 1}, column {mark.column + 1}" if mark else ""
        raise ProblemFileError(f"{name}{at}: no valid YAML: {_plainly(error)}") from None
    except RecursionError:
        raise ProblemFileError(f"{name}: nested too deeply; a problem file has four levels") from None
    except (YAMLError, ValueError) as error:
        raise ProblemFileError(f"{name}: no valid YAML: {str(error).splitlines()[0]}") from None


def _plainly(error: Any) -> str:
    problem = str(error.problem or error.context)
    if "\\t" in problem:
        return "a tab; indent with spaces"
    if "mapping values are not allowed" in problem:
        return "a second ':' on this line; put the text between quotes"
    return problem


class _Reader:
    """Walks the nodes once; refuses aliases, duplicate keys and depth."""

    def __init__(self, tree: Tree) -> None:
        self.tree, self.seen = tree, set[int]()

    def value(self, node: Any, path: Path) -> Value:
        mark = node.start_mark
        place = Place(self.tree.name, mark.line + 1, mark.column + 1)
        self.tree.places.setdefault(path, place)
        if id(node) in self.seen or len(path) > limits.DEPTH:
            raise ProblemFileError(
                f"{place.file}, line {place.line}: no YAML aliases or deep nesting here; write the value out"
            )
        self.seen.add(id(node))
        match node.id:
            case "mapping":
                self.counted(node, place)
                return self.mapping(node, path)
            case "sequence":
                self.counted(node, place)
                return [self.value(item, (*path, i)) for i, item in enumerate(node.value)]
            case _:
                empty = node.style is None and node.value in ("", "~", "null")
                return None if empty else self.scalar(str(node.value), place, limits.PROSE if PROSE.intersection(map(str, path)) else limits.SCALAR)

    def scalar(self, text: str, place: Place, most: int) -> str:
        """A text that is not too long, and holds no sign that escapes (`"\\e"`) have brought in."""
        if len(text) > most:
            raise ProblemFileError(Words(f"{place.file}，第 {place.line} 行第 {place.column} 列：此处有 {len(text)} 个字符，最多 {most} 个；请缩短",
                                         f"{place.file}, line {place.line}, column {place.column}: {len(text)} characters where at most {most} are possible; shorten the text"),
                                   code="too long", numbers={"characters": len(text), "limit": most})
        refuse_unwanted(text, place.file, place.line, place.column)
        return text

    def counted(self, node: Any, place: Place) -> None:
        """A list or mapping of not too many entries."""
        if len(node.value) > limits.ENTRIES:
            raise ProblemFileError(Words(f"{place.file}，第 {place.line} 行：此处有 {len(node.value)} 项，最多 {limits.ENTRIES} 项",
                                         f"{place.file}, line {place.line}: {len(node.value)} entries where at most {limits.ENTRIES} are possible"),
                                   code="too many", numbers={"entries": len(node.value), "limit": limits.ENTRIES})

    def mapping(self, node: Any, path: Path) -> dict[str, Value]:
        data: dict[str, Value] = {}
        for key, item in node.value:
            place = Place(self.tree.name, key.start_mark.line + 1, key.start_mark.column + 1)
            where = f"{place.file}, line {place.line}, column {place.column}"
            if key.id != "scalar":
                raise ProblemFileError(f"{where}: a key must be a plain word")
            self.scalar(key.value, place, limits.SCALAR)
            if ":" in key.value:
                raise ProblemFileError(f"{where}: '{key.value}': write a space and a value after the ':'")
            if key.value in data:
                first = self.tree.places[(*path, key.value)].line
                raise ProblemFileError(f"{where}: key '{key.value}' occurs twice (first in line {first})")
            self.tree.places[(*path, key.value)] = place
            data[key.value] = self.value(item, (*path, key.value))
        return data


def overlay(base: Tree, over: Tree) -> Tree:
    """`over` laid on `base`: mappings merged key by key, all else replaced; null takes a key away. The base's text follows the other's."""
    places = dict(base.places)
    text = f"{over.text.rstrip()}\n\n# ----- {PurePath(base.name).name} -----\n{base.text}"
    return Tree(over.name, _merge(base.data, over.data, (), places, over.places), places, text, (*over.files, *base.files), over.reach)


def _merge(
    base: dict[str, Value],
    over: dict[str, Value],
    path: Path,
    places: dict[Path, Place],
    new: dict[Path, Place],
) -> dict[str, Value]:
    merged = dict(base)
    for key, value in over.items():
        here = (*path, key)
        if value is None:
            merged.pop(key, None)
        elif isinstance(value, dict) and isinstance(merged.get(key), dict):
            merged[key] = _merge(merged[key], value, here, places, new)
        else:
            merged[key] = value
            places.update({p: place for p, place in new.items() if p[: len(here)] == here})
    return merged


def _kind(data: Value) -> str:
    return "a list" if isinstance(data, list) else "a single value"
