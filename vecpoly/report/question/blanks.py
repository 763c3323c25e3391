"""What is filled in by hand: the table of results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.acts import Compute
from ...board.construction import Reading
from ...designs.inversion.positions import MANY, Positions
from ...devices.base import Device
from ...errors import UnknownNameError
from ...mechanism.model import Mechanism
from ...names import Kind, Named, Rel, parse_rel, written_unit
from ...printed.units import printed_unit
from ...problem.asked.asks import AskCoriolis
from ...solution import YES_NO, Answer, Solution
from ...typeset.box import MM
from ...words import Lang, Words
from ..answers.order import solution_of
from ..flow.furniture import COLUMN
from ..statement.asked import in_order, of_machines
from ..statement.further import IF_ANY, further, number_in
from ..statement.meant import meant_by
from ..values import asked_as, called
from .columns import HEADS, UNFRAMED, WITH_UNIT, Cells, Framed, headed, in_columns
from .found import as_found
from .framed.readings import AWAY
from .ruled import NONE, RuledTable

_YES_OR_NO = Words("（是/否）", " (yes or no)")
_SOLVED, _ROOM = Words("解 {}", "Solution {}"), 4  # columns for the solutions of a synthesis, not as many as there are
_NOUGHT = Words("哥氏加速度 {}（无则填 0）", "Coriolis term {} (0 if none)")
_PLACE = Words("(　　　　　，　　　　　) mm", "(　　　　　,　　　　　) mm")
_OTHERS = Words("其他", "Others")
_SPEEDS = frozenset(("omega_m", "omega_max", "omega_min"))  # of a machine: sizes
_ON_THE_WAY, _ASKED = Words("中间量", "Intermediate results"), Words("所求量", "Required")


def empty_table(solution: Solution, lang: Lang, framed: Framed = UNFRAMED) -> RuledTable:
    """What is asked, by kinds as it is asked and each kind in the order in which it is found, with room for what is
    read, what it comes to, and where it points; what has to be known on the way comes before. framed: what has its
    place in a frame, and none here."""
    if all_sought(solution):
        return _solutions(solution, lang)
    return in_columns(list(_in_order([*_between(solution, lang)], solution, lang, framed)), lang)


def is_framed(solution: Solution, framed: Framed) -> bool:
    """Whether all that is asked or computed has its place in a frame: nothing is left for a table."""
    return not all_sought(solution) and not any(_in_order([*_between(solution, "en")], solution, "en", framed))


def are_lined(solution: Solution, lined: frozenset[str]) -> bool:
    """Whether each length that is read has its line in a frame, those on the way too."""
    read = {one.reading.symbol for one in solution.answers.values() if _measured(one)}
    read |= {one.symbol for one in _valueless(solution) if _is_length(one)}
    return bool(read) and read <= lined and not any(rel.is_vector for rel in on_the_way(solution))


def _in_order(first: list[Cells], solution: Solution, lang: Lang, framed: Framed) -> Iterator[Cells]:
    """What has to be known on the way comes before what is asked."""
    yield from first
    if first and len(in_order(solution)) == 1:
        yield headed(_ASKED.of(lang))
    yield from _sought(solution, lang, framed)


def all_sought(solution: Solution) -> bool:
    """Whether a synthesis asks for every linkage that fits, none of its quantities with a number: of four positions how
    many there are comes out."""
    design = solution.problem.subject
    free = isinstance(design, Positions) and len(design.poses) == MANY
    return free and not any(isinstance(one.rel, Named) and one.rel.solution for one in solution.answers.values())


def _solutions(solution: Solution, lang: Lang) -> RuledTable:
    """A column a solution; of each quantity what is read, and what it comes to."""
    heads = [HEADS[0].of(lang), *(_SOLVED.of(lang).format(n) for n in range(1, _ROOM + 1))]
    comma, sought = Words("，", ", ").of(lang), [(one.reading, _measured(one)) for one in solution.answers.values()]
    told = [
        f"{called(one.symbol, one.key, lang)}{comma}{head if lang == 'zh' else head.lower()}"
        for one, read in [*sought, *((one, _is_length(one)) for one in _valueless(solution))]
        for head, has in zip((HEADS[1].of(lang), WITH_UNIT.of(lang)), (read, True), strict=True)
        if has
    ]
    first = 52.0
    rows = [(name, *("" for _ in range(_ROOM))) for name in told]
    widths = [first, *((COLUMN / MM - first) / _ROOM for _ in range(_ROOM))]
    return RuledTable(heads, rows, widths, "l" + "c" * _ROOM, lang=lang)


def _sought(solution: Solution, lang: Lang, framed: Framed) -> Iterator[Cells]:
    """A row for each quantity, under the name of its kind where there are several kinds of them."""
    groups = in_order(solution)
    for group, keys in groups:
        rows = list(_by_solution(as_found(keys, solution), solution, lang, framed))
        if len(groups) > 1 and rows:
            yield headed(group.called(len(keys), lang) if group is not None else _OTHERS.of(lang))
        yield from rows


def _by_solution(keys: Sequence[str], solution: Solution, lang: Lang, framed: Framed) -> Iterator[Cells]:
    """Their rows; those of each of several solutions under its number, which stands in their subscripts."""
    readings = solution.construction.readings
    numbers = {
        key: solution_of(answer) if (answer := solution.answers.get(key)) else number_in(readings[key].symbol)
        for key in keys
    }
    before, more = 0, further(readings)
    for key in sorted(keys, key=numbers.__getitem__):
        one, number = solution.answers.get(key), numbers[key]
        row = _none(readings[key], solution, lang) if one is None else _row(one, solution, lang)
        row = framed.left_of(row, readings[key].symbol.replace(AWAY, ""))
        if all(cell == NONE for cell in (*row[1:3], row[4])):
            continue
        if number != before and len({*numbers.values()} - {0}) > 1:
            yield headed(_SOLVED.of(lang).format(number) + (IF_ANY.of(lang) if key in more else ""))
        before = number
        yield row


def _row(one: Answer, solution: Solution, lang: Lang) -> Cells:
    """Its unit; dashes for what it has not: a scalar points nowhere, what is computed is not read, and a direction that
    is asked by its angle stands there."""
    symbol, key = one.reading.symbol.replace(AWAY, ""), one.reading.key
    meant = meant_by(solution.problem.subject, key, f"${symbol}$") if one.reading.unit != YES_NO else None
    name = _named(one, symbol, solution, lang) if meant is None else meant.of(lang).removeprefix("the ")
    if one.reading.unit == YES_NO:
        name = _either(asked_as(symbol, key, lang), lang)
    if key in _in_doubt(solution):
        name = _NOUGHT.of(lang).format(f"${symbol}$")
    paper = "" if _measured(one) else NONE
    way = "" if _points(one) and f"theta_{key.partition('_')[2]}" not in solution.answers else NONE
    unit = NONE if one.is_place else _unit(one.reading.unit)
    return name, paper, _PLACE.of(lang) if one.is_place else "", unit, way


def _in_doubt(solution: Solution) -> frozenset[str]:
    """Terms of which it is asked whether they exist."""
    return frozenset(ask.rel.key for ask in solution.problem.asks if isinstance(ask, AskCoriolis))


def _either(name: str, lang: Lang) -> str:
    """A name with the answers that it may have, in the brackets that it has already."""
    if name.endswith(")") and lang == "en":
        return f"{name[:-1]}; yes or no)"
    return name + _YES_OR_NO.of(lang)


def _unit(unit: str) -> str:
    """The unit in which a value is written, which is printed; none of a number, or of yes and no."""
    return written_unit(printed_unit(unit)[1]) or NONE


def _named(one: Answer, symbol: str, solution: Solution, lang: Lang) -> str:
    """Its symbol, with what it is where a machine is reduced or balanced: no drawing shows that."""
    machine = isinstance(solution.problem.subject, Mechanism)
    meant = of_machines(solution.problem, one.reading.key, f"${symbol}$") if machine else None
    return called(symbol, one.reading.key, lang) if meant is None else meant.of(lang).removeprefix("the ")


def _valueless(solution: Solution) -> list[Reading]:
    """What a synthesis without a solution has no answer for, and is asked all the same: nothing gives that away."""
    return [one for key, one in solution.construction.readings.items() if key not in solution.answers]


def _is_length(one: Reading) -> bool:
    return one.unit == "mm"


def _none(one: Reading, solution: Solution, lang: Lang) -> Cells:
    meant = meant_by(solution.problem.subject, one.key, f"${one.symbol}$")
    name = called(one.symbol, one.key, lang) if meant is None else meant.of(lang).removeprefix("the ")
    return name, "" if _is_length(one) else NONE, "", _unit(one.unit), NONE


def _between(solution: Solution, lang: Lang) -> Iterator[Cells]:
    """A row for each velocity and acceleration that is computed, neither asked nor given, under a heading: those of
    points, which are laid off, then those of links; the mean of a machine's speed, or its extremes, have no sense."""
    found = on_the_way(solution)
    if found:
        yield headed(_ON_THE_WAY.of(lang))
    for rel in sorted(found, key=_by_kind):
        way = NONE if rel.key in _SPEEDS else ""
        yield f"${rel.symbol}$", "" if rel.is_vector else NONE, "", _unit(rel.unit), way


