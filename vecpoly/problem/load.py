"""load(id or path): a problem from the library or from a file."""

from __future__ import annotations

from pathlib import Path

from ..errors import ProblemFileError, UnknownNameError
from ..limits import EXTENDS
from ..words import Words
from .build import build
from .faults import Place, meant
from .library import entries, find
from .problem import Problem
from .reach import Reach, refuse_foreign
from .source import Tree, overlay, parse, read, read_text


def load(where: str | Path, *, allow_outside: bool = False) -> Problem:
    """The problem with this id ('3-9', 'ch3/3-9') or in this file.

    allow_outside: whether the file may name others that are neither in its folder nor in the library.
    Raises ProblemFileError (file, line, YAML path, cause, remedy), UnknownNameError for an unknown id,
    MobilityError where inputs and degrees of freedom disagree.
    """
    if not isinstance(where, (str, Path)):
        raise UnknownNameError(Words(f"题目须以题号或文件名给出，而不是 {type(where).__name__}",
                                     f"a problem is named by its id or its file, not by {type(where).__name__}"), code="no name")
    path = locate(where)
    return build(tree_of(path, reach=Reach(path.parent, allow_outside)), path)


def loads(text: str, name: str = "<text>") -> Problem:
    """The problem in this text, which may build on those of the library."""
    if not isinstance(text, str):
        raise ProblemFileError(Words(f"loads 需要题目文件的文本，而不是 {type(text).__name__}",
                                     f"loads takes the text of a problem file, not {type(text).__name__}"), code="no text")
    return build(_extended(parse(text, name), None, (), Reach()))


def locate(where: str | Path, near: Path | None = None, reach: Reach | None = None) -> Path:
    """The file meant by an id or a path; a path in a file is relative to the folder `near`, and within its reach."""
    text = str(where)
    for path in [near / text] if near else [Path(text)]:
        if path.suffix in (".yaml", ".yml") or path.is_file():
            if reach is not None:
                reach.refuse_outside(path)
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
                "（用 vecpoly list 可列出全部题目，文件名须以 .yaml 结尾）", " ('vecpoly list' shows all, and a path must end in .yaml)"),
            code="unknown-name")
    return found


def tree_of(path: Path, seen: tuple[Path, ...] = (), *, reach: Reach) -> Tree:
    """A file's values, laid on those of the file that it extends."""
    tree = read(path)
    tree.reach = reach
    return _extended(tree, path, seen, reach)


def _extended(tree: Tree, path: Path | None, seen: tuple[Path, ...], reach: Reach) -> Tree:
    base = tree.data.get("extends")
    if base is None:
        return tree
    place = Place(tree.name, tree.places[("extends",)].line)
    if not isinstance(base, str):
        no_name = Words("此处应写题号或题目文件的路径", "the id or path of a problem is expected here")
        raise ProblemFileError(no_name, code="spelling").at(place, "extends")
    try:
        below = locate(base, path.parent if path else None, reach)
        refuse_foreign(read_text(below), below)
    except (ProblemFileError, UnknownNameError) as error:
        raise ProblemFileError(error.words, code=error.code).at(place, "extends") from None
    if below.resolve() in seen or (path and below.resolve() == path.resolve()):
        circle = Words(f"“{base}”循环引用了自身", f"'{base}' extends itself in a circle")
        raise ProblemFileError(circle, code="contradiction").at(place, "extends")
    here = (*seen, path.resolve()) if path else seen
    if len(here) > EXTENDS:
        raise ProblemFileError(Words(f"已有 {EXTENDS} 层，过深", f"more than {EXTENDS} files upon each other"), code="too deep").at(place, "extends")
    return overlay(tree_of(below, here, reach=reach), tree)
