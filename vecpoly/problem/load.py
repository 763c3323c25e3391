"""load(id or path): a problem from the library or from a file."""

from __future__ import annotations

from pathlib import Path

from ..errors import ProblemFileError, UnknownNameError
from ..foundation.patterns import pattern
from ..limits import EXTENDS
from ..words import Words
from .build import build
from .library import entries, find
from .loads.laws.cards import with_cards
from .problem import Problem
from .reach import Reach, Resolver, refuse_foreign
from .schema.faults import Place, meant
from .text.overlay import overlay
from .text.source import Tree, Value, decoded, parse, read, read_text

PROFILE = pattern(r"profile of (?P<file>\S.*?) about (?P<about>\S+)")
Seen = tuple[Path | str, ...]  # files, and names that a resolver has


def load(where: str | Path, *, allow_outside: bool = False, resolver: Resolver | None = None) -> Problem:
    """The problem with this id ('3-9', 'ch3/3-9') or in this file.

    allow_outside: whether the file may name others that are neither in its folder nor in the library. resolver: asked
    first for this
    name and for all that the problem names (`extends`, `tables`): the text that stands under it, in an editor say;
    None: look for a file.
    Raises ProblemFileError (file, line, YAML path, cause, remedy), UnknownNameError for an unknown id,
    MobilityError where inputs and degrees of freedom disagree.
    """
    if not isinstance(where, (str, Path)):
        raise UnknownNameError(
            Words(
                f"题目须以题号或文件名给出，而不是 {type(where).__name__}",
                f"a problem is named by its id or its file, not by {type(where).__name__}",
            ),
            code="no name",
        )
    held = Reach(None, allow_outside, resolver)
    if (tree := held_tree(str(where), (), held)) is not None:
        return build(tree)
    path = locate(where)
    return build(tree_of(path, reach=Reach(path.parent, allow_outside, resolver)), path)


def loads(text: str, name: str = "<text>", *, resolver: Resolver | None = None) -> Problem:
    """The problem in this text, which may build on those of the library, and on what the resolver has (see `load`)."""
    if not isinstance(text, str):
        raise ProblemFileError(
            Words(
                f"loads 需要题目文件的文本，而不是 {type(text).__name__}",
                f"loads takes the text of a problem file, not {type(text).__name__}",
            ),
            code="no text",
        )
    return build(reaching(parse(text, name), (), Reach(resolver=resolver)))


def opened(name: str, near: Path | None, reach: Reach, seen: Seen = ()) -> tuple[Tree, Path | None]:
    """What is named in a file: the resolver's text, or the file of this id or path and where it is."""
    if (tree := held_tree(name, seen, reach)) is not None:
        return tree, None
    path = locate(name, near, reach)
    refuse_foreign(read_text(path), path)
    return tree_of(path, seen, reach=reach), path


def held_tree(name: str, seen: Seen, reach: Reach) -> Tree | None:
    """The values of what the resolver has under this name, laid on what it extends; None where it has nothing."""
    data = reach.held(name)
    if data is None:
        return None
    return reaching(parse(decoded(data, name), name), (*seen, name), reach)


def reaching(tree: Tree, seen: Seen, reach: Reach) -> Tree:
    """The tree of a text on what it extends, within this reach."""
    tree.reach = reach
    return with_cards(_profiled(_extended(tree, None, seen, reach), None, seen))


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
                raise ProblemFileError(
                    Words(f"{path}：是文件夹，不是题目文件", f"{path}: is a folder, not a problem file")
                )
    if text.endswith((".yaml", ".yml")):
        raise ProblemFileError(Words(f"{text}：没有此文件", f"{text}: no such file"))
    found = find(text)
    if found is None:
        if text and Path(text).is_dir():
            raise ProblemFileError(Words(f"{text}：是文件夹，不是题目文件", f"{text}: is a folder, not a problem file"))
        raise UnknownNameError(
            Words(f"没有题目“{text}”", f"no problem '{text}'")
            + meant(text, (entry.id for entry in entries()))
            + Words(
                "（用 vecpoly list 可列出全部题目，文件名须以 .yaml 结尾）",
                " ('vecpoly list' shows all, and a path must end in .yaml)",
            ),
            code="unknown-name",
        )
    return found


