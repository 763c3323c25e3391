"""How quantities are named and their values printed: units of paper, percentages of efficiencies, yes and no."""

from __future__ import annotations

import re
from math import isnan

from ..algebra.quantity import number
from ..foundation.roman import CLASS, chinese, latin
from ..mechanism.asked.forces import load_named
from ..mechanism.loads import Force
from ..names import Key, Named
from ..printed.digits import LEAST, in_percent
from ..printed.units import printed_unit
from ..problem.problem import Problem
from ..solution import YES_NO
from ..words import Lang, Words

_UNDEFINED = Words("无意义", "undefined")
_YES, _NO = Words("是", "yes"), Words("否", "no")
_MET, _CONDITIONS = (Words("满足", "satisfied"), Words("不满足", "not satisfied")), frozenset({"v_allowed"})
_GROUPS = "groups_"
_BALANCED = {"static": Words("静平衡", "statically balanced"), "dynamic": Words("动平衡", "dynamically balanced")}
_STATION = re.compile(r"(s|psi|alpha|r|P)_[\d.]+")  # of a cam, or of Freudenstein: s_0 is no s without friction
_CURVED = {
    "W": Words("拐点极", "inflection pole"),
    "U": Words("鲍尔点", "Ball point"),
    "Wr": Words("回归极", "return pole"),
    "delta": Words("拐点圆直径", "diameter of the inflection circle"),
    "rho": Words("曲率半径", "radius of curvature"),
    "lambda": Words("共线轴与连杆的夹角", "angle of the collineation axis to the coupler"),
    "L_f": Words("定瞬心线弦长之和", "chords of the fixed centrode"),
    "L_m": Words("动瞬心线弦长之和", "chords of the moving centrode"),
}
_WAYS = {
    "_0": Words("不计摩擦", "no friction"),
    "_lever": Words("速度多边形杠杆法", "Zhukovsky lever"),
    "_power": Words("虚功率法", "virtual power"),
    "_sine": Words("正弦定理", "sine rule"),
}


def value(size: float, unit: str, lang: Lang, key: str = "", digits: int = 4) -> str:
    """A value with its unit: 52.45 mm, 38.2°, yes, 0.7952 (79.52 %); 0/0 is undefined."""
    if isnan(size):
        return _UNDEFINED.of(lang)
    if unit == YES_NO:
        met, failed = _MET if key in _CONDITIONS else (_YES, _NO)
        return (met if size else failed).of(lang)
    factor, name = printed_unit(unit)
    text = number(factor * size, digits)
    if unit == "deg":
        return f"{text}°"
    if is_efficiency(key, unit) and size >= LEAST:
        return f"{text} ({in_percent(text)})"
    return f"{text} {name}".rstrip()


def unit_after(name: str) -> str:
    """A unit as it follows its number: 12.5°, 5 mm; none of a pure number."""
    return "°" if name == "deg" else f" {name}".rstrip()


def rough(size: float) -> str:
    """Two significant digits, with no power of ten for hundreds: 190, 0.012."""
    return number(float(f"{size:.2g}"), 6) if 100 <= abs(size) < 1e6 else number(size, 2)


def is_efficiency(key: str, unit: str) -> bool:
    """Whether the quantity is an efficiency: eta, eta_prime."""
    return not unit and key.partition("_")[0] == "eta"


def is_class(key: str) -> bool:
    """Whether the quantity is the class of a mechanism, which is told by a Roman numeral: class_1, class_1+3."""
    return key.startswith(CLASS)


def is_worded(key: str, unit: str) -> bool:
    """Whether it is told by a name in words in place of a symbol: yes and no, the class."""
    return unit == YES_NO or is_class(key)


def class_told(rank: float, lang: Lang) -> str:
    """Ⅲ 级, class III; of what cannot be taken apart that."""
    told = Words(f"{chinese(int(rank))} 级", f"class {latin(int(rank))}") if rank else Words("不能拆分", "none")
    return told.of(lang)


_CRITERION = re.compile(r"(?:（\$[^$]*[=<>≤≥][^$]*\$）| \(\$[^$]*[=<>≤≥][^$]*\$\))$")


