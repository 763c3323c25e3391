"""Numbers that stand in several lines: alike in all; one count of decimals where they are read to one scale."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from tests.drawn_library import DRAFTED, IDS, drafted, drawn
from tests.each import each
from vecpoly.algebra.formula import Row, plain, sym
from vecpoly.printed.alike import of_both
from vecpoly.printed.digits import drawn_number
from vecpoly.printed.lengths import is_length
from vecpoly.problem.load import load, loads
from vecpoly.solution import Solution, solve

WORKED = 4  # parts of a line symbol = formula = numbers = result
FINE = 5  # figures that a hand writes of what it read, at most


def lines_of(solution: Solution) -> list[list[str]]:
    """The parts of every line of the steps that is worked out; of 1.968 m = 1968 mm what goes on, in mm."""
    every = (
        re.sub(r" = \S+ m(?= = \S+ mm$)", "", plain(one)).replace("\u2009", " ")
        for step in solution.construction.steps
        for one in step.formulas
    )
    return [parts for parts in (line.split(" = ") for line in every) if len(parts) == WORKED]


@each((*DRAFTED, "8-18", "function-log", "8-15"))
def test_what_is_read_has_the_figures_of_its_reading_three_at_least_and_one_more_after_a_leading_one(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        line, mm = answer.reading.formula, answer.reading.mm
        if not (isinstance(line, Row) and is_length(line) and mm) or answer.is_place or answer.computed:
            continue
        told = drawn_number(answer).lstrip("−")
        read, figures = f"{abs(mm):.1f}".replace(".", "").lstrip("0"), told.replace(".", "").lstrip("0")
        most = min(4, max(3, len(read)) + figures.startswith("1"))
        whole = "." not in told  # told to its ones, whatever was read
        midway = figures.endswith("5")  # the one figure more is the value itself
        assert whole or len(figures) <= most + midway, f"{answer.key} = {told} from {mm:.1f} mm"


def test_the_force_in_a_joint_has_one_number_by_whichever_links_it_is_called() -> None:
    told = {parts[0]: parts for parts in lines_of(solve(load("cam-roller-load"), repeats=0, precise=False))}
    number = told["R_12,0"][-1].removesuffix(" N")
    assert float(number) == pytest.approx(412.6, rel=2e-3) and told["M_0"][2].startswith(f"{number} × ")
    assert of_both(sym("R_{21,0}")) == of_both(sym("R_{12,0}")) == sym("R_{12,0}")
    assert of_both(sym("R_{31}")) != of_both(sym("R_{21}")) and of_both(sym("r_{21}")) == sym("r_{21}")


@pytest.mark.parametrize(
    ("name", "scale", "symbol", "end"),
    [("3-10", "0.0015 m/mm", "l_CB", "0.11205 m"), ("A-27", "", "ω_2", "14.486 rad/s")],
)
def test_a_number_that_is_not_asked_has_the_figures_that_later_lines_need_up_to_five(
    name: str, scale: str, symbol: str, end: str
) -> None:
    text = load(name).text
    problem = loads(f"{text}\nscales: {{mu_l: {scale}}}\n") if scale else load(name)
    ends = [parts[-1] for parts in lines_of(solve(problem)) if parts[0] == symbol]
    assert ends == [end]


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("A-26", "a^n_CB = ω_2^2 l_BC = 2.81^2 × 0.2 = 1.579 m/s^2"),
        ("geared-five-bar", "a^n_CB = ω_2^2 l_BC = 3.03^2 × 0.12 = 1.102 m/s^2"),
    ],
)
def test_an_answer_has_one_number_and_what_goes_on_with_it_is_what_that_number_gives(name: str, line: str) -> None:
    assert line in [" = ".join(parts) for parts in lines_of(solve(load(name)))]


@each(DRAFTED)
def test_what_is_laid_off_is_divided_as_it_is_printed(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    ends = {parts[0]: parts[-1].split(" ")[0] for parts in lines_of(solution)}
    asked = {re.sub(r"[{}]", "", one.reading.symbol) for one in solution.answers.values()}
    for parts in lines_of(solution):
        of, scale = parts[1].strip("()").split(")/(") if parts[1].count(")/(") == 1 else ("", "")
        if scale.startswith("μ_") and of in ends and of not in asked:
            assert parts[2].startswith(f"({ends[of]})"), f"{of} = {ends[of]}: {' = '.join(parts)}"


@each((*IDS, "excavator-boom", "offset-slide-drives", "given-speed-of-an-equivalent-slide"))
def test_no_size_is_measured_on_a_polygon_where_it_was_laid_off(name: str) -> None:
    laid = set[str]()
    for line in (plain(one) for step in drawn(name).construction.steps for one in step.formulas):
        symbol, _, worked = line.partition(" = ")
        formula = worked.split(" = ")[0]
        measured = formula.lstrip("(").startswith("μ_")  # a ratio v_B/ω_1, too
        assert symbol.partition("/")[0] not in laid or not measured, line
        if (size := re.fullmatch(r"\((\S+)\)/\(μ_\S+\)", formula)) is not None:
            laid.add(size[1])


def test_what_later_lines_go_on_with_to_more_figures_than_it_is_answered_is_told_so_where_it_is_found() -> None:
    lines = lines_of(solve(load("elliptic-trammel")))
    (turns,), (normal,) = ([parts for parts in lines if parts[0] == symbol] for symbol in ("ω_2", "a^n_BA"))
    assert turns[-1] == "3.126 rad/s ≈ 3.13 rad/s" and normal[2] == "3.126^2 × 0.2"


@each((*DRAFTED, "4-5"))
def test_no_answer_goes_on_with_more_figures_of_another_than_a_hand_writes_of_what_it_read(name: str) -> None:
    """η = 6.74/10.49 = 0.6425 rather than 6.74/10.4904 = 0.642: what lies midway has the one figure more."""
    solution = drafted(name)
    answers = [] if solution is None else [one for one in solution.answers.values() if not one.computed]
    for one in answers:
        line = one.reading.formula
        parts = plain(line).split(" = ") if isinstance(line, Row) else []
        for number in re.findall(r"\d+\.\d+", parts[2]) if len(parts) == WORKED else ():
            of_another = any(float(number) == pytest.approx(abs(other.drawn), rel=1e-4) for other in answers)
            assert not of_another or len(number.replace(".", "").lstrip("0")) <= FINE, " = ".join(parts)


@pytest.mark.parametrize(("key", "told"), [("v_B3", "11.96"), ("v_B3B2", "32.6")])
@pytest.mark.parametrize("error", [0.02, 0.1, 0.45])
def test_an_answer_has_three_figures_and_four_after_a_leading_1_however_far_it_may_be_off(
    key: str, told: str, error: float
) -> None:
    """Of fewer the rounding would look like a deviation of the drawing: 0.0245 m/s told as 0.024 is 2 % off."""
    answer = solve(load("3-14")).answers[key]
    assert drawn_number(replace(answer, expected_error=error * answer.drawn)) == told


@pytest.mark.parametrize(
    ("name", "symbol", "number"),
    [("hoist", "ω_1", "100.53"), ("hoist", "α_1", "251.15"), ("7-4", "J_F", "80.52"), ("4-6", "l_DB", "0.2055")],
)
def test_a_number_has_one_form_where_it_is_found_and_where_lines_go_on_with_it(
    name: str, symbol: str, number: str
) -> None:
    """Of what is stated only, is computed, or is measured on the diagram, too."""
    lines = [plain(one) for step in solve(load(name)).construction.steps for one in step.formulas]
    (found,) = (line for line in lines if line.startswith(f"{symbol} = "))
    assert f"= {number} " in found and sum(number in line for line in lines) > 1


@each((*DRAFTED, "swinging-block-offset-rod"))
def test_links_that_slide_on_each_other_turn_by_one_number(name: str) -> None:
    """ω_3 = ω_2: not 3.016 in one line and 3.0164 in the next."""
    solution = drafted(name)
    if solution is None:
        return
    words = "\n".join(step.words.en for step in solution.construction.steps)
    told = {parts[0]: parts[-1].split(" ")[0] for parts in lines_of(solution)}
    for link, like in re.findall(r"form a sliding pair: \$ ([ωα]_\d+)\$ = \$ ([ωα]_\d+)\$", words):
        for parts in lines_of(solution):
            first = re.match(rf"2?{link}(\^2)? ", parts[1])
            number = re.match(r"(?:2 × )?−?([\d.]+)", parts[2])
            if first and number and like in told:
                assert number[1] == told[like].lstrip("−"), f"{link} = {like}: {' = '.join(parts)}"


def test_a_ratio_in_brackets_and_a_force_that_goes_on_through_a_link_have_the_number_that_their_line_told() -> None:
    jack = {parts[0]: parts for parts in lines_of(solve(load("5-5")))}
    assert jack["Q"][2].endswith(f"({jack['M/Q'][-1].split(' ')[0]})")
    forces = [plain(one) for step in solve(load("4-4")).construction.steps for one in step.formulas]
    assert "R_31 = R_12 = 527.5 N ≈ 528 N" in forces


@each((*DRAFTED, "5-3"))
def test_an_answer_that_a_step_works_out_before_it_is_laid_off_is_not_read_back(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    lines = [plain(one).split(" = ") for step in solution.construction.steps for one in step.formulas]
    for one in solution.answers.values():
        if not isinstance(line := one.reading.formula, Row):
            continue
        own = plain(line).split(" = ")
        before = [parts for parts in lines if parts[0] == own[0] and len(parts) == WORKED and "μ_" not in parts[1]]
        assert not (before and own[1].startswith("μ_")), f"{' = '.join(own)} after {before}"


@each((*DRAFTED, "return-spring"))
def test_a_force_has_one_number_by_whichever_of_its_names_a_line_finds_it(name: str) -> None:
    """R_23 = 997 N, and R_32 too; what a damper does to its other link is F_d′ = F_d."""
    solution = drafted(name)
    told: dict[str, str] = {}
    for line in (plain(one) for step in solution.construction.steps for one in step.formulas) if solution else ():
        pair = re.match(r"R_(\d)(\d)(,0)? = .*?([\d.]+ N)$", line)
        if pair is not None:
            joint, end = f"{min(pair[1], pair[2])}{max(pair[1], pair[2])}{pair[3]}", pair[4]
            assert told.setdefault(joint, end) == end, line


def test_the_force_on_the_other_link_of_a_damper_has_the_number_of_that_on_the_first() -> None:
    lines = [" = ".join(parts) for parts in lines_of(solve(load("return-spring")))]
    (found,) = (line.rpartition(" = ")[2].removesuffix(" N") for line in lines if line.startswith("F_d = "))
    users = [line for line in lines if "F_d′" in line]
    assert len(users) > 2 and all(f"{found} × " in line for line in users)


def test_a_number_has_the_figures_that_a_line_needs_once_all_others_in_it_are_known() -> None:
    """a^n = 0.0194634² × 1.0995 stood under ω_4 = 0.01946: l_DC was settled after it."""
    told = {parts[0]: parts for parts in lines_of(solve(load("dump-hoist"), precise=False))}
    turns = told["ω_4"][-1].removesuffix(" rad/s")
    assert told["a^n_C4"][2].startswith(f"{turns}^2 × ") and told["a^k_C4C5"][2].startswith(f"2 × {turns} × ")


@pytest.mark.parametrize("name", ["train-stepped", "train-ring", "train-differential"])
def test_an_angular_velocity_that_is_given_is_not_read_back_off_the_diagram(name: str) -> None:
    """ω_1 = 20 rad/s was given, and i_1H was 20.01/3.27."""
    problem = load(name)
    lines = lines_of(solve(problem))
    given = {key for key, omega in problem.subject.omegas.items() if omega is not None}  # type: ignore[union-attr]
    assert given and not {parts[0] for parts in lines} & {f"ω_{key}" for key in given}


@pytest.mark.parametrize("name", ["press-flywheel", "7-4"])
def test_the_mean_angular_velocity_of_a_machine_is_worked_out_before_it_is_gone_on_with(name: str) -> None:
    """n = 120 r/min was given, and J_F went on with 12.566 rad/s."""
    lines = [plain(one) for step in solve(load(name)).construction.steps for one in step.formulas]
    (found, *_), *users = ([line for line in lines if mark in line] for mark in ("ω_m = ", "ω_m^2"))
    number = found.rpartition(" = ")[2].removesuffix(" rad/s")
    assert users[0] and all(lines.index(found) < lines.index(line) and f"{number}^2" in line for line in users[0])