def tree_of(path: Path, seen: Seen = (), *, reach: Reach) -> Tree:
    """A file's values, laid on those of the file that it extends."""
    tree = read(path)
    tree.reach = reach
    seen = (*seen, path.resolve())
    return with_cards(_profiled(_extended(tree, path, seen, reach), path, seen))


def _extended(tree: Tree, path: Path | None, seen: Seen, reach: Reach) -> Tree:
    """The tree on what it extends; `seen`: the files upon each other so far, its own the last."""
    base = tree.data.get("extends")
    if base is None:
        return tree
    place = Place(tree.name, tree.places[("extends",)].line) if ("extends",) in tree.places else Place(tree.name)
    if not isinstance(base, str):
        no_name = Words("此处应写题号或题目文件的路径", "the id or path of a problem is expected here")
        raise ProblemFileError(no_name, code="spelling").at(place, "extends")
    if len(seen) > EXTENDS:
        raise ProblemFileError(
            Words(f"已有 {EXTENDS} 层，过深", f"more than {EXTENDS} files upon each other"), code="too deep"
        ).at(place, "extends")
    return overlay(_below(base, path, seen, reach, place), tree)


def _below(base: str, path: Path | None, seen: Seen, reach: Reach, place: Place) -> Tree:
    """What a file extends; raises ProblemFileError at this place where it is not there, or is above it already."""
    try:
        found = _stands_at(base, path, reach)
        if isinstance(found, Path):
            refuse_foreign(read_text(found), found)
    except (ProblemFileError, UnknownNameError) as error:
        raise ProblemFileError(error.words, code=error.code).at(place, "extends") from None
    if (found.resolve() if isinstance(found, Path) else found) in seen:
        circle = Words(f"“{base}”循环引用了自身", f"'{base}' extends itself in a circle")
        raise ProblemFileError(circle, code="contradiction").at(place, "extends")
    return opened(base, path.parent if path else None, reach, seen)[0]


def _profiled(tree: Tree, path: Path | None, seen: Seen) -> Tree:
    """The tree with the data of the cams that its links name (`cam: profile of FILE about O`) in their places."""
    links = tree.data.get("links")
    for name, link in links.items() if isinstance(links, dict) else ():
        named = PROFILE.fullmatch(link["cam"]) if isinstance(link, dict) and isinstance(link.get("cam"), str) else None
        if named is not None:
            place = tree.places.get(("links", name, "cam"), Place(tree.name))
            link["cam"] = {"about": named["about"], "profile of": named["file"]} | _cam_at(
                named["file"], place, path, tree.reach, seen
            )
    return tree


def _cam_at(name: str, place: Place, path: Path | None, reach: Reach, seen: Seen) -> dict[str, Value]:
    """The data of a cam problem; raises ProblemFileError at this place where there is none."""
    near = None if path is None else Path(place.file).parent
    try:
        if len(seen) > EXTENDS:
            raise ProblemFileError(
                Words(f"已有 {EXTENDS} 层，过深", f"more than {EXTENDS} files upon each other"), code="too deep"
            )
        data = opened(name, near, reach, seen)[0].data
    except (ProblemFileError, UnknownNameError) as error:
        raise ProblemFileError(error.words, code=error.code).at(place, "cam") from None
    if data.get("device") != "cam" or not isinstance(data.get("data"), dict):
        raise ProblemFileError(
            Words(
                f"“{name}”不是凸轮题，没有廓线；请写 device: cam 的题目，如 cam-roller-offset",
                f"'{name}' is no cam and has no profile; name a problem with device: cam, such as cam-roller-offset",
            ),
            code="no-profile",
        ).at(place, "cam")
    return dict(data["data"])


def _stands_at(base: str, path: Path | None, reach: Reach) -> Path | str:
    """The file of this name, or the name itself where the resolver has it."""
    return base if reach.held(base) is not None else locate(base, path.parent if path else None, reach)
