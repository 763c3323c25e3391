"""load(id or path): a problem from the library or from a file."""

from __future__ import annotations

from pathlib import Path

from ..errors import ProblemFileError, UnknownNameError
from ..words import Words
from .build import build
from .faults import meant
from .library import entries, find
from .problem import Problem
from .source import Tree, overlay, parse, read_text


def load(where: str | Path) -> Problem:
    """The problem with this id ('3-9', 'ch3/3-9') or in this file.

    Raises ProblemFileError (file, line, YAML path, cause, remedy), UnknownNameError for an unknown id,
    MobilityError where inputs and degrees of freedom disagree.
    """
    path = locate(where)
    return build(tree_of(path), path)


def loads(text: str, name: str = "<text>") -> Problem:
    """The problem in this text."""
    return build(_extended(parse(text, name), None, ()))


def locate(where: str | Path, near: Path | None = None) -> Path:
    """The file meant by an id or a path; a path may be relative to the folder `near`."""
    text = str(where)
    for path in (Path(text), *([near / text] if near else [])):
        if path.suffix in (".yaml", ".yml") or path.is_file():
            if path.is_file():
                return path
            if path.is_dir():
                raise ProblemFileError(Words(
                    f"{path}：是文件夹，不是题目文件",
                    f"{path}: is a folder, not a problem file"))
    if text.endswith((".yaml", ".yml")):
        raise ProblemFileError(Words(f"{text}：没有此文件", f"{text}: no such file"))
    found = find(text)
    if found is None:
        if text and Path(text).is_dir():
            raise ProblemFileError(Words(
                f"{text}：是文件夹，不是题目文件",
                f"{text}: is a folder, not a problem file"))
        raise UnknownNameError(
            Words(f"没有题目“{text}”", f"no problem '{text}'") + meant(text, (entry.id for entry in entries())) + Words(
                "；用 vecpoly list 可列出全部题目，文件名须以 .yaml 结尾", "; 'vecpoly list' shows all, and a path must end in .yaml")
        )
    return found


def tree_of(path: Path, seen: tuple[Path, ...] = ()) -> Tree:
    """A file's values, laid on those of the file that it extends."""
    return _extended(parse(read_text(path), str(path)), path, seen)


def _extended(tree: Tree, path: Path | None, seen: tuple[Path, ...]) -> Tree:
    base = tree.data.get("extends")
    if base is None:
        return tree
    line = tree.places[("extends",)].line
    if not isinstance(base, str):
        raise ProblemFileError(Words(
            f"{tree.name} 第 {line} 行：extends：此处应写题号或题目文件的路径",
            f"{tree.name}, line {line}: extends: the id or path of a problem is expected here"))
    try:
        below = locate(base, path.parent if path else None)
    except (ProblemFileError, UnknownNameError) as error:
        raise ProblemFileError(Words(f"{tree.name} 第 {line} 行：extends：", f"{tree.name}, line {line}: extends: ") + error.words) from None
    if below.resolve() in seen or (path and below.resolve() == path.resolve()):
        raise ProblemFileError(Words(
            f"{tree.name} 第 {line} 行：extends：“{base}”循环引用了自身",
            f"{tree.name}, line {line}: extends: '{base}' extends itself in a circle"))
    here = (*seen, path.resolve()) if path else seen
    return overlay(tree_of(below, here), tree)
