"""Title, author and language of a document, as it is asked for."""

from __future__ import annotations

from dataclasses import dataclass

from ..words import Lang


@dataclass(frozen=True, slots=True, kw_only=True)
class Metadata:
    """What the file says about itself."""

    title: str
    author: str = ""
    subject: str = ""
    keywords: tuple[str, ...] = ()
    creator: str = "vecpoly"
    lang: Lang = "zh"
