"""What books write otherwise, as the rest of the program calls it: n of an input is its omega, η what is asked as eta,
the fixed pivot O1 the one letter O₁, and a joint said in Chinese one in English."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...errors import FaultError
from ...foundation.indices import BELOW, DIGITS, ON_LINE
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...words import Words
from ..schema.faults import Faults, Path
from .chinese import joint, motion, side
from .source import PROSE, Tree, Value

_INDEXED = pattern(rf"([A-Z])_?([0-9{DIGITS}])")
_AS_WRITTEN = PROSE | {"id", "title", "extends", "tables", "problems", "title_block"}  # sentences, names of files
_MOTION = {"n": "omega", "ω": "omega", "φ": "phi", "α": "alpha"}
OTHER_KEYS = {  # of a part of the file, for editors too
    "input": _MOTION,
    "vary": _MOTION,
    "masses": {"m": "mass", "J": "inertia", "J_S": "inertia", "S": "centre"},
    "friction": {"φ": "phi", "ρ": "rho"},
}
_ASKED = str.maketrans(
    {"η": "eta", "ρ": "rho", "δ": "delta", "λ": "lambda", "φ": "phi", "ψ": "psi", "θ": "theta", "Δ": "d"}
)


def respelled(tree: Tree, base: Tree | None = None) -> Tree:
    """The tree with these letters and keys; base: what it will be laid on, whose letters it uses too.

    Raises ProblemFileError where n and omega both stand, or a letter of the frame stands with its index and without.
    """
    letters = _indexed(base) | _indexed(tree)
    faults = Faults(tree.name, tree.places)
    for key, letter in _indices(tree):
        _refuse_twice(("frame", key), letters[letter], faults)
    renamed = dict(_renamed(tree, base, faults))
    _refuse_bare(letters, tree, faults)
    faults.settle()
    speller = _Speller(letters, renamed)
    places = {speller.path(path): place for path, place in tree.places.items()}
    return replace(tree, data=speller.value(tree.data, ()), places=places)


def _renamed(tree: Tree, base: Tree | None, faults: Faults) -> Iterator[tuple[Path, str]]:
    """The keys that have another name here, by their paths."""
    whole = {**(base.data if base is not None else {}), **tree.data}
    for part, own in OTHER_KEYS.items():
        names = {**own, **_of_drives(whole.get("input"))} if part == "vary" else own
        speeds = part != "vary" or ("input" in whole and "machine" not in whole)  # n of a device, a machine, is its own
        for path, mapping in _mappings(tree.data.get(part), (part,)):
            taken = dict(zip(mapping, mapping, strict=True))
            for key in mapping:
                if key in names and (speeds or key != "n"):
                    yield (*path, key), names[key]
                    _refuse_twice((*path, key), taken.setdefault(names[key], key), faults)


def _of_drives(inputs: Value) -> dict[str, str]:
    """Of several drives each has its own: n_4 is omega_4."""
    links = [one.get("link") for one in inputs if isinstance(one, dict)] if isinstance(inputs, list) else []
    return {f"{name}_{link}": f"{key}_{link}" for link in links for name, key in _MOTION.items()}


def _mappings(value: Value, path: Path) -> Iterator[tuple[Path, dict[str, Value]]]:
    """All mappings at and below a path."""
    if isinstance(value, dict):
        yield path, value
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in inner:
        yield from _mappings(item, (*path, key))


def _refuse_twice(path: Path, other: str, faults: Faults) -> None:
    """Note a key that says what another one says: n beside omega, O_1 beside O1."""
    if (key := path[-1]) != other:
        twice = Words(
            f"{key} 与 {other} 是同一个；请删去其一", f"{key} and {other} are one and the same; leave out one"
        )
        faults.note(FaultError(twice, *path, code="contradiction"))


def _indexed(tree: Tree | None) -> dict[str, str]:
    """The letters of the frame that have an index, each as one letter, O₁, with how it is written there."""
    return {letter: key for key, letter in (_indices(tree) if tree is not None else ())}


def _indices(tree: Tree) -> Iterator[tuple[str, str]]:
    frame = tree.data.get("frame")
    for key in frame if isinstance(frame, dict) else ():
        if found := _INDEXED.fullmatch(key):
            yield key, found[1] + found[2].translate(BELOW)


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

    def __init__(self, letters: Iterable[str], renamed: dict[Path, str]) -> None:
        self.renamed = renamed
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
            case str() if path[-1] == "side":
                return self.text(side(value))
            case str() if "motion" in path:
                return motion(value)
            case str() if path[0] == "find" or path[-1] == "symbol":
                return self.text(value.translate(_ASKED))
            case str() if path[0] not in _AS_WRITTEN:
                return self.text(value)
        return value

    def path(self, path: Path) -> Path:
        """A path of the file with its keys as they are written anew."""
        return tuple(self.key(path[: i + 1]) if isinstance(key, str) else key for i, key in enumerate(path))

    def key(self, path: Path) -> str:
        """The last key of a path."""
        return self.renamed.get(path) or (str(path[-1]) if path[0] in _AS_WRITTEN else self.text(str(path[-1])))

    def text(self, text: str) -> str:
        """A text with its letters."""
        if self.found is None:
            return text
        return self.found.sub(lambda m: self.plain[m[0].replace("_", "").translate(ON_LINE)], text)
