"""What books write otherwise, as the rest of the program calls it: n of an input is its omega, the fixed pivot O1 the
one letter O₁, and a joint said in Chinese one in English."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...errors import FaultError
from ...foundation.indices import BELOW, DIGITS, ON_LINE
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...words import Words
from ..schema.faults import Faults, Path
from .chinese import joint, motion
from .source import PROSE, Tree, Value

_INDEXED = pattern(rf"([A-Z])_?([0-9{DIGITS}])")
_SPEED = pattern(r"n(_\d+)?")
_AS_WRITTEN = PROSE | {"id", "title", "extends", "tables", "problems", "title_block"}  # sentences, names of files


def respelled(tree: Tree, base: Tree | None = None) -> Tree:
    """The tree with these letters and keys; base: what it will be laid on, whose letters it uses too.

    Raises ProblemFileError where n and omega both stand, or a letter of the frame stands with its index and without.
    """
    letters = _indexed(base) | _indexed(tree)
    speeds = {(*path, key): f"omega{key[1:]}" for path, turning in _turning(tree) for key in _speeds(turning)}
    faults = Faults(tree.name, tree.places)
    for path, key in speeds.items():
        with faults.at(*path):
            _refuse_twice(key, next(turning for at, turning in _turning(tree) if at == path[:-1]))
    _refuse_bare(letters, tree, faults)
    faults.settle()
    speller = _Speller(letters, speeds)
    places = {speller.path(path): place for path, place in tree.places.items()}
    return replace(tree, data=speller.value(tree.data, ()), places=places)


def _indexed(tree: Tree | None) -> dict[str, str]:
    """The letters of the frame that have an index, each as one letter, O₁, with how it is written there."""
    frame = tree.data.get("frame") if tree is not None else None
    found = [(key, _INDEXED.fullmatch(key)) for key in frame] if isinstance(frame, dict) else []
    return {m[1] + m[2].translate(BELOW): key for key, m in found if m}


def _turning(tree: Tree) -> Iterator[tuple[Path, dict[str, Value]]]:
    """The mappings in which n is an angular velocity, with their paths."""
    inputs = tree.data.get("input")
    listed = enumerate(inputs) if isinstance(inputs, list) else ()
    for path, one in (
        (("input",), inputs),
        *((("input", i), one) for i, one in listed),
        (("vary",), tree.data.get("vary")),
    ):
        if isinstance(one, dict):
            yield path, one


def _speeds(turning: dict[str, Value]) -> Iterator[str]:
    return (key for key in turning if _SPEED.fullmatch(key))


def _refuse_twice(key: str, turning: dict[str, Value]) -> None:
    if key in turning:
        n = key.replace("omega", "n")
        raise FaultError(
            Words(f"{n} 与 {key} 是同一个量；请删去其一", f"{n} and {key} are one quantity; leave out one of them"),
            code="contradiction",
        )


def _refuse_bare(letters: dict[str, str], tree: Tree, faults: Faults) -> None:
    """B₁ beside a plain B is doubtful: v_B1 would be the velocity of B as a point of link 1."""
    bars = " ".join(key for part in ("frame", "links") for key in _keys(tree.data.get(part)))
    for letter, key in letters.items():
        bare, digit = letter[0], letter[1].translate(ON_LINE)
        if re.search(rf"{bare}(?!_?[0-9{DIGITS}])", bars):
            fault = Words(
                f"另有点 {bare}，{bare}{digit} 会被读作构件 {digit} 上的 {bare} 点；请给其中一点另取字母",
                f"there is a point {bare} too, and {bare}{digit} is read as point {bare} of link {digit}; "
                "call one of them by another letter",
            )
            faults.note(FaultError(fault, "frame", key, code="contradiction"))


def _keys(value: Value) -> Iterator[str]:
    """The keys of a mapping and of those in it: letters and bars."""
    for key, item in value.items() if isinstance(value, dict) else ():
        yield key
        yield from _keys(item)


class _Speller:
    """Writes letters, keys and sentences of joints anew, wherever they stand but in prose."""

    def __init__(self, letters: Iterable[str], speeds: dict[Path, str]) -> None:
        self.speeds = speeds
        self.plain = {letter.translate(ON_LINE): letter for letter in letters}
        names = "|".join(rf"{name[0]}_?{name[1]}|{it[0]}_?{it[1]}" for name, it in self.plain.items())
        self.found = re.compile(names) if names else None

    def value(self, value: Value, path: Path) -> Value:
        """A value at this path of the file."""
        match value:
            case dict():
                return {self.key((*path, key)): self.value(item, (*path, key)) for key, item in value.items()}
            case list():
                return [self.value(item, (*path, i)) for i, item in enumerate(value)]
            case str() if path[0] == "joints":
                return self.text(joint(value))
            case str() if "motion" in path:
                return motion(value)
            case str() if path[0] not in _AS_WRITTEN:
                return self.text(value)
        return value

    def path(self, path: Path) -> Path:
        """A path of the file with its keys as they are written anew."""
        return tuple(self.key(path[: i + 1]) if isinstance(key, str) else key for i, key in enumerate(path))

    def key(self, path: Path) -> str:
        """The last key of a path."""
        return self.speeds.get(path) or (str(path[-1]) if path[0] in _AS_WRITTEN else self.text(str(path[-1])))

    def text(self, text: str) -> str:
        """A text with its letters."""
        if self.found is None:
            return text
        return self.found.sub(lambda m: self.plain[m[0].replace("_", "").translate(ON_LINE)], text)
