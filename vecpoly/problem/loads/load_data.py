"""The loads for 已知."""

from __future__ import annotations

from ...mechanism.loads import Force, Load, Loads
from ...words import Words
from ..problem import Datum
from ..schema.models import ProblemSpec


def written(text: str) -> str:
    """A unit as a book prints it: N*m → N·m, kg/m^3 → kg/m³."""
    return text.replace("**", "^").replace("*", "·").replace("^2", "²").replace("^3", "³")


def data_of_loads(spec: ProblemSpec, loads: Loads) -> tuple[Datum, ...]:
    """The loads for 已知, and whether weights and inertia forces count."""
    data = [
        _told(load, written(str(spec.loads[load.name].size)), spec.loads[load.name].direction or "")
        for load in loads.all
    ]
    if loads.weight:
        data.append(Datum(words=Words("计各构件重力，$g$ = 9.81 m/s²", "the links' weights count, $g$ = 9.81 m/s²")))
    if loads.masses and not loads.inertia:
        data.append(Datum(words=Words("不计惯性力", "inertia forces are neglected")))
    return tuple(data)


_ROLE = {"": Words("", ""), "driving": Words("驱动", "driving "), "resisting": Words("阻", "resisting ")}


def _told(load: Load, size: str, direction: str) -> Datum:
    role = _ROLE[load.role]
    if isinstance(load, Force) and load.against:
        zh = f"为油缸 {load.against}-{load.link} 的推力，使其伸长者为正"
        en = f"as the thrust of the cylinder {load.against}-{load.link}, positive where it lengthens it"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    elif isinstance(load, Force):
        zh = f"作用于构件 {load.link} 的 ${load.point}$ 点，方向角 {direction}"
        en = f"on link {load.link} at ${load.point}$, direction {direction}"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    else:
        zh, en = f"作用于构件 {load.link}", f"on link {load.link}"
        name = Words(f"{role.zh}力矩" if role.zh else "力矩", f"{role.en}moment")
    if load.size is None:
        return Datum(
            words=Words(f"待求的{name.zh} ${load.name}$ {zh}", f"the unknown {name.en} ${load.name}$ acts {en}")
        )
    told = Words(f"{name.zh} ${load.name}$ = {{}}，{zh}", f"{name.en} ${load.name}$ = {{}} {en}")
    return Datum(symbol=load.name, si=load.size, text=size, words=told)
