"""Lines that are no formula, F = 1, φ = 40.3°: they stand in the sentence that leads to them, not displayed; what
stands in the box of answers with no way to it, a place or a zero of which the sentence tells, is not said twice."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from ...algebra.formula import Node, Row, Sym, Txt, plain
from ...board.construction import Step
from ...printed.told import ABOUT, EQUALS, NUMBER
from ...solution import Answer, Solution
from ...words import Lang, Words, bare
from ..answers.notes import stands_still
from .pointing import FORCES, ends_of

_COLONS = ("：", ":")
_MOST = 4  # lines in a sentence
_UNDEFINED = " —"  # of a direction that vanished, which the sentence tells
_WORKED, _NOTHING = 6, " = 0 "  # parts of a line symbol = formula = numbers = result; how one ends that vanishes
_RATIO = 4  # parts of a line ω_2/ω_3 = numbers = result
# numbers that work out what is plain: 0 × 2, (400 − 400); 1 × 0.08, (400 − 0)/400, 400/400
_ZERO = re.compile(r"(?<![\d.])0(?![\d.])|\((\S+) − \1\)")
_SEEN = re.compile(r"^1(\.0+)? × [\d.]+$|\((\S+) − 0\)/\(\2\)$|× \(([\d.]+)\)/\(\3\)$")
_ONE = re.compile(r"^\((\S+)\)/\(\1\)$|\)/\(1\)$")  # of whatever others are like it: 0.31/0.31, 28/1
_EQUAL, _INDEX = 3, re.compile(r"_\w+")  # lines that are told together; what differs in them
_LINKS = 2  # signs of equality in R_32 = R_21 = 659 N


def displayed(step: Step, solution: Solution) -> tuple[Node, ...]:
    """The lines of a step that are set as formulas; each ends with the number that is gone on with."""
    left = _left(step, solution)
    if _in_sentence(step, left):
        return ()
    told = [_once(line) for line in left]
    long = {_form(line) for line in told if not (_is_nothing(line) or _is_seen(line))}
    return tuple(_plainly(line, _is_one(line) or (_is_seen(line) and _form(line) not in long)) for line in told)


def measured_once(lines: Sequence[Node]) -> Iterator[Node]:
    """Forces that one side of the polygon gives, in either sense, as one line: R_21 = R_12 = μ_F bc = ..."""
    sides = dict[frozenset[str], list[Row]]()
    for line in lines:
        if isinstance(line, Row) and (ends := ends_of(line, FORCES)) is not None:
            sides.setdefault(frozenset(map(plain, ends)), []).append(line)
    first = {id(run[0]): run[1:] for run in sides.values()}
    later = {id(line) for run in sides.values() for line in run[1:]}
    for line in lines:
        if id(line) not in later:
            yield _headed(line, first[id(line)]) if isinstance(line, Row) and first.get(id(line)) else line


def _headed(line: Row, others: Sequence[Row]) -> Row:
    """The line with the symbols of others, which come to the same, before its way."""
    more = [item for other in others for item in (Txt(EQUALS), other.items[0])]
    return Row((line.items[0], *more, *line.items[1:]))


def chained(lines: Sequence[Node]) -> Iterator[Node]:
    """Lines in a row that say of one value after another that it is the same, R_32 = R_21 = 659 N, R_23 = R_12 = 659 N,
    as one: R_21 = R_32 = R_12 = R_23 = 659 N; what another line has found stands last, R_12 = R_41 = R_23 = 1003 N."""
    found = {plain(line.items[0]) for line in lines if isinstance(line, Row) and _end_of_chain(line) is None}
    for end, some in groupby(lines, key=_end_of_chain):
        run = list(some)
        if end is None or len(run) == 1:
            yield from run
            continue
        symbols = {plain(one): one for line in run if isinstance(line, Row) for one in (line.items[2], line.items[0])}
        in_order = [symbols[name] for name in sorted(symbols, key=found.__contains__)]
        linked = [item for one in in_order for item in (one, Txt(EQUALS))]
        yield Row((*linked[:-1], Txt(end)))


def together(lines: Sequence[Node]) -> Iterator[Node]:
    """Lines in a row that reckon the same of equal bodies, three or more, as one: W_1 = W_2 = W_3 = m_1 r_1 = ..."""
    for way, some in groupby(lines, key=_reckoned):
        run = list(some)
        if way is None or len(run) < _EQUAL:
            yield from run
            continue
        first = run[0]
        assert isinstance(first, Row)
        yield _headed(first, [line for line in run[1:] if isinstance(line, Row)])


def _reckoned(line: Node) -> tuple[str, str, str] | None:
    """The form of symbol = formula = numbers = result without its indices, its numbers and its result; None of another
    line."""
    form = _form(line)
    return (form, plain(line.items[-2]), plain(line.items[-1])) if form and isinstance(line, Row) else None


def _form(line: Node) -> str:
    """A line symbol = formula = numbers = result as symbol = formula without indices; nothing of another."""
    if not isinstance(line, Row) or len(line.items) != _WORKED:
        return ""
    return "=".join(_INDEX.sub("", plain(line.items[n])) for n in (0, 2))


def _end_of_chain(line: Node) -> str | None:
    """The end of symbol = symbol = value; None of another line."""
    match line:
        case Row((_, Txt(text), Row() | Sym(), Txt(end))) if text == EQUALS and end.startswith(EQUALS):
            return end if plain(line).count(EQUALS) == _LINKS and plain(line.items[2]).isidentifier() else None
        case _:
            return None


def _once(line: Node) -> Node:
    """7.215 rad/s of 7.215 rad/s ≈ 7.22 rad/s: the box of answers rounds it."""
    if not isinstance(line, Row) or not isinstance(line.items[-1], Txt) or ABOUT not in line.items[-1].text:
        return line
    exact, rounded = line.items[-1].text.split(ABOUT)
    same = NUMBER.sub("", exact, count=1).strip(EQUALS) == NUMBER.sub("", rounded, count=1).strip()
    return Row((*line.items[:-1], Txt(exact))) if same else line


def _is_nothing(line: Node) -> bool:
    """Whether it ends with a zero."""
    return isinstance(line, Row) and plain(line.items[-1]).startswith(_NOTHING)


def _is_seen(line: Node) -> bool:
    """Whether its numbers work out what is plain."""
    return isinstance(line, Row) and bool(_form(line)) and bool(_SEEN.search(plain(line.items[-2])))


def _is_one(line: Node) -> bool:
    """Whether its numbers divide by one, or by themselves."""
    return isinstance(line, Row) and len(line.items) >= _RATIO and bool(_ONE.search(plain(line.items[-2])))


def _plainly(line: Node, seen: bool) -> Node:
    """F = W ω² = 0 N of F = W ω² = 0 × 377² = 0 N: a factor that vanishes needs no numbers; seen: nor does one of 1."""
    if not isinstance(line, Row) or (len(line.items) < _WORKED and not seen):
        return line
    short = bool(_ZERO.search(plain(line.items[-2]))) if _is_nothing(line) else seen
    return Row((*line.items[:-3], line.items[-1])) if short else line


def _left(step: Step, solution: Solution) -> tuple[Node, ...]:
    """Without those that the box of answers tells, zeros that a sentence has told up to here, what was measured of
    candidates that are rejected, and, where others are left, lines that an earlier step has worked out."""
    told = list(_told_by_box(step, solution)) + list(_of_rejected(step, solution))
    before = [one for one in solution.construction.steps if one.number < step.number]
    said = [bare(one.words.zh) for one in (*before, step)]
    left = [
        line
        for line in step.formulas
        if not any(line is one for one in told)
        and not (_is_nothing(line) and any(_is_said(line, text) for text in said))
        and not (_is_bare(line) and any(_stands(line, text) for text in said[:-1]))
    ]
    worked = {plain(line) for one in before for line in one.formulas if _form(line)}
    new = [line for line in left if plain(line) not in worked]
    return tuple(new or left)


def with_results(text: str, step: Step, solution: Solution, lang: Lang) -> str:
    """The sentence of the step, with its lines where these are not displayed."""
    left, stop = _left(step, solution), Words("。", ".").of(lang)
    if not left:
        leads = text.endswith(_COLONS) and step.listing is None and step.equation is None and bool(step.formulas)
        return f"{text[:-1]}{stop}" if leads else text
    if not _in_sentence(step, left):
        return text
    new = [line for line in left if not _is_said(line, text)]
    if not new:
        return text
    lead = Words("", " ") if text.endswith(_COLONS) else Words("得 ", " This gives ")
    return f"{text}{lead.of(lang)}{Words('，', ', ').of(lang).join(map(_inline, new))}{stop}"


def _in_sentence(step: Step, left: Sequence[Node]) -> bool:
    """Whether nothing but bare lines, and few, belongs to the step."""
    return 0 < len(left) <= _MOST and step.equation is None and step.listing is None and all(map(_is_bare, left))


def _is_bare(line: Node) -> bool:
    """Whether it is symbol = value, with no way to it."""
    return isinstance(line, Row) and line.worked is None and plain(line).count(EQUALS) == 1


def _told_by_box(step: Step, solution: Solution) -> Iterator[Node]:
    """The bare lines that the box of answers tells as well, and the sentence too, or a figure: places, and zeros of
    what stands still."""
    asked = {id(one.reading.formula): one for one in solution.answers.values() if one.reading.formula is not None}
    for line in step.formulas:
        if plain(line).endswith(_UNDEFINED):
            yield line
        answer = asked.get(id(line))
        if answer is not None and (
            _is_endless(answer) or (_is_bare(line) and (answer.is_place or stands_still(answer)))
        ):
            yield line


def _of_rejected(step: Step, solution: Solution) -> Iterator[Node]:
    """The lines of candidates that are rejected beside others that are not: l_AB with the number (3) above."""
    kept = [one for one in solution.construction.candidates if one.reason is None]
    lost = [f"^({one.number})" for one in solution.construction.candidates if one.reason is not None]
    for line in step.formulas if kept else ():
        if any(number in plain(line).partition(EQUALS)[0] for number in lost):
            yield line


def _is_endless(answer: Answer) -> bool:
    """Whether it is a centre at infinity, of which the line tells the direction."""
    return answer.is_place and answer.drawn_vector is None


def _is_said(line: Node, text: str) -> bool:
    """Whether it is a zero that the sentence has already: so α_2 = 0, or R_12 = R_32 = 0."""
    symbol, *_, size = plain(line).split(EQUALS)
    zero = re.compile(rf"(?<![\w,′]){re.escape(symbol)} =(?: [\w,′^{{}}]+ =)* 0(?![.\d])")
    return size.split(" ")[0] == "0" and bool(zero.search(bare(text)))


def _stands(line: Node, text: str) -> bool:
    """Whether an earlier sentence has found it already: so ω_1 = 0.0330 rad/s."""
    symbol, size = plain(line).split(EQUALS)
    told = NUMBER.match(size)
    starts = re.finditer(rf"(?<![\w,′]){re.escape(symbol)}{EQUALS}", text)
    ends = (NUMBER.match(text, start.end()) for start in starts)
    return told is not None and any(end is not None and end[0] == told[0] for end in ends)


def _inline(line: Node) -> str:
    """symbol = value as it stands in a sentence."""
    assert isinstance(line, Row)
    symbol, *rest = line.items
    return f"${_short(symbol)}${''.join(plain(one) for one in rest)}"


def _short(node: Node) -> str:
    """A symbol in the short notation of sentences: γ^{(1)}_{min}."""
    match node:
        case Sym(base, sub, sup):
            return base + (f"^{{{sup}}}" if sup else "") + (f"_{{{sub}}}" if sub else "")
        case Row(items):
            return "".join(map(_short, items))
        case _:
            return plain(node)