def on_the_way(solution: Solution) -> list[Rel]:
    """The velocities and accelerations that are computed, neither asked nor given; none of a device, of which it is for
    the solver to see what is needed."""
    if isinstance(solution.problem.subject, Device):
        return []
    known = {*solution.answers, *(_bare(datum.symbol) for datum in solution.problem.given.data)}
    keys = dict.fromkeys(act.key for act in solution.construction.acts if isinstance(act, Compute))
    return [rel for key in keys if (rel := _motion(key)) is not None and not known & {key, _bare(rel.symbol)}]


def _bare(symbol: str) -> str:
    return symbol.replace("{", "").replace("}", "")


def _by_kind(rel: Rel) -> tuple[int, str]:
    """Velocities and accelerations as they are found, ω of the links by their numbers, then α."""
    return (0, "") if rel.is_vector else (1 + (rel.kind is Kind.ALPHA), rel.key)


def _motion(key: str) -> Rel | None:
    """The velocity or acceleration of a point or link, absolute or relative, with this key; no term of one."""
    try:
        rel = parse_rel(key)
    except UnknownNameError:
        return None
    return rel if rel.kind in (Kind.V, Kind.A, Kind.OMEGA, Kind.ALPHA) else None


def _measured(answer: Answer) -> bool:
    """Whether it is read off the paper."""
    return answer.reading.mm is not None


def _points(answer: Answer) -> bool:
    """Whether it has a direction or a sense: a moment of inertia has none, nor has a place."""
    return (answer.drawn_vector is not None and not answer.is_place) or answer.turns
