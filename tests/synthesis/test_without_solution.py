"""A synthesis of which every candidate is rejected: drawn all the same, concluded, told with a code of its own."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

import vecpoly
from tests.grading.cases import TWO_SOLUTIONS
from tests.laws import few
from vecpoly.board.paper.marks import Role, Segment
from vecpoly.check.designs.admissible import admissible
from vecpoly.check.truth import exact_values
from vecpoly.cli.app import app
from vecpoly.cli.errors import REFUSED, UNSOLVABLE
from vecpoly.designs.base import Design
from vecpoly.designs.ranged.admitted import between
from vecpoly.designs.ranged.datum import of_field
from vecpoly.errors import AssemblyError, NotAskedError, VecpolyError
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.oracle.synthesis.registry import linkages, solvable
from vecpoly.report.content import Objects
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.content import question

POSES = '"(13, 69) mm at 41 deg", "(93, 16) mm at 30 deg"'
NONE = {  # data of each method that can reject all it finds, and what is asked
    "by AD": ("crank-rocker", "{K: 1.568, CD: 60 mm, swing: 73 deg, AD: 123.6 mm}", "theta, AB, BC"),
    "by AB": ("crank-rocker", "{K: 1.361, CD: 60 mm, swing: 79 deg, AB: 10.1 mm}", "theta, AB, BC, AD"),
    "by a limit": ("crank-rocker", "{K: 1.517, CD: 75 mm, AD: 123.9 mm, ADC: 145 deg}", "theta, AB_1, BC_1, AB_2"),
    "by the offset": ("slider-crank", "{K: 1.664, H: 50 mm, e: 50.7 mm}", "theta, AB, BC, alpha_max"),
    "by lines": (
        "limit-lines",
        '{C1: "(0, 0) mm", line_1: 14 deg, C2: "(35, 11) mm", line_2: 238 deg, alpha_1: 36 deg}',
        "theta, AB, BC",
    ),
    "by a dead centre": (
        "dead-centre",
        "{AD: 100 mm, CD: 60 mm, psi_1: 318 deg, psi_2: 130 deg, phi_12: 3 deg}",
        "AB, BC",
    ),
    "by half a turn": ("drag-link", "{AD: 25 mm, AB: 60 mm, K: 1.329, phi_1: 126 deg, psi_1: 194 deg}", "BC, CD"),
    "by pairs": (
        "function-generator",
        "{AD: 80 mm, pairs: [159 deg -> 65 deg, 91 deg -> 176 deg, 166 deg -> 135 deg]}",
        "AB, BC, CD",
    ),
    "by a function": (
        "function-generator",
        "{AD: 100 mm, function: log10(x), x: [1, 2], phi: [194 deg, 278 deg], psi: [52 deg, 293 deg]}",
        "AB, BC, epsilon_max",
    ),
    "by two positions": (
        "positions",
        '{poses: ["(0, 0) mm at 0 deg", "(26, 38) mm at 46 deg"], frame: {A: [10 mm, -12 mm], D: [3 mm, -30 mm]}, '
        "B: on x = -79 mm, C: on y = 39 mm}",
        "AB, BC, CD, AD",
    ),
    "by three positions": (
        "positions",
        f'{{poses: ["(0, 0) mm at 0 deg", {POSES}], body: {{B: [0 mm, -5 mm], C: [46 mm, 9 mm]}}}}',
        "AB, BC, CD, AD",
    ),
    "by four positions": (
        "positions",
        '{poses: ["(0, 0) mm at 0 deg", "(56, 63) mm at 31 deg", "(28, 43) mm at 18 deg", "(52, 48) mm at 87 deg"], '
        "A: on y = -50 mm, D: on y = -50 mm}",
        "AB, BC, CD, AD",
    ),
    "by angles": (
        "angle-pairs",
        "{AB: 30 mm, AD: 60 mm, pairs: [159 deg -> 65 deg, 91 deg -> 176 deg, 166 deg -> 135 deg]}",
        "BC, CD, delta_C",
    ),
    "by places of a slider": (
        "angle-pairs",
        "{guide: on y = -10 mm, pairs: [26 deg -> 78 mm, 146 deg -> 62 mm, 63 deg -> 34 mm], onto: 3}",
        "AB, BC",
    ),
    "by stages": (
        "stages",
        "{frame: {A: [0 mm, 0 mm], D: [30 mm, 0 mm]}, rays: {AB: [28 deg, 95 deg], DC: [125 deg, 0 deg]}, "
        'points: {E: ["(90, 0) mm", "(150, 0) mm"]}, '
        "stages: [{find: C, on: DC, from: E}, {find: B, on: AB, from: C}]}",
        "DC, CE, AB, BC",
    ),
}
RANGED = (
    *("by AD", "by AB", "by a limit", "by the offset", "by lines", "by a dead centre", "by half a turn"),
    *("by two positions", "by places of a slider", "by a function", "by three positions", "by stages"),
)


def text(name: str) -> str:
    """The problem file."""
    kind, data, find = NONE[name]
    return f"id: none\ntitle: {{zh: 无解, en: None}}\nsynthesis: {kind}\ndata: {data}\nfind: [{find}]\n"


def design_of(problem: vecpoly.Problem) -> Design:
    assert isinstance(problem.subject, Design)
    return problem.subject


@pytest.mark.parametrize("name", few(tuple(NONE), 4))
def test_every_rejected_candidate_is_drawn_and_the_conclusion_tells_them_all(name: str) -> None:
    problem = vecpoly.loads(text(name))
    solution = problem.solve(by="exact")
    drawn, ended = solution.construction, solution.construction.conclusion
    assert not solution.suspect and not solution.verification and ended is not None
    assert [one.verdict for one in drawn.candidates] == [one.verdict.name for one in linkages(design_of(problem))]
    marks = [mark for figure in drawn.figures for mark in figure.marks]
    assert sum(isinstance(one, Segment) and one.role is Role.HIDDEN for one in marks) >= len(drawn.candidates)
    for one in drawn.candidates:
        assert one.reason is not None and one.reason.zh in ended.zh and one.reason.en in ended.en
    assert drawn.steps[-1].section.en == "Conclusion"
    assert solution.as_json()["conclusion"]["en"].startswith("No linkage satisfies the conditions.")


@pytest.mark.parametrize("name", few(tuple(NONE), 4))
def test_answers_are_what_the_data_alone_tell(name: str) -> None:
    problem = vecpoly.loads(text(name))
    solution, known = problem.solve(by="drafting"), design_of(problem).settled()
    assert set(solution.answers) == {ask.rel.key for ask in problem.asks} & set(known)
    for key, answer in solution.answers.items():
        assert math.isclose(answer.drawn, known[key], rel_tol=1e-12) and answer.exact == known[key]


@pytest.mark.parametrize("name", RANGED)
def test_within_the_range_told_there_is_a_solution_and_beyond_its_ends_none(name: str) -> None:
    problem = vecpoly.loads(text(name))
    told = admissible(design := design_of(problem))
    assert told is not None
    said, ranges = re.fullmatch(r" With all else as it is, (.+) may be (.*)\.", told.en).groups()  # type: ignore[union-attr]
    fields = {datum.name.en: named.key for named in design.ranged if (datum := of_field(design, named))}
    key = fields.get(said, said)
    unit = ranges.split()[-1]
    for part in ranges.split(" or "):
        ends = [float(end) for end in re.findall(r"-?\d+(?:\.\d+)?", part)]
        inner = (ends[0] + ends[-1]) / 2 if len(ends) == 2 else ends[0] / 2 if "least" not in part else 2 * ends[0]
        inner = 2 * ends[0] if "most" in part and ends[0] < 0 else inner
        assert all(_solves(name, key, value, unit) for value in (*ends, inner) if value not in (0, 360))
        low, high = (ends[0], ends[-1]) if len(ends) == 2 else (None, ends[0])
        for end, way in ((low, -1), (high, 1)):
            if end is not None and end not in (0, 360) and not (key == "alpha_1" and way > 0):
                assert not _solves(name, key, end + way * 10.0 ** (math.floor(math.log10(abs(end))) - 2), unit)


@pytest.mark.parametrize("name", RANGED)
def test_a_datum_that_had_to_be_another_is_called_by_its_symbol_or_in_words(name: str) -> None:
    design = design_of(vecpoly.loads(text(name)))
    given = {symbol for symbol, _ in design.given()}
    for datum in design.varied():
        assert re.findall(r"\$(.+?)\$", datum.name.en) == re.findall(r"\$(.+?)\$", datum.name.zh)
        assert datum.name.en.startswith("the ") or datum.name.en.strip("$") in given, datum.name


def _solves(name: str, key: str, value: float, unit: str) -> bool:
    """With another value of a key in the file, or of what has no key of its own."""
    if key.isidentifier():
        written = re.sub(rf"(\b{key}: (?:on [xy] = )?)-?[\d.]+ {unit}", rf"\g<1>{value:.10f} {unit}", text(name))
    else:
        written = re.sub(*_PLACES[key], text(name), count=1).replace("VALUE", f"{value:.10f} {unit}")
        assert written != text(name)
    try:
        return solvable(design_of(vecpoly.loads(written)))
    except VecpolyError:
        return False


_PLACES = {  # what is told of, as it stands in the file
    "the x of B": (r"B: \[[^,]*,", "B: [VALUE,"),
    "the x of D": (r"D: \[[^,]*,", "D: [VALUE,"),
    "the end of psi": (r"psi: \[([^,]*), [^\]]*\]", r"psi: [\1, VALUE]"),
}


def test_ends_of_a_range_are_rounded_to_where_there_is_a_linkage() -> None:
    told = between([(51.2961, 86.3789), (-math.inf, -0.123456), (99999.9, math.inf)], "mm")
    assert told.en == "at most -0.1235 mm or 51.3 to 86.37 mm or at least 100000 mm"
    assert between([(1.656, 50.93), (25.57, 50.93)], "mm").en == "1.656 to 50.93 mm"
    assert between([(97.7252, 97.7268)], "mm").en == "97.726 to 97.726 mm"
    assert between([(97.72512, 97.72586)], "mm").en == "97.7252 to 97.7258 mm"


@pytest.mark.parametrize("name", ["by AB", "by four positions", "by angles"])
def test_a_question_does_not_give_away_that_there_is_no_solution(name: str) -> None:
    problem = vecpoly.loads(text(name))
    solution = problem.solve(by="exact").toned({})
    asked = {solution.construction.readings[ask.rel.key].symbol for ask in problem.asks}
    rows = {row[0].split(",")[0].split("，")[0].strip("$") for row in empty_table(solution, "en").rows}
    assert asked <= {row.split("$")[-1] for row in rows}
    assert question(solution, solution.construction, "en", Objects())["working"]


def test_data_of_which_nothing_meets_are_refused_with_the_range() -> None:
    far = vecpoly.loads(text("by the offset").replace("50.7 mm", "90 mm"))
    with pytest.raises(AssemblyError, match="e may be at most"):
        far.solve(by="exact")


def test_nothing_goes_on_from_no_linkage() -> None:
    problem = vecpoly.loads(text("by AD"))
    with pytest.raises(NotAskedError, match="all candidates of problem none are rejected"):
        _ = problem.solve(by="exact").linkage
    with pytest.raises(VecpolyError, match="no key to grade by: No linkage"):
        answer_key(problem)


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_commands_write_their_sheets_and_end_with_a_code_of_their_own(lang: str, tmp_path: Path) -> None:
    file = tmp_path / "none.yaml"
    file.write_text(text("by a limit"), encoding="utf-8")
    run = CliRunner().invoke
    said = {"zh": "没有机构满足所给条件。", "en": "No linkage satisfies the conditions."}[lang]
    for command, end in (
        ("solve", ""),
        ("exact", ""),
        ("draw", "svg"),
        ("report", "pdf"),
        ("report", "question.pdf"),
        ("play", "html"),
    ):
        path = tmp_path / f"x.{end}"
        style = ["--style", "question"] if end.startswith("question") else []
        result = run(app, [command, str(file), "--lang", lang, *(["-o", str(path)] if end else []), *style])
        assert result.exit_code == UNSOLVABLE == 4 and said in result.output, (command, result.output)
        assert not end or path.stat().st_size > 1000
    gone_on = run(app, ["solve", str(file), "--then", "analyse"])
    assert gone_on.exit_code == REFUSED and "all candidates" in gone_on.output


def test_a_solution_that_is_asked_for_beyond_those_there_are_is_refused_with_how_many_there_are() -> None:
    with pytest.raises(NotAskedError, match="BC_3: there are only 2 valid solutions") as refused:
        exact_values(vecpoly.loads(TWO_SOLUTIONS.replace("[BC, AD]", "[BC_3]")))
    assert refused.value.code == "no-solution" and refused.value.numbers == {"solutions": 2}


@pytest.mark.parametrize("height", [10.0, 1e3 * 0.06 * math.cos(math.radians(25)), 90.0])
def test_with_k_of_one_a_level_line_for_a_is_refused_with_the_upright_ones_that_serve(height: float) -> None:
    """A lies on C₁C₂, which is level: the range told was from 54.378467223 to 54.378467222 mm."""
    data = {"K": "1", "CD": "60 mm", "swing": "50 deg"}
    with pytest.raises(AssemblyError, match=r"which a level line is parallel to.*\|x\| must be more than") as refused:
        _posed(data | {"A": f"on y = {height} mm"}).solve(by="exact")
    half = 1e3 * float(refused.value.numbers["half"])
    for side in (1, -1):
        assert (
            _posed(data | {"A": f"on x = {side * (half + 0.1)} mm"}).solve(by="exact").construction.conclusion is None
        )
        assert _posed(data | {"A": f"on x = {side * (half - 0.1)} mm"}).solve(by="exact").construction.conclusion


def _posed(data: dict[str, str]) -> vecpoly.Problem:
    return vecpoly.problem({"id": "t", "title": "t", "synthesis": "crank-rocker", "data": data, "find": ["AB", "BC"]})
