"""Title, author and language of a document, as it is asked for."""

from __future__ import annotations

from ..foundation.slotted import dataclass
from ..foundation.stock import A4, Format
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
    identity: str = ""  # what every page carries at its foot; empty where the pages carry something of their own
    format: Format = A4  # of its pages

    @property
    def words(self) -> tuple[str, ...]:
        """The key words of the file, what its pages carry among them."""
        return (*self.keywords, self.identity) if self.identity else self.keywords
