"""vecpoly solve: the answers in the terminal, or as JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from ...words import Words, bare
from ..errors import Tally, about
from ..files import STDOUT, spared, write_json
from ..jobs import problems
from ..onward import ThenOption
from ..options import JSON, HandOption, JsonOption, Lang, LangOption, OutsideOption, Problems, SeedOption
from ..terminal import add, progress, say, show, table, warn
from ..wording import drawn, exact, gap, reach, symbol, unit, way

if TYPE_CHECKING:
    from ...answer import Answer
    from ...solution import Solution

_COLUMNS = {
    "zh": ("量", "量得", "精确", "单位", "偏差", "预期误差", "方向", "图上 mm"),
    "en": ("symbol", "drawn", "exact", "unit", "deviation", "expected", "direction", "mm"),
}
_HANDS = {
    "exact": {"zh": "精确作图", "en": "exact hand"}, "drafting": {"zh": "绘图仪器", "en": "drafting hand"},
    "pencil": {"zh": "铅笔手绘", "en": "pencil hand"},
}  # fmt: skip

ActsOption = Annotated[
    bool, typer.Option("--acts", help="List the steps of the construction too, and what the hand did in each.")
]


def solve(
    names: Problems,
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    json: JsonOption = None,
    lang: LangOption = "en",
    allow_outside: OutsideOption = False,
    acts: ActsOption = False,
    then: ThenOption = None,
) -> None:
    """Print the answers: as drawn, exact, and how far off."""
    tally = Tally()
    found = problems(names, tally, allow_outside)
    spared(json, JSON, found)
    from ...board.said.told import told
    from ...solution import solve as solved

    solutions: list[Solution] = []
    for problem in progress(found, Words("求解", "solving")):
        with tally.job(), about(problem):
            solutions.append(solved(problem, by=hand, seed=seed))
            if then == "analyse":
                solutions.append(solved(solutions[-1].linkage, by=hand, seed=seed))
    for solution in solutions:
        tally.weigh(solution.problem.id, solution.construction.warning, lang, solution.construction.conclusion)
        if json != STDOUT:
            _print(solution, lang)
            if acts:
                typer.echo(told(solution.construction.steps, solution.construction.acts, lang) + "\n")
        warn(solution.problem.id, solution.warnings, lang)
    if json is not None and solutions:
        data = [solution.as_json() for solution in solutions]
        write_json(data if len(data) + len(tally.failed) > 1 else data[0], json)
    tally.settle()


def _print(solution: Solution, lang: Lang) -> None:
    from ...problem.asked.hints import nothing_asked
    from ...solution import fewer_digits, told_short

    problem = solution.problem
    title = f"{problem.id}  {bare(problem.title.of(lang))}  ({_HANDS[solution.construction.hand][lang]})"
    left = {0, 3, 6}
    made = table(title, [(name, "left" if i in left else "right") for i, name in enumerate(_COLUMNS[lang])])
    for answer in solution.answers.values():
        mm = answer.reading.mm
        add(
            made,
            (
                symbol(answer.key),
                drawn(answer, lang),
                exact(answer, lang),
                unit(answer),
                gap(answer),
                reach(answer),
                way(answer, lang),
                "—" if mm is None else f"{mm:.2f}",
            ),
            alarmed=answer.suspect is not None,
        )
    if solution.answers:
        show(made)
    for answer in solution.answers.values():
        if answer.short:
            typer.echo(f"{symbol(answer.key)}: {told_short(answer).of(lang)}")
        if answer.reading.acts is not None and answer.reading.acts.couple is not None:
            typer.echo(bare(_passed_on(answer).of(lang)))
        elif (remark := answer.reading.remark) is not None:
            typer.echo(f"{symbol(answer.key)}: {bare(remark.of(lang)).strip('（）() ')}")
    if not problem.asks:
        say(f"{problem.id}: {nothing_asked(problem).of(lang)}")
    if (few := fewer_digits(solution)) is not None:
        say(bare(few.of(lang)))
    _print_verified(solution, lang)


def _print_verified(solution: Solution, lang: Lang) -> None:
    """What the linkages of a synthesis do, moved by the exact solver; why other candidates are none."""
    if not solution.verification:
        return
    from ...found import rejections  # late, as what follows: a synthesis alone needs it

    if (others := rejections(solution.construction.candidates)) is not None:
        typer.echo(bare(others.of(lang)))
    from ...check.designs.found_words import ill_conditioned, told  # late: a whole cycle, which other problems need not
    from ...check.designs.several import several_of
    from ...check.truth import truth_of

    alone, given = len(solution.verification) == 1, solution.problem.design.is_given
    for one in solution.verification:
        for words in (told(one, alone, given=given), ill_conditioned(one, alone)):
            if words is not None:
                typer.echo(bare(words.of(lang)))
    if (several := several_of(solution.problem, truth_of(solution.problem))) is not None:
        say(f"{solution.problem.id}: {several.of(lang)}")


def _passed_on(answer: Answer) -> Words:
    """The couple beside a reaction that is zero, as drawn and exact."""
    acts, truth = answer.reading.acts, answer.exact_acts
    couple, exactly = acts.couple if acts else None, truth.couple if truth else None
    told = f"{couple or 0.0:.5g} N·m" + ("" if exactly is None else f" ({exactly:.5g})")
    return Words(
        f"{answer.key} = 0，移动副只传递力偶 {told}，逆时针为正，括号内为精确值",
        f"{answer.key} = 0: the slide passes on a couple alone, {told}, counter-clockwise positive, the exact "
        "value in brackets",
    )
