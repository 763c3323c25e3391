"""What an assignment, or a file of its own, says of marking, with the line of every word."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass
from .schema.faults import Faults, Path, Place
from .schema.marking import KEYS, MarkingSpec
from .schema.validate import validate
from .text.source import Tree


@dataclass(frozen=True, slots=True, kw_only=True)
class Marking:
    """said: rules, rubric, points, totals as they were written; file, places: where they stand."""

    said: MarkingSpec = field(default_factory=MarkingSpec)
    file: str = ""
    places: Mapping[Path, Place] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "places", FrozenMap(dict(self.places)))

    @property
    def faults(self) -> Faults:
        """A list of what is wrong with it, which knows its lines."""
        return Faults(self.file, self.places)


NOTHING_SAID = Marking()


def marking_of(tree: Tree) -> Marking:
    """The marking in a file that holds nothing else. Raises ProblemFileError with every fault."""
    said = validate(MarkingSpec, tree.data, Faults(tree.name, tree.places))
    return Marking(said=said, file=tree.name, places=_here(tree))


def marking_in(tree: Tree, said: MarkingSpec) -> Marking:
    """The marking in an assignment, which says other things too."""
    alone = MarkingSpec.model_validate({key: getattr(said, key) for key in said.model_fields_set & set(KEYS)})
    return Marking(said=alone, file=tree.name, places=_here(tree))


def _here(tree: Tree) -> Mapping[Path, Place]:
    return {path: place for path, place in tree.places.items() if path and path[0] in KEYS}
