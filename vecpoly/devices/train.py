"""A train of machines as it is written: a row of transmissions that ends in a load or parts into branches."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, WithJsonSchema, model_validator

from ..errors import FaultError
from ..units.reading import Quantity
from ..words import Words
from .base import Efficiency, ForceSize, Power, Speed

KINDS = ("belt", "chain", "gear", "worm", "bearing", "coupling", "screw", "conveyor", "winch", "pump", "machine")

Train = tuple["Part", ...]


def _end(text: str) -> str:
    if text and not (len(text) == 1 and "A" <= text <= "Z"):
        raise FaultError(
            Words(
                f"“{text}”不能作支路末端的名称：用一个大写字母；如写 name: A",
                f"'{text}' is no name of a branch's end: it is one capital letter; write e.g. name: A",
            ),
            code="spelling",
        )
    return text


End = Annotated[str, AfterValidator(_end), WithJsonSchema({"type": "string", "pattern": "^[A-Z]?$"})]


class Part(BaseModel):
    """One transmission with its efficiency, or the place where the train parts into branches.

    The last part of every branch says what it delivers: a power P, or a force F at a speed v.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, revalidate_instances="always")

    belt: Efficiency | None = None
    chain: Efficiency | None = None
    gear: Efficiency | None = None
    worm: Efficiency | None = None
    bearing: Efficiency | None = None
    coupling: Efficiency | None = None
    screw: Efficiency | None = None
    conveyor: Efficiency | None = None
    winch: Efficiency | None = None
    pump: Efficiency | None = None
    machine: Efficiency | None = None
    parallel: tuple[tuple[Part, ...], ...] | None = None
    name: End = ""
    P: Power | None = None
    F: ForceSize | None = None
    v: Speed | None = None

    @property
    def kind(self) -> str:
        """belt, gear, machine ...; empty where the train parts."""
        return next((kind for kind in KINDS if getattr(self, kind) is not None), "")

    @property
    def eta(self) -> float:
        """Its efficiency."""
        written: Quantity = getattr(self, self.kind)
        return written.si

    @property
    def loaded(self) -> bool:
        """Whether it says what it delivers."""
        return self.P is not None or self.F is not None

    @model_validator(mode="after")
    def _is_one_thing(self) -> Part:
        kinds = [kind for kind in KINDS if getattr(self, kind) is not None] + ["parallel"] * (self.parallel is not None)
        if len(kinds) != 1:
            raise FaultError(
                Words(
                    f"传动系统的每一级为 {', '.join(KINDS)} 之一及其效率，或为 parallel；"
                    f"这里写的是 {' 和 '.join(kinds) or '空'}；如写 gear: 0.97",
                    f"a part of a train is one of {', '.join(KINDS)} with its efficiency, or parallel: here "
                    f"stand {' and '.join(kinds) or 'none of them'}; write e.g. gear: 0.97",
                ),
                code="spelling",
                keys=kinds,
            )
        self._check_load()
        if self.parallel is not None:
            self._check_branches(self.parallel)
        return self

    def _check_load(self) -> None:
        """FaultError where what is delivered stands there by half, or twice."""
        if (self.F is None) != (self.v is None):
            raise FaultError(
                Words(
                    "有力 F 就须有克服它的速度 v；请同时写 F 和 v，或只写 P",
                    "a force needs the speed at which it is overcome: write both F and v, or P alone",
                ),
                code="spelling",
                keys=("F", "v"),
            )
        if self.P is not None and self.F is not None:
            raise FaultError(
                Words(
                    "输出功率重复给出；请写 P，或写 F 和 v", "what is delivered stands there twice: write P, or F and v"
                ),
                code="contradiction",
                keys=("P", "F"),
            )

    def _check_branches(self, branches: tuple[Train, ...]) -> None:
        """FaultError where the place at which the train parts delivers itself, or parts into one branch."""
        if self.loaded or self.name:
            raise FaultError(
                Words(
                    "分流处没有功率输出；P、F、v 和 name 应写在各支路的末端",
                    "where the train parts nothing is delivered: write P, F, v and name at the ends of its branches",
                ),
                code="spelling",
                keys=("name", "P", "F"),
            )
        if len(branches) < 2:
            raise FaultError(
                Words(
                    "parallel 至少要有两条支路；只有一条时直接写成串联的一级",
                    "parallel needs two branches or more; write a single one as part of the train itself",
                ),
                code="missing",
            )
        for branch in branches:
            check_train(branch)


def check_train(train: Train) -> None:
    """Power is delivered at the end of a train, and nowhere else."""
    if not train:
        raise FaultError(
            Words(
                "传动系统没有任何一级；如写 [gear: 0.97, {machine: 0.8, P: 5 kW}]",
                "a train without parts; write e.g. [gear: 0.97, {machine: 0.8, P: 5 kW}]",
            ),
            code="spelling",
        )
    for part in train[:-1]:
        if part.parallel is not None:
            raise FaultError(
                Words(
                    "parallel 之后功率已经分流；其后的各级应写入各支路",
                    "after parallel the power is divided: put the parts that follow it into its branches",
                )
            )
        if part.loaded:
            raise FaultError(
                Words(
                    f"功率由系统的最后一级输出，不能由中间的 {part.kind} 输出；请将 P 或 F、v 写在末级，"
                    "或在该处用 parallel 分流",
                    f"power is delivered by the last part of a train, not by its {part.kind}: put P, or F and "
                    "v, at the end, or let the train part there with parallel",
                )
            )
    if train[-1].parallel is None and not train[-1].loaded:
        raise FaultError(
            Words(
                f"最后一级的输出没有给出；如写 {{{train[-1].kind}: {train[-1].eta:g}, P: 5 kW}}",
                f"nothing says what the last part of a train delivers; write e.g. {{{train[-1].kind}: "
                f"{train[-1].eta:g}, P: 5 kW}}",
            ),
            code="spelling",
        )


def parts(train: Train) -> Iterator[Part]:
    """All parts, in the order in which the power runs, branch after branch."""
    for part in train:
        yield part
        for branch in part.parallel or ():
            yield from parts(branch)


def ends(train: Train) -> tuple[Part, ...]:
    """The parts that deliver power."""
    return tuple(part for part in parts(train) if part.loaded)


def partings(train: Train) -> tuple[Part, ...]:
    """The places where the train parts, the outermost first."""
    return tuple(part for part in parts(train) if part.parallel is not None)
