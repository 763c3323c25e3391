"""The nodes of a YAML text: by libyaml, which is quick, or by ruamel, which says what is wrong and where."""

from __future__ import annotations

from typing import Any

from ...errors import Fault, Place, ProblemFileError
from ...foundation.patterns import pattern
from ...words import Words
from .misread import misread
from .narrow import Narrowed

_SHORT = 50_000  # signs; a problem file has a few thousand
_NESTING = pattern(r"[\[{]|[-?:] ")  # what opens another level, in a line
_NESTED = 2_000


def refused(place: Place, words: Words, code: str = "yaml") -> ProblemFileError:
    """A text that is no plain YAML, with the place of the mistake."""
    return ProblemFileError.of(Fault(said=words, code=code, place=place))


def composed(plain: Narrowed, name: str) -> Any:
    """The nodes of the text: by libyaml, and what that refuses by ruamel.

    Raises ProblemFileError for what is no YAML.
    """
    return _quickly(plain.text) or _carefully(plain, name)


def _quickly(text: str) -> Any:
    """The nodes by libyaml, in a twentieth of the time; None where it refuses, and for what it is not trusted with:
    tabs and tags, which it lets pass, and nesting, of which it keeps count on the stack."""
    import yaml

    doubtful = "\t" in text or "!" in text or len(text) > _SHORT or len(_NESTING.findall(text)) > _NESTED
    if doubtful or not yaml.__with_libyaml__:
        return None
    try:
        return yaml.compose(text, Loader=yaml.CBaseLoader)
    except yaml.YAMLError:
        return None


def _carefully(plain: Narrowed, name: str) -> Any:
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError, YAMLError

    try:
        return YAML(typ="safe", pure=True).compose(plain.text)
    except MarkedYAMLError as error:
        found = misread(error, plain.text)
        place = Place(name, found.line + 1, plain.column(found.line, found.column) + 1)
        raise refused(place, found.words) from None
    except RecursionError:
        deep = Words("嵌套过深；题目文件只有四层", "nested too deeply; a problem file has four levels")
        raise refused(Place(name), deep) from None
    except (YAMLError, ValueError) as error:
        said = str(error).splitlines()[0]
        raise refused(Place(name), Words(f"不是有效的 YAML（{said}）", f"no valid YAML: {said}")) from None
