"""What a template may say of one problem:
plain words, and names of the objects (tables, equations, drawings) to be set."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ..algebra.quantity import number
from ..check.designs.found_words import all_lost, told
from ..check.shaking import shaking_of
from ..check.structure import dependence
from ..devices.structure import Structure
from ..devices.structure_named import F_LOW, P_REDUNDANT, F
from ..mechanism.model import Mechanism
from ..problem.asked.asks import AskCoriolis, AskNamed
from ..problem.values.given import Datum
from ..solution import YES_NO, Answer, Solution, fewer_digits
from ..words import Lang, Words, joined, label
from .answers.asked_in_words import answered_in_words
from .answers.tables import counted
from .sources import printed_source
from .statement.asked import asked, repeated
from .statement.conventions import conventions
from .statement.given_data import friction_heads, given_data
from .statement.in_table import OTHERS, in_table, in_table_words
from .statement.meant import meant_by
from .statement.profiles import profile_centres
from .statement.shortened import as_told
from .statement.structure import numbering, structure
from .statement.task import task
from .values import called, value

_LARGE = 100.0  # mm: from there on a coordinate has tenths


@dataclass(slots=True)
class Objects:
    """Things a template refers to by name."""

    named: dict[str, object] = field(default_factory=dict)

    def add(self, prefix: str, thing: object) -> str:
        """Keep a thing, give its name."""
        name = f"{prefix}{len(self.named)}"
        self.named[name] = thing
        return name


def beside_tables(solution: Solution, lang: Lang) -> dict[str, str]:
    """The same where what is given stands in tables too (`given_tables`): the line has the rest."""
    data, table = in_table(solution.problem, lang)
    told = statement(solution, lang, None if table is None else data)
    if table is None:
        return told
    return told | {
        "given": (told["given"] + OTHERS.of(lang)) if told["given"] else in_table_words(solution.problem, lang)
    }


def statement(solution: Solution, lang: Lang, data: Sequence[Datum] | None = None) -> dict[str, str]:
    """Title, source, statement, given (all, or these data) and asked in words; repeated: the statement asks so."""
    problem = solution.problem
    data = given_data(problem) if data is None else data
    comma, heads = "，" if lang == "zh" else ", ", friction_heads(problem, data, lang)
    given = [heads.get(d.symbol, "") + as_told(d, lang) for d in data]
    if isinstance(problem.subject, Mechanism) and any(problem.subject.frame.values()):
        given.insert(0, pivots(problem.subject).of(lang))  # a lone pivot at the origin tells nothing
    return {
        "id": problem.id,
        "label": label(problem.id).of(lang),
        "title": problem.title.of(lang),
        "source": printed_source(problem.source, lang, label(problem.id)),
        "statement": task(problem).of(lang),
        "given": comma.join(given),
        "asked": asked(solution, lang),
        "repeated": "repeated" if repeated(solution) else "",
        "structure": structure(problem).of(lang),
        "numbering": numbering(problem).of(lang),
        "profiles": profile_centres(problem).of(lang),
        "scales": scales(solution, lang),
    } | conventions(solution)


def pivots(mech: Mechanism) -> Words:
    """Where the fixed points are, in mm: a student cannot draw without them."""
    places = [f"${name}$({_drawable(at.real)}, {_drawable(at.imag)})" for name, at in mech.frame.items()]
    return Words(
        f"固定点坐标 {'、'.join(places)} mm", f"fixed point{'s' if len(places) > 1 else ''} {', '.join(places)} mm"
    )


def _drawable(metres: float) -> str:
    """A coordinate in mm, as finely as it can be drawn: 303.0 of 303.015."""
    mm = 1e3 * metres
    return number(round(mm, 1 if abs(mm) >= _LARGE else 2), 6)


def conclusions(solution: Solution, lang: Lang) -> list[str]:
    """What is concluded beside the quantities asked: that a term exists, what a linkage does, what is shaken."""
    coriolis = [
        _coriolis(solution.answers[ask.rel.key]).of(lang)
        for ask in solution.problem.asks
        if isinstance(ask, AskCoriolis) and solution.answers[ask.rel.key].direction is not None
    ]
    alone = len(solution.verification) == 1
    moved = [told(one, alone).of(lang) for one in solution.verification if one.broken is not None]  # others: in a table
    ended = solution.construction.conclusion
    kinds = {one.kind.of(lang) for one in solution.construction.candidates if one.reason is None and one.kind}
    shaken = shaking_of(solution.problem, {key: one.drawn for key, one in solution.answers.items()})
    return [
        *([ended.of(lang)] if ended is not None else []),
        *(kinds if len(kinds) == 1 else ()),
        *answered_in_words(solution, lang),
        *dict.fromkeys(coriolis),
        *moved,
        *([shaken.of(lang)] if shaken is not None else []),
    ]


def by_rank(solution: Solution, lang: Lang) -> str:
    """The counts of a structure that the rank of its constraint equations gives too, and gives the same."""
    subject, answers = solution.problem.subject, solution.answers
    if not isinstance(subject, Structure):
        return ""
    same = [answers[key] for key in _RANKED if key in answers and counted(answers[key])]
    named = [meant_by(subject, one.key, f"${one.reading.symbol}$") for one in same]
    return joined([words for words in named if words is not None]).of(lang)


_RANKED = (F.key, P_REDUNDANT.key, F_LOW.key)


def cautions(solution: Solution, lang: Lang) -> list[str]:
    """What is hardly meant; counts in which no hand can err,
    and which still are not what the oracle says, and why, as far as the oracle knows."""
    wrong = _miscounted(solution)
    why = dependence(solution.problem.subject) if wrong else None
    few = fewer_digits(solution)
    return [
        words.of(lang)
        for words in (
            *solution.warnings,
            few,
            *all_lost(solution.verification),
            _disagreed(wrong) if wrong else None,
            why,
        )
        if words is not None
    ]


def _miscounted(solution: Solution) -> list[Answer]:
    """Of a structure what is counted, and by the rank of its constraint equations is another number."""
    keys = [ask.rel.key for ask in solution.problem.asks if isinstance(ask, AskNamed)]
    named = [solution.answers[key] for key in keys if key in solution.answers]
    return [
        one
        for one in (named if isinstance(solution.problem.subject, Structure) else [])
        if one.reading.mm is None and not one.expected_error and not one.computed
    ]


def _disagreed(wrong: list[Answer]) -> Words:
    """Counts in which no hand can err, and what the oracle says."""
    ours, its = (
        [_counted(answer, size) for answer, size in zip(wrong, sizes, strict=True)]
        for sizes in ([answer.drawn for answer in wrong], [answer.exact for answer in wrong])
    )
    return Words(
        f"注意：按计数 {'，'.join(one.zh for one in ours)}；按约束方程的秩 {'，'.join(one.zh for one in its)}。"
        "二者不符，以后者为准。",
        f"Beware: the count gives {', '.join(one.en for one in ours)}, the rank of the constraint equations "
        f"{', '.join(one.en for one in its)}. They disagree; the latter holds.",
    )


def _counted(answer: Answer, size: float) -> Words:
    """F = 1; the motion is determined: no."""
    if answer.reading.unit != YES_NO:
        return Words.same(f"${answer.reading.symbol}$ = {number(size)}")
    return Words(
        f"{called('', answer.key, 'zh')}：{value(size, YES_NO, 'zh')}",
        f"{called('', answer.key, 'en')}: {value(size, YES_NO, 'en')}",
    )


def _coriolis(answer: Answer) -> Words:
    symbol = f"${answer.reading.symbol}$"
    return Words(f"存在哥氏加速度 {symbol}。", f"A Coriolis acceleration {symbol} exists.")


_WITHIN = str.maketrans({"（": "，", "）": None, "(": "– ", ")": None})  # of a title that stands in brackets


def scales(solution: Solution, lang: Lang) -> str:
    """μ_l = 0.001 m/mm, ...; each scale once, block diagrams have none."""
    figures = [figure for figure in solution.construction.figures if figure.scale.symbol and figure.scale.value]
    parts = dict[str, str]()  # what a diagram's own are for is told once, after the last of them
    for figure in figures:
        own = [figure.scale] if figure.scale.across is None else [figure.scale, figure.scale.across]
        told = [f"${scale.symbol}$ = {number(scale.told.value)} {scale.told.per_mm}" for scale in own]
        title = _begun(figure.title.of(lang)).translate(_WITHIN)
        named = (f"（{title}）" if lang == "zh" else f" ({title})") if len(own) > 1 else ""
        new = [text for text in told if text not in parts]
        parts |= dict.fromkeys(new, "")
        if new:
            parts[new[-1]] = named
    return ("，" if lang == "zh" else ", ").join(f"{text}{named}" for text, named in parts.items())


def _begun(title: str) -> str:
    """A title within a sentence."""
    return title[:1].lower() + title[1:] if title[1:2].islower() or title[1:2] == " " else title
