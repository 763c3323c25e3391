"""A problem, or a mechanism, made in Python: the data of a problem file as a dictionary, through the same checks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ... import limits
from ...errors import ArgumentError
from ...foundation.arguments import of_kind
from ...mechanism.model import Mechanism
from ...words import Words
from ..build import build
from ..load import reaching
from ..problem import Problem
from ..reach import Reach, Resolver
from ..text.characters import refuse_unwanted
from ..text.numbers import as_pair, as_text, is_number
from ..text.source import PROSE, Tree, Value
from .parameters import slots
from .written import text_of

Data = Mapping[Any, Any]
_LETTERS, _ENTRIES = Words("个字符", "characters"), Words("项", "entries")


def problem(data: Data, *, name: str = "<data>", resolver: Resolver | None = None) -> Problem:
    """The problem that these data say: keys as in a problem file, values with units, or numbers in SI.

    A point of the frame may be x + iy (m). resolver: as in `load`. Raises ProblemFileError with every fault,
    ArgumentError for values of a kind that no problem file has.
    """
    of_kind(data, Mapping, Words("题目数据（字典）", "a dictionary with the data of a problem"))
    tree = Tree(name, _texts(data, name))
    tree.text = text_of(tree.data)
    return build(reaching(tree, (), Reach(resolver=resolver)))


def build_mechanism(
    *,
    frame: Data,
    links: Data,
    input: Any,
    joints: Sequence[str] = (),
    branch: Sequence[str] = (),
    guesses: Data | None = None,
    pins: Data | None = None,
) -> Mechanism:
    """A mechanism from its frame, links, joints, input, branches, each as in a problem file, through the same checks.

    Raises ProblemFileError with every fault; MobilityError where inputs and degrees of freedom disagree.
    """
    data = {
        "id": "mechanism",
        "title": "mechanism",
        "frame": frame,
        "links": links,
        "input": input,
        "joints": joints,
        "branch": branch,
        "guesses": guesses or {},
        "pins": pins or {},
        "find": [],
    }
    return problem(
        {
            key: value
            for key, value in data.items()
            if value or key not in ("joints", "branch", "guesses", "pins", "find")
        }
    ).mechanism


def _texts(data: Data, name: str) -> dict[str, Value]:
    """The data as a file holds them: every value a text."""
    plain: dict[str, Value] = _plain(data, name, ())
    for slot in list(slots(plain)):
        *above, last = slot.path
        holder: Any = plain
        for step in above:
            holder = holder[step]
        if slot.pair:
            holder[last] = as_pair(str(last), holder[last])
        elif is_number(holder[last]):
            holder[last] = as_text(str(last), holder[last], slot.dim)
    said: dict[str, Value] = _said(plain)
    return said


def _plain(value: Any, name: str, path: tuple[str, ...]) -> Any:
    """Mappings, lists, texts and numbers; raises ArgumentError for anything else, and for what is too long."""
    if len(path) > limits.DEPTH:
        raise ArgumentError(
            Words("嵌套过深；题目只有四层", "nested too deeply; a problem has four levels"), code="too deep"
        )
    match value:
        case str():
            _counted(len(value), limits.PROSE if PROSE.intersection(path) else limits.SCALAR, path, _LETTERS)
            refuse_unwanted(value, name)
            return value
        case bool():
            return "yes" if value else "no"
        case Words():
            return {"zh": value.zh, "en": value.en}
        case Mapping():
            _counted(len(value), limits.ENTRIES, path, _ENTRIES)
            _counted(max((len(str(key)) for key in value), default=0), limits.SCALAR, path, _LETTERS)
            return {str(key): _plain(item, name, (*path, str(key))) for key, item in value.items()}
        case list() | tuple():
            _counted(len(value), limits.ENTRIES, path, _ENTRIES)
            return [_plain(item, name, (*path, str(at))) for at, item in enumerate(value)]
        case _ if value is None or is_number(value) or isinstance(value, complex):
            return value
    raise ArgumentError(
        Words(
            f"题目数据中不能有 {type(value).__name__}：应为文本、数、列表或字典",
            f"the data of a problem hold texts, numbers, lists and dictionaries, not {type(value).__name__}",
        ),
        code="kind",
    )


def _counted(count: int, most: int, path: tuple[str, ...], what: Words) -> None:
    """Raise ArgumentError for more than a problem file may hold there."""
    if count > most:
        at = ".".join(path)
        raise ArgumentError(
            Words(
                f"{at}：有 {count} {what.zh}，最多 {most} {what.zh[0]}",
                f"{at}: {count} {what.en} where at most {most} are possible",
            ),
            code="too-long",
        )


def _said(value: Any) -> Any:
    """What numbers are left, as they are: link 1, f = 0.1."""
    match value:
        case dict():
            return {key: _said(item) for key, item in value.items()}
        case list():
            return [_said(item) for item in value]
        case _ if value is None or isinstance(value, str):
            return value
    return str(value)
