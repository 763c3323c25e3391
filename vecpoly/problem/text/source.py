"""A YAML file as plain text values, each with its place: line numbers for every error."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any

from ... import limits
from ...errors import FaultError, ProblemFileError
from ...foundation.running.system import of_system
from ...units.comma import refuse_comma
from ...words import Words
from ..reach import Reach
from ..schema.faults import Path, Place
from .characters import refuse_unwanted
from .commas import braced, cut_short, is_braced, parted, torn
from .narrow import Narrowed, narrowed
from .nodes import composed, refused

PROSE = frozenset({"statement", "explain", "source", "errata", "note"})  # below these keys people write sentences
_SHORT = 50_000  # signs; a problem file has a few thousand

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
        _not_too_large(path.stat().st_size, str(path))
        return decoded(path.read_bytes(), str(path))
    except OSError as error:
        raise ProblemFileError(
            Words(f"{path}：不能读取：", f"{path}: cannot be read: ") + of_system(error), code="file"
        ) from None


def decoded(data: bytes, name: str) -> str:
    """The text of these bytes, UTF-8 with or without a byte order mark;
    raises ProblemFileError for other bytes, or too many."""
    _not_too_large(len(data), name)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise ProblemFileError(
            Words(
                f"{name} 第 {line} 行：第 {error.start} 字节（0x{error.object[error.start]:02x}）"
                "不是 UTF-8 编码；请将文件另存为 UTF-8",
                f"{name}, line {line}: byte {error.start} (0x{error.object[error.start]:02x}) is not UTF-8; "
                "save the file with the encoding UTF-8",
            )
        ) from None


def _not_too_large(size: int, name: str) -> None:
    if size > limits.FILE:
        raise ProblemFileError(
            Words(
                f"{name}：{size / 1e6:.1f} MB 不会是题目文件；上限为 {limits.FILE / 1e6:.0f} MB",
                f"{name}: {size / 1e6:.1f} MB is no problem file; the limit is {limits.FILE / 1e6:.0f} MB",
            )
        )


def read(path: FilePath) -> Tree:
    """The values of a file."""
    tree = parse(read_text(path), str(path))
    tree.files = (path,)
    return tree


def parse(text: str, name: str) -> Tree:
    """Text to values with places. Raises ProblemFileError for anything that is no plain YAML mapping."""
    tree = _kept(text, name) if len(text) < _SHORT else _parsed(text, name)
    return Tree(name, _copied(tree.data), dict(tree.places), text)


@lru_cache(maxsize=256)
def _kept(text: str, name: str) -> Tree:
    """What a text says does not change: `extends`, assignments and a second look need not read it again."""
    return _parsed(text, name)


def _parsed(text: str, name: str) -> Tree:
    refuse_unwanted(text, name)
    plain = narrowed(text, name)
    node = composed(plain, name)
    tree = Tree(name, {}, text=text)
    data = None if node is None else _Reader(tree, plain).value(node, ())
    if data is None:
        raise refused(
            Place(name, 1),
            Words(
                "文件是空的；题目文件可用 vecpoly new 写出样板",
                "the file is empty; 'vecpoly new' writes a problem file to start from",
            ),
        )
    if not isinstance(data, dict):
        kind = Words("一个列表", "a list") if isinstance(data, list) else Words("单个值", "a single value")
        raise refused(
            Place(name, 1),
            Words(
                f"文件应为映射（键: 值），而不是{kind.zh}", f"the file must be a mapping (key: value), not {kind.en}"
            ),
        )
    tree.data = data
    return tree


def _copied(value: Value) -> Value:
    """The same values in mappings and lists of their own, which may be changed."""
    match value:
        case dict():
            return {key: _copied(item) for key, item in value.items()}
        case list():
            return [_copied(item) for item in value]
        case _:
            return value


class _Reader:
    """Walks the nodes once; refuses aliases, duplicate keys and depth."""

    def __init__(self, tree: Tree, plain: Narrowed) -> None:
        self.tree, self.plain, self.seen = tree, plain, set[int]()

    def place(self, mark: Any) -> Place:
        """The place of a mark in the text as written."""
        return Place(self.tree.name, mark.line + 1, self.plain.column(mark.line, mark.column) + 1)

    def value(self, node: Any, path: Path) -> Value:
        place = self.place(node.start_mark)
        self.tree.places.setdefault(path, place)
        if id(node) in self.seen or len(path) > limits.DEPTH:
            raise refused(
                place,
                Words(
                    "不支持 YAML 别名，也不能嵌套过深；请直接写出值",
                    "no YAML aliases or deep nesting here; write the value out",
                ),
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
                empty = not node.style and node.value in ("", "~", "null")
                return (
                    None
                    if empty
                    else self.scalar(
                        str(node.value), place, limits.PROSE if PROSE.intersection(map(str, path)) else limits.SCALAR
                    )
                )

    def scalar(self, text: str, place: Place, most: int) -> str:
        """A text that is not too long, and holds no sign that escapes (`"\\e"`) have brought in."""
        if len(text) > most:
            raise refused(
                place,
                Words(
                    f"此处有 {len(text)} 个字符，最多 {most} 个；请缩短",
                    f"{len(text)} characters where at most {most} are possible; shorten the text",
                ),
                "too-long",
            )
        refuse_unwanted(text, place.file, place.line, place.column or 1)
        return text

    def counted(self, node: Any, place: Place) -> None:
        """A list or mapping of not too many entries."""
        if len(node.value) > limits.ENTRIES:
            raise refused(
                place,
                Words(
                    f"此处有 {len(node.value)} 项，最多 {limits.ENTRIES} 项",
                    f"{len(node.value)} entries where at most {limits.ENTRIES} are possible",
                ),
                "too-many",
            )

    def mapping(self, node: Any, path: Path) -> dict[str, Value]:
        data: dict[str, Value] = {}
        if is_braced(node):
            raise refused(self.place(node.start_mark), braced([key.value for key, _ in node.value]), "spelling")
        for (key, item), (_, before) in zip(node.value, [(None, None), *node.value], strict=False):
            place = self.place(key.start_mark)
            if before is not None and (number := parted(before, key)):
                self._no_comma(number, self.place(before.start_mark))
            self._check_key(key, place, data, path)
            self.tree.places[(*path, key.value)] = place
            data[key.value] = self.value(item, (*path, key.value))
        return data

    def _no_comma(self, number: str, place: Place) -> None:
        try:
            refuse_comma(number)
        except FaultError as error:
            raise refused(place, error.words, error.code) from None

    def _check_key(self, key: Any, place: Place, data: dict[str, Value], path: Path) -> None:
        if key.id != "scalar":
            raise refused(place, Words("键应为一个词", "a key must be a plain word"))
        self.scalar(key.value, place, limits.SCALAR)
        if cut_short(key.value):
            raise refused(place, torn(key.value))
        if ":" in key.value:
            zh, en = f"“{key.value}”：冒号后要写空格和值", f"'{key.value}': write a space and a value after the ':'"
            raise refused(place, Words(zh, en))
        if key.value in data:
            first = self.tree.places[(*path, key.value)].line
            zh = f"键“{key.value}”重复（首次在第 {first} 行）"
            en = f"key '{key.value}' occurs twice (first in line {first})"
            raise refused(place, Words(zh, en), "duplicate-key")
