"""A project file read and solved, part after part: each may name what those before it gave."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import FaultError
from ..foundation.frozen import FrozenMap
from ..problem.assignment import block_of
from ..problem.load import locate
from ..problem.reach import Reach
from ..problem.schema.faults import Faults
from ..problem.schema.validate import validate
from ..problem.text.source import Tree
from ..problem.text.source import read as parsed
from ..words import Words
from .demand import Demand, judged
from .made import made
from .measured import known
from .part import Part
from .spec import ProjectSpec, SchemeSpec

Tell = Callable[[Words], None]


@dataclass(frozen=True, kw_only=True)
class Project:
    """A design project, solved; `block` has the keys of an assignment's title block."""

    id: str
    title: Words
    statement: Words
    source: Words | None
    schemes: tuple[SchemeSpec, ...]
    parts: tuple[Part, ...]
    demands: tuple[Demand, ...]
    path: Path
    text: str
    block: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "block", FrozenMap(dict(self.block)))

    @property
    def warnings(self) -> tuple[Words, ...]:
        """What must not be taken for right in its drawings."""
        said = ((one.problem.title, one.solution.construction.warning) for one in self.parts)
        return tuple(title + Words("：", ": ") + warning for title, warning in said if warning is not None)


def load_project(
    where: str | Path, *, by: str = "drafting", seed: int = 0, allow_outside: bool = False, tell: Tell | None = None
) -> Project:
    """The project in this file, solved by this hand. Raises ProblemFileError with every fault of the first part that
    has any; what `solve` raises of a part that cannot be drawn. tell: hears the title of each part before it is drawn.
    """
    path = locate(where)
    tree = parsed(path)
    tree.reach = Reach(path.parent, allow_outside)
    faults = Faults(tree.name, tree.places)
    spec = validate(ProjectSpec, tree.data, faults)
    name = spec.id or path.stem
    parts: list[Part] = []
    for key in spec.parts:
        parts.append(made(tree, key, name, tuple(parts), by=by, seed=seed, tell=tell))
    return Project(
        id=name, title=spec.title, statement=spec.statement, source=spec.source, schemes=tuple(spec.schemes),
        parts=tuple(parts), demands=_demands(spec, tree, parts), path=path, text=tree.text,
        block=block_of(spec.title_block, tree),
    )  # fmt: skip


def _demands(spec: ProjectSpec, tree: Tree, parts: list[Part]) -> tuple[Demand, ...]:
    faults = Faults(tree.name, tree.places)
    drawn, exact = known(parts, exact=False), known(parts, exact=True)
    found = []
    for i, one in enumerate(spec.demands):
        with faults.at("demands", i):
            judgement = judged(one.say, one.that, drawn, exact)
            _refuse_given(judgement, parts)
            found.append(judgement)
    faults.settle()
    return tuple(found)


def _refuse_given(demand: Demand, parts: list[Part]) -> None:
    """What the data of a task already are, no linkage can miss: such a demand would be met whatever is found."""
    name, _, key = demand.name.partition(".")
    part = next((one for one in parts if one.name == name), None)
    if part is not None and part.finds and key in part.problem.design.settled():
        raise FaultError(
            Words(
                f"{demand.name} 是“{name}”的已知数据（或仅由已知数据算得），不论求得什么机构都满足；"
                f"请改为检验所得机构的量，如 motion.{key}",
                f"{demand.name} is given to '{name}', or follows from what is given alone: it would hold whatever "
                f"linkage is found; demand it of the linkage as it moves, e.g. motion.{key}",
            ),
            code="contradiction",
        )
