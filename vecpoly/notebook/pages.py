"""What Jupyter shows: a problem with its sketch, a solution with its answers and sheet,
a construction with its steps and figures."""

from __future__ import annotations

from html import escape

from ..board.construction import Construction, Step
from ..board.said.told import told
from ..drawing.backends.svg import to_svg
from ..drawing.figure import draw_figure
from ..drawing.scene import Scene
from ..drawing.sheets.sheet import sheets
from ..problem.problem import Problem
from ..report.answers.line import answer_line
from ..report.answers.tables import readings_tables
from ..report.content import cautions, statement
from ..report.picture import picture
from ..solution import Solution, solve
from ..words import Lang, Words, label
from .markup import equation, formula, paragraph, sentence, table

SIZE = (140.0, 100.0)  # mm
PAPER = "background:white;color:black;overflow-x:auto"  # a sheet is white, whatever the notebook's colours
_GIVEN, _ASKED = Words("已知：", "Given: "), Words("求：", "Asked: ")
_ACTS = Words("各步的作图动作", "The acts of every step")


def problem_svg(problem: Problem, lang: Lang) -> str:
    """The sketch of a problem as SVG, nothing solved yet; where it has none, the first figure of its solution."""
    return _sketch(problem, solve(problem, by="exact", repeats=0, precise=False).construction, lang)


def solution_svg(solution: Solution, lang: Lang) -> str:
    """The first sheet as SVG."""
    return _sheets(solution, lang)[0]


def problem_html(problem: Problem, lang: Lang) -> str:
    """Title, statement, what is given and asked, and the sketch."""
    unsolved = solve(problem, by="exact", repeats=0, precise=False)
    said = statement(unsolved, lang)
    told_of = [
        paragraph(said["statement"]),
        paragraph(_GIVEN.of(lang) + said["given"] if said["given"] else ""),
        paragraph(_ASKED.of(lang) + said["asked"]),
    ]
    return f"{_title(problem, lang)}{''.join(told_of)}{_paper(_sketch(problem, unsolved.construction, lang))}"


def solution_html(solution: Solution, lang: Lang) -> str:
    """The answers as drawn and exact, what is to be said of them, and the sheets."""
    lines = (answer_line(one, solution, lang) for one in solution.answers.values())
    ended = "".join(f"<div>{sentence(one.before)} {formula(one.node)} {sentence(one.after)}</div>" for one in lines)
    read = "".join(table(one.header, one.rows, one.align) for one in readings_tables(solution, lang))
    warning = solution.construction.warning
    red = f'<p style="color:#b00020"><b>{sentence(warning.of(lang))}</b></p>' if warning else ""
    none = solution.construction.conclusion
    told_of = [*([none.of(lang)] if none is not None else []), *cautions(solution, lang)]
    said = "".join(map(paragraph, told_of))
    papers = "".join(map(_paper, _sheets(solution, lang)))
    return f"{_title(solution.problem, lang)}{red}{ended}{read}{said}{papers}"


def construction_html(construction: Construction, lang: Lang) -> str:
    """The steps, each with its equation and formulas, the acts folded away, and the figures."""
    drawn = "".join(_paper(_svg(draw_figure(one, lang=lang), one.title, lang)) for one in construction.figures)
    listed = escape(told(construction.steps, construction.acts, lang))
    acts = f"<details><summary>{_ACTS.of(lang)}</summary><pre>{listed}</pre></details>"
    return f"<ol>{''.join(_step(step, lang) for step in construction.steps)}</ol>{acts}{drawn}"


def _step(step: Step, lang: Lang) -> str:
    written = equation(step.equation, lang) if step.equation else ""
    formulas = "".join(f"<div>{formula(one)}</div>" for one in step.formulas)
    listing = step.listing
    head = () if listing is None else tuple(one.of(lang) for one in listing.head)
    listed = "" if listing is None else table(head, listing.rows, "c" * len(head))
    return f"<li>{sentence(step.words.of(lang))}{written}{formulas}{listed}</li>"


def _sketch(problem: Problem, drawn: Construction, lang: Lang) -> str:
    figure = picture(problem, drawn, *SIZE) or drawn.figures[0]
    return _svg(draw_figure(figure, lang=lang, caption=False), problem.title, lang)


def _svg(scene: Scene, title: Words, lang: Lang) -> str:
    """A figure with white around it."""
    return to_svg(Scene(scene.items, scene.extents.grown(4.0)), title.of(lang), outlined=True)


def _sheets(solution: Solution, lang: Lang) -> list[str]:
    title = solution.problem.title
    pages = sheets(solution.construction, lang=lang, title=title, on=solution.problem.paper)
    return [to_svg(page.scene, title.of(lang), outlined=True) for page in pages]


def _title(problem: Problem, lang: Lang) -> str:
    name = label(problem.id).of(lang)
    return f"<h4>{escape(f'{name}　' if name else '')}{sentence(problem.title.of(lang))}</h4>"


def _paper(svg: str) -> str:
    return f'<div style="{PAPER}">{svg}</div>'
