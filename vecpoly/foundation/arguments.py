"""What a caller hands in, checked at the door: a language, a whole number, a kind of object."""

from __future__ import annotations

from typing import TypeVar

from ..errors import ArgumentError
from ..words import Words

T = TypeVar("T")
LANGS = ("zh", "en")


def known_language(lang: object) -> None:
    """Raise ArgumentError for a language that nothing is written in."""
    if lang not in LANGS:
        raise ArgumentError(
            Words(
                f"没有语言 {lang!r}；可用 'zh'（中文）与 'en'（英文）",
                f"there is no language {lang!r}; 'zh' (Chinese) and 'en' (English) are known",
            ),
            code="lang",
        )


def whole_number(name: str, value: object, least: int, most: int) -> None:
    """Raise ArgumentError for what is no whole number within these bounds."""
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise ArgumentError(
            Words(
                f"{name} = {value!r}：应为 {least} 至 {most} 的整数",
                f"{name} = {value!r} must be a whole number from {least} to {most}",
            ),
            code=name,
        )


def of_kind(value: object, kind: type[T] | tuple[type[T], ...], what: Words) -> T:
    """The value as one of this kind; raises ArgumentError for any other."""
    if isinstance(value, kind):
        return value
    got = type(value).__name__
    raise ArgumentError(Words(f"这里需要{what.zh}，而不是 {got}", f"{what.en} is needed here, not {got}"), code="kind")
