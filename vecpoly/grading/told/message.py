"""One sentence to a student: its name and its parameters; the words stand in one catalogue."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ...words import Words, bare
from .catalogue import SENTENCES
from .named import Told

Parameter = str | Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Message:
    """A sentence by its name, with what is put into it."""

    id: Told
    numbers: Mapping[str, Parameter] = field(default_factory=dict)

    @property
    def words(self) -> Words:
        """The sentence in both languages, symbols between dollar signs."""
        return self.filled(SENTENCES[self.id])

    def filled(self, said: Words) -> Words:
        """A sentence with these parameters."""
        both = {name: value if isinstance(value, Words) else Words.same(value) for name, value in self.numbers.items()}
        zh = said.zh.format(**{name: value.zh for name, value in both.items()})
        return Words(zh, said.en.format(**{name: value.en for name, value in both.items()}))

    def as_json(self) -> dict[str, Any]:
        """Plain data: the name, the parameters, the sentence in both languages."""
        numbers = {name: value if isinstance(value, str) else value.en for name, value in self.numbers.items()}
        return {"id": self.id.value, "numbers": numbers, "zh": bare(self.words.zh), "en": bare(self.words.en)}


def message(name: Told, **numbers: Parameter) -> Message:
    """A sentence with its parameters."""
    return Message(id=name, numbers=numbers)
