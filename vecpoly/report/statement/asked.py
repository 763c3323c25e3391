"""What is asked, as the line after 求 says it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeVar, get_args

from ...algebra.quantity import number
from ...mechanism.asked.centres import count
from ...mechanism.asked.forces import load_symbol
from ...mechanism.model import Mechanism
from ...names import is_centre, is_place
from ...problem.asked.asks import Ask, AskCoriolis, AskNamed, AskPoint
from ...problem.asked.checks import is_check
from ...problem.problem import Problem
from ...solution import YES_NO, Solution
from ...words import Lang, Words, bare, plural
from ..values import asked_as, asked_load, called, curved, way_of
from .centrodes import centrodes_asked
from .further import THE_SAME, further
from .groups import Group, by_groups, parted
from .meant import meant_by

_MEANT = {
    "eta": Words("效率 {}", "the efficiency {}"),
    r"J_e\d*": Words("等效转动惯量 {}", "the equivalent moment of inertia {}"),
    r"M_e\d*": Words("等效力矩 {}", "the equivalent moment {}"),
    r"m_e\d*": Words("等效质量 {}", "the equivalent mass {}"),
    r"F_e\d*": Words("等效力 {}", "the equivalent force {}"),
    "dW_max": Words("最大盈亏功 {}", "the maximum surplus of work {}"),
    "J_F": Words("飞轮的转动惯量 {}", "the moment of inertia of the flywheel {}"),
    "J_F_areas": Words("$J_F$ 的近似值 {}", "the approximation {} of $J_F$"),
    "phi_max": Words("最大转速的位置 {}", "the position of maximum speed {}"),
    "phi_min": Words("最小转速的位置 {}", "the position of minimum speed {}"),
    r"W_c\d+": Words("配重的质径积 {}", "the mass-radius product of the counterweight {}"),
    r"theta_c\d+": Words("配重的方位角 {}", "the angular position of the counterweight {}"),
    r"m_c\d+": Words("配重的质量 {}", "the mass of the counterweight {}"),
}
_IN_LINE = ("_extended", "_overlapped")  # crank and coupler, in one line
_ARTICLE = {"Zhukovsky lever": "the ", "sine rule": "the "}
_LISTED = 3  # kinds of what is asked that are numbered
_NUMBER = "number of "  # that is said once of several in a row
_SYMBOL = re.compile(r"\$[^$]+\$")
ALL_CENTRES = Words("全部瞬心", "all instant centres")
T = TypeVar("T")


def asked(solution: Solution, lang: Lang) -> str:
    """The questions in symbols and words, a long list of them by kinds: the velocities v_B, v_C; the angular ..."""
    comma, stop = ("、", "；") if lang == "zh" else (", ", "; ")
    more = further(solution.construction.readings)
    told = [
        (key, _told(ask, solution, lang) if ask else ALL_CENTRES.of(lang))
        for key, ask in _listed(solution)
        if ask is None or ask.rel.key not in more
    ]
    parts = [
        _headed(group, [text for _, text in some], lang) + comma.join(_once_named([text for _, text in some], lang))
        for group, some in asked_by_kinds(told)
    ]
    many = len(parts) >= _LISTED
    listed = [f"({n}) {part}" if many else part for n, part in enumerate(parts, 1)]
    whole = stop.join([*listed, THE_SAME.of(lang)] if more else listed)
    return whole + centrodes_asked(solution.problem).of(lang)


def _headed(group: Group | None, texts: Sequence[str], lang: Lang) -> str:
    """What heads a kind: nothing where each has a name of its own, which says it already."""
    if group is None or (group.named is None and all(map(_name_of, texts))):
        return ""
    return group.heads(len(texts), lang)


def repeated(solution: Solution) -> bool:
    """Whether the statement already asks for all of it, by the same symbols, or for all instant centres."""
    return all(_repeated(solution.problem.statement.of(lang), asked(solution, lang), lang) for lang in get_args(Lang))


def _repeated(statement: str, told: str, lang: Lang) -> bool:
    symbols = {bare(one) for one in _SYMBOL.findall(told)}
    if not symbols:
        return told == ALL_CENTRES.of(lang) and told in statement
    return symbols <= {bare(one) for one in _SYMBOL.findall(statement)}


def _once_named(texts: Sequence[str], lang: Lang) -> Iterator[str]:
    """All of one name have it once, where the first of them stands: balancing masses m_1, m_2."""
    named: dict[str, list[str]] = {}
    for text in texts:
        name = _name_of(text)
        named.setdefault(name or text, []).append(f"${text.rpartition(' $')[2]}" if name else "")
    counts = [name for name in named if name.startswith(_NUMBER)]
    for name, symbols in named.items():
        first, *others = symbols
        head = plural(name) if others and first and lang == "en" else name
        if len(counts) > 1 and name in counts:
            head = f"numbers of {head.removeprefix(_NUMBER)}" if name == counts[0] else head.removeprefix(_NUMBER)
        yield f"{head} {first}".rstrip()
        yield from others


def asked_by_kinds(told: Sequence[tuple[str, T]]) -> list[tuple[Group | None, list[tuple[str, T]]]]:
    """A long list by kinds, a short one as it is; each by the key by which its kind is known."""
    return by_groups(told, key=lambda one: one[0]) if parted([key for key, _ in told]) else [(None, [*told])]


def in_order(solution: Solution) -> list[tuple[Group | None, list[str]]]:
    """The keys of all that is answered, in the order and by the kinds in which it is asked; what is answered beside
    it comes last."""
    listed = list[tuple[str, str]]()
    for key, ask in _listed(solution):
        centres = [one.rel.key for one in solution.problem.asks if is_centre(one.rel)] if ask is None else [ask.rel.key]
        listed += [(key, one) for one in centres]
    known = {one for _, one in listed}
    listed += [(key, key) for key in solution.answers if key not in known]
    by_kinds = parted([key for key, _ in _listed(solution)])  # as the question tells them
    groups = asked_by_kinds(listed) if by_kinds else [(None, listed)]
    names = {ask.rel.key: _name_of(_told(ask, solution, "en")) for _, ask in _listed(solution) if ask is not None}
    return [(group, _by_name([key for _, key in some], names)) for group, some in groups]


def _by_name(keys: Sequence[str], names: Mapping[str, str]) -> list[str]:
    """The keys of one name together, where the first of them stands."""
    first = {name: n for n, name in reversed([*enumerate(names.get(key) or key for key in keys)])}
    return sorted(keys, key=lambda key: first[names.get(key) or key])


def _name_of(text: str) -> str:
    """What a quantity is called before its symbol; nothing of what stands for itself."""
    name, _, symbol = text.rpartition(" $")
    return "" if not symbol.endswith("$") or name.startswith(("whether", "是否")) else name


def _listed(solution: Solution) -> Iterator[tuple[str, Ask | None]]:
    """Each question by the key by which its kind is known; None where all instant centres are asked. That a quantity is
    checked by the sine rule is no question of its own."""
    coriolis = {ask.rel.key for ask in solution.problem.asks if isinstance(ask, AskCoriolis)}
    centres = [ask.rel for ask in solution.problem.asks if isinstance(ask, AskNamed) and is_centre(ask.rel)]
    every = bool(centres) and len(centres) == count(solution.problem.mechanism)
    if every:
        yield "", None
    keys = {ask.rel.key for ask in solution.problem.asks}
    for ask in solution.problem.asks:
        if is_check(ask.rel.key, keys):
            continue
        if (ask.rel.key in coriolis and not isinstance(ask, AskCoriolis)) or (every and ask.rel in centres):
            continue
        plain = isinstance(ask, AskPoint | AskCoriolis) or is_place(ask.rel)
        yield "" if plain else ask.rel.key, ask


def _told(ask: Ask, solution: Solution, lang: Lang) -> str:
    """One question."""
    reading = solution.construction.readings[ask.rel.key]
    symbol = f"${reading.symbol}$"
    if isinstance(ask, AskPoint):
        return _point_asked(ask, symbol).of(lang)
    if isinstance(ask, AskCoriolis):
        return Words(
            f"有无哥氏加速度 {symbol} 及其方向", f"whether a Coriolis term {symbol} exists and where it points"
        ).of(lang)
    if is_place(ask.rel):
        of = curved(ask.rel, lang) + symbol.replace("^{∞}", "")
        return Words(f"{of} 的位置", f"the position of {of}").of(lang)
    if reading.unit == YES_NO:
        name = asked_as(reading.symbol, reading.key, lang)
        return Words(name if "是否" in name else f"是否{name}", f"whether {name}").of(lang)
    if (kind := asked_load(solution.problem, reading.key)) is not None:
        return _load_told(kind, reading.key, symbol, solution).of(lang)
    if (meant := meant_by(solution.problem.subject, reading.key, symbol)) is not None:
        return meant.of(lang)
    if isinstance(solution.problem.subject, Mechanism):
        meant = of_machines(solution.problem, reading.key, symbol)
        if meant is not None:
            return meant.of(lang)
    if reading.key.endswith(_IN_LINE):
        return _in_line(reading.key, symbol).of(lang)
    return curved(ask.rel, lang) + called(reading.symbol, reading.key, lang)


def of_machines(problem: Problem, key: str, symbol: str) -> Words | None:
    """A quantity of a mechanism as a machine with what it is, the efficiency η; None of one without a name."""
    if key == "h" and problem.acting is not None:
        load = problem.acting.unknown
        return Words(
            f"与 ${load_symbol(load.name)}$ 平衡的力偶（作用于构件 {load.link}）的力偶臂 {symbol}",
            f"the arm {symbol} of the couple that balances ${load_symbol(load.name)}$ on link {load.link}",
        )
    meant = next((words for keys, words in _MEANT.items() if re.fullmatch(keys, key)), None)
    return None if meant is None else Words(meant.zh.format(symbol), meant.en.format(symbol))


def _in_line(key: str, symbol: str) -> Words:
    """A crank angle at which a led point stands still."""
    way = Words("拉直", "extended") if key.endswith(_IN_LINE[0]) else Words("重叠", "overlapped")
    return Words(f"曲柄与连杆{way.zh}共线时的曲柄位置角 {symbol}", f"the crank angle {symbol} with both {way.en}")


def _load_told(kind: Words, key: str, symbol: str, solution: Solution) -> Words:
    """The balancing load; where it is asked in another way before, in which way it is found."""
    first = next(ask.rel.key for ask in solution.problem.asks if asked_load(solution.problem, ask.rel.key) is not None)
    way = way_of(key)
    if way is not None and first != key and way_of(first) is None:
        again = symbol == f"${solution.construction.readings[first].symbol}$"
        if again:
            by = f"by {_ARTICLE.get(way.en, '')}{way.en}"
            return Words(f"{symbol} 的校核值（{way.zh}）", f"{symbol} as a check, {by}")
        return Words(f"{symbol}（{way.zh}）", f"{symbol} ({way.en})")
    return kind + Words("", " ") + Words(*(called(symbol.strip("$"), key, lang) for lang in ("zh", "en")))


def _point_asked(ask: AskPoint, symbol: str) -> Words:
    if ask.slowest is not None:
        line = "".join(ask.slowest)
        return Words(
            f"构件 {ask.link} 的 ${line}$ 线上速度最小的点 {symbol}",
            f"the slowest point {symbol} of link {ask.link} on the line ${line}$",
        )
    if ask.velocity == 0:
        return Words(f"构件 {ask.link} 的绝对瞬心 {symbol}", f"the instant centre {symbol} of link {ask.link}")
    if ask.acceleration == 0:
        return Words(f"构件 {ask.link} 的加速度中心 {symbol}", f"the acceleration pole {symbol} of link {ask.link}")
    kind = Words("速度", "velocity") if ask.velocity is not None else Words("加速度", "acceleration")
    value = ask.velocity if ask.velocity is not None else ask.acceleration
    assert value is not None
    pair = f"({number(value.real)}, {number(value.imag)})"
    unit = "m/s" if ask.velocity is not None else "m/s^2"
    return Words(
        f"构件 {ask.link} 上{kind.zh}为 {pair} {unit} 的点 {symbol}",
        f"the point {symbol} of link {ask.link} with {kind.en} {pair} {unit}",
    )