def asked_as(symbol: str, key: str, lang: Lang) -> str:
    """What it is called where it is asked: without the criterion, self-locking (h ≤ ρ), which would tell the way."""
    return _CRITERION.sub("", called(symbol, key, lang))


def called(symbol: str, key: str, lang: Lang) -> str:
    """A symbol as a table's line begins; told apart where one symbol is found in several ways."""
    if key.startswith("self_locking"):
        return f"自锁（${symbol}$）" if lang == "zh" else f"self-locking (${symbol}$)"
    if key == "undercut" and symbol.startswith("x"):
        return f"根切（${symbol}$）" if lang == "zh" else f"undercut (${symbol}$)"
    if key == "undercut":
        return "运动失真" if lang == "zh" else "undercut (motion lost)"  # not by ρ alone: by corners, or elsewhere too
    if _STATION.fullmatch(key):
        return f"${symbol}$"
    if key == "determined":
        return "运动是否确定" if lang == "zh" else "the motion is determined"
    if key in _BALANCED:
        return f"{_BALANCED[key].of(lang)}（${symbol}$）" if lang == "zh" else f"{_BALANCED[key].en} (${symbol}$)"
    if is_class(key):
        drivers = key.removeprefix(CLASS).split("+")
        plural = "s" * (len(drivers) > 1)
        return Words(
            f"机构级别（原动件 {'、'.join(drivers)}）",
            f"class with link{plural} {' and '.join(drivers)} as driver{plural}",
        ).of(lang)
    if key.startswith(_GROUPS):
        return Words(f"杆组数 ${symbol}$", f"number of groups ${symbol}$").of(lang)
    way = way_of(key)
    if way is None or (key.endswith("_0") and key.startswith("R_")):
        return f"${symbol}$"
    return f"${symbol}$" + (f"（{way.zh}）" if lang == "zh" else f" ({way.en})")


def way_of(key: str) -> Words | None:
    """By which way a quantity is found, as its key ends; None where that is not told."""
    return next((words for ending, words in _WAYS.items() if key.endswith(ending)), None)


def curved(named: Key, lang: Lang) -> str:
    """What a quantity of curvatures is, before its symbol; "" of others."""
    if not isinstance(named, Named) or not named.is_curved:
        return ""
    stem = named.key[:3] if named.key.startswith("L_") else named.key.partition("_")[0]
    words = _CURVED.get(stem, Words("曲率中心", "centre of curvature"))
    return words.zh if lang == "zh" else f"the {words.en} "


def counted_from(problem: Problem, key: str) -> Words | None:
    """From which line the angle of a counterweight counts, counter-clockwise; None of any other quantity."""
    if problem.counterweights is None or not key.startswith("theta_c"):
        return None
    number = problem.mechanism.number
    mount = next((one for one in problem.counterweights.mounts if f"theta_c{number(one.link)}" == key), None)
    if mount is None:
        return None
    line = f"${mount.outlets[0].point}{mount.towards}$"
    return Words(f"自 {line} 逆时针", f"counter-clockwise from {line}")


def direction_of_load(problem: Problem, key: str) -> float | None:
    """The fixed direction (rad) of a force asked by its size: the sign of the size is along it."""
    if problem.loads is None:
        return None
    return next(
        (
            load.direction
            for load in problem.loads.forces
            if not load.against and load_named(load).key in (key, *(key.removesuffix(ending) for ending in _WAYS))
        ),
        None,
    )


def asked_load(problem: Problem, key: str) -> Words | None:
    """What a balancing load is called in the line that says what is asked."""
    if problem.loads is None:
        return None
    load = problem.loads.unknown
    named = load_named(load)
    stem = next((key.removesuffix(ending) for ending in _WAYS if key.endswith(ending)), key)
    if stem != named.key:
        return None
    force = isinstance(load, Force)
    return {
        "driving": Words("驱动力" if force else "驱动力矩", "the driving force" if force else "the driving moment"),
        "resisting": Words("阻力" if force else "阻力矩", "the resistance" if force else "the resisting moment"),
        "": Words("平衡力" if force else "平衡力矩", "the balancing force" if force else "the balancing moment"),
    }[load.role]
