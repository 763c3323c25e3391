"""The page: Jinja2 joins steps, figures, motion, fonts, style and script into one HTML file that loads nothing."""

from __future__ import annotations

import json
import re
from typing import Any, NamedTuple

from ..foundation.arguments import known_language, of_kind
from ..foundation.data import data_dir
from ..report.content import statement
from ..report.templates import filled
from ..solution import Solution
from ..typeset.fonts import Face
from ..typeset.words import is_han
from ..words import Lang, Words, label
from .beats import beats, stepped
from .figures import LANGS, Shown, shown_figures
from .motion import moving
from .pointing import pointed
from .readings import names, readings, ways_heard
from .setting.faces import font_css
from .setting.ink import Ink
from .setting.type import html, words_html
from .steps import sections
from .traces import curves
from .turned import Cycle, cycle

PLACES = 36  # of the drive, over the cycle; the script draws what lies between them
LIMIT = 1_000_000  # bytes: a page that would be larger has every second place only
GAP = 800  # units between figures one under the other
_HEADINGS = re.compile(r"<(h1|h2|button|summary|thead|output)\b.*?</\1>", re.S)  # what is set in Hei

_HEARD = re.compile(r' (?:aria-label|data-(?:say-)?(?:zh|en))="[^"]*"')  # what is read out, and not set in type

_ASIDE = re.compile(r"^ *//.*\n|^ +", re.M)  # comments and indents of the script: for those who change it


class Page(NamedTuple):
    """One HTML document, and the warning in it:
    what of the steps or of any place of the drive must not be taken for right."""

    html: str
    warning: Words | None


def player_html(
    solution: Solution, *, lang: Lang = "zh", places: int = PLACES, seed: int = 0, check: bool = False
) -> str:
    """The player of a solved problem as one HTML document."""
    return player(solution, lang=lang, places=places, seed=seed, check=check).html


def player(solution: Solution, *, lang: Lang = "zh", places: int = PLACES, seed: int = 0, check: bool = False) -> Page:
    """The player of a solved problem: its steps, and its figures at `places` places of the drive; check: with a box in
    which one's own answers are checked.

    A page that would be larger than a megabyte has every second place only.
    """
    known_language(lang)
    of_kind(solution, Solution, Words("解答（solve 的结果）", "a solution, as solve gives it,"))
    through = cycle(solution, places, seed=seed)
    while len((page := _page(solution, through, lang, check)).html.encode()) > LIMIT and len(through.turns) > 1:
        through = through.thinned()
    return page


def _page(solution: Solution, through: Cycle, lang: Lang, check: bool) -> Page:
    """The page with these places of the drive."""
    ink, cut = Ink(), beats(solution.construction)
    turning = len(through.turns) > 1
    title, warning = _title(solution), _warning(solution, through)
    context: dict[str, Any] = {
        "lang": lang,
        "name": title.plain,
        "title": html(title, ink.faces),
        "warning": html(warning, ink.faces) if warning else None,
        "problem": _problem(solution, ink),
        "sections": sections(solution.construction.steps, cut, ink.faces, lang),
        "count": len(cut),
        "beats": _json(pointed(solution.construction, cut)),
        "figures": _stacked(shown_figures(stepped(solution.construction), ink)),
        "turning": turning,
        "slides": turning and not through.inverts and solution.problem.mechanism.drive.slide,
        "inverts": through.inverts,
        "names": names(through.turns[0].solution if through.inverts else solution, ink.faces) if turning else (),
        "drive": _drive(solution, ink) if turning else "",
        "box": None,
        "motion": _motion(through, solution, ink) if turning else "",
    }
    if check:
        from .questions import box  # late: all of the grading, which few pages need

        context["box"] = box(solution.problem, ink.faces)
    return Page(_rendered(context | {"definitions": ink.definitions(), "looks": ink.css()}, ink), warning)


def _rendered(context: dict[str, Any], ink: Ink) -> str:
    """The filled template, with just the characters that stand in it as fonts."""
    folder = (data_dir("templates") / "player",)
    plain = _HEARD.sub("", filled("page.html.j2", folder, context | {"fonts": ""}, escaped=False))
    ink.faces.take(plain)
    ink.faces.need(Face.HEI, "".join(char for part in _HEADINGS.finditer(plain) for char in part[0] if is_han(char)))
    page = filled("page.html.j2", folder, context | {"fonts": font_css(ink.faces.used)}, escaped=False)
    head, script, rest = page.rpartition("<script>")
    return head + script + _ASIDE.sub("", rest)


def _motion(through: Cycle, solution: Solution, ink: Ink) -> str:
    """Figures and readings at all places, as data for the script."""
    drawn = solution.construction
    return _json(
        {
            "shown": [turn.shown for turn in through.turns],
            "start": through.start,
            "all": through.whole,
            "round": through.round,
            "readings": readings(through.turns, ink.faces),
            "aloud": ways_heard(through.turns),
            "curves": curves(through.turns),
            "figures": moving(through, through.turns[0].solution.construction if through.inverts else drawn, ink),
        }
    )


def _title(solution: Solution) -> Words:
    name, title = label(solution.problem.id), solution.problem.title
    return Words(f"{name.zh}　{title.zh}".strip(), f"{name.en}: {title.en}" if name.en else title.en)


def _problem(solution: Solution, ink: Ink) -> list[tuple[Words, Words]]:
    """Statement, what is given, what is asked, the scales: each with its heading."""
    said = {lang: statement(solution, lang) for lang in LANGS}
    heads = {
        "statement": Words("", ""),
        "given": Words("已知：", "Given: "),
        "asked": Words("求：", "Find: "),
        "scales": Words("比例尺：", "Scales: "),
    }
    return [
        (head, html(Words(said["zh"][key], said["en"][key]), ink.faces))
        for key, head in heads.items()
        if said["zh"][key]
    ]


def _warning(solution: Solution, through: Cycle) -> Words | None:
    """The alarm of the solution itself, or of the first place of the drive that has one."""
    solutions = (solution, *(turn.solution for turn in through.turns))
    return next((one.construction.warning for one in solutions if one.construction.warning), None)


def _drive(solution: Solution, ink: Ink) -> str:
    """The symbol of the drive's datum; of a cam that is designed that of its angle."""
    given = solution.problem.given.motion
    return words_html(f"${given[0].symbol if given else 'φ'}$", ink.faces)


def _stacked(figures: tuple[Shown, ...]) -> list[tuple[Shown, int, int]]:
    """Each figure with where it stands as long as no script has placed it: one under the other."""
    out, down = [], 0
    for one in figures:
        x, y, _, height = one.box
        out.append((one, -x, down - y))
        down += height + GAP
    return out


def _json(data: object) -> str:
    """Data inside a script element, in which `</` must not stand."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")
