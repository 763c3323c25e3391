"""Claims about what is refused or told before anything is drawn: contradictions, limits, signs that nobody sees, files
out of reach, wrong arguments."""

from __future__ import annotations

import copy
import os
import pickle
import re
import zipfile
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Any, cast

import pytest

import vecpoly
from tests.laws import few
from vecpoly import limits
from vecpoly.check.idle import idle
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.check.table.whole import check_table
from vecpoly.cycle import cycle, table, xlsx_bytes
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.errors import ArgumentError, AssemblyError, ProblemFileError, ReportTemplateError, TableError, VecpolyError
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.load import load, loads
from vecpoly.report.document import report_bytes
from vecpoly.solution import solve

FOUR_BAR = """\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 100 mm, E: {BE: 60 mm, CE: 70 mm, side: left of BC}}
  3: {CD: 80 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C above AD]
find: [v_C]
"""
PLACE = "{BE: 60 mm, CE: 70 mm, side: left of BC}"
INPUT = "{link: 1, phi: 60 deg, omega: 10 rad/s ccw}"


def changed(*pairs: tuple[str, str]) -> str:
    text = FOUR_BAR
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return text


CONTRADICTIONS = {
    "left and right": ((PLACE, "{along: BC, at: 30 mm, left: 20 mm, right: 21 mm}"), ("20 mm", "21 mm")),
    "left and right of a slot": (
        ("3: {CD: 80 mm}", "3: {slot: {through: D, left: 4 mm, right: 5 mm}}"),
        ("4 mm", "5 mm"),
    ),
    "two lengths and an offset": ((PLACE, "{BE: 60 mm, CE: 70 mm, side: left of BC, left: 3 mm}"), ("left", "BE, CE")),
    "an angle and a side": ((PLACE, "{BE: 60 mm, angle: 50 deg from BC, side: left of BC}"), ("side", "angle")),
    "an angle and an offset": ((PLACE, "{BE: 60 mm, angle: 50 deg from BC, at: 4 mm}"), ("at", "angle")),
    "a bar that is a block": (("3: {CD: 80 mm}", "3: {CD: 80 mm, block: C}"), ("CD", "block")),
    "a slot that is a rod": (("3: {CD: 80 mm}", "3: {slot: D, rod: D}"), ("slot", "rod")),
    "one link driven twice": ((INPUT, f"[{INPUT}, {INPUT}]"), ("link 1", "another entry")),
    "a sense alone, and an acceleration": (("10 rad/s ccw", "ccw, alpha: 3 rad/s^2"), ("ccw", "3 rad/s^2")),
    "inertia of nothing": (("find:", "inertia: no\nfind:"), ("inertia", "mass")),
    "weight of nothing": (
        ("find:", "weight: yes\nloads: {M_1: {on: 1, size: '?'}, M_3: {on: 3, size: 2 N*m}}\nfind:"),
        ("weight", "mass"),
    ),
    "Coriolis and a point": (("[v_C]", "[{coriolis: B3B2, velocity: 0}]"), ("coriolis", "velocity")),
    "a direction of ω": (
        ("find:", "printed: [{symbol: omega_3, value: 1 rad/s, direction: 30 deg}]\nfind:"),
        ("omega_3", "direction"),
    ),
    "C beside a line through C": (("C above AD", "C left of CD"), ("C left of CD",)),
    "B beside a line that is none": (("C above AD", "C left of BB"), ("C left of BB",)),
    "nothing driven": ((INPUT, "[]"), ("no link is driven",)),
    "a scale for a map": (("find:", "scales: {mu_l: 1e-15 m/mm}\nfind:"), ("mu_l", "1.2e+14 mm")),
    "a scale for a speck": (("find:", "scales: {mu_l: 1e6 m/mm}\nfind:"), ("mu_l", "1.2e-07 mm")),
    "a point beyond the moon": (("120 mm, 0", "1e20 m, 0"), ("frame.D", "1e20 m")),
    "a power of a unit": (("40 mm", "80 m^999"), ("power", "m**999")),
    "a great power": (("40 mm", "80 m^" + "9" * 100), ("power",)),
    "a unit without size": (("40 mm", "80 mm^9*mm^9*mm^9*mm^9"), ("unknown",)),
}


@pytest.mark.parametrize("case", CONTRADICTIONS)
def test_a_contradiction_is_refused_with_both_statements(case: str) -> None:
    pair, said = CONTRADICTIONS[case]
    with pytest.raises(ProblemFileError) as caught:
        loads(changed(pair))
    for word in ("line ", *said):
        assert word in str(caught.value)


def test_two_entries_for_the_friction_of_one_slide_are_refused() -> None:
    text = load("4-3a").text.replace("friction:\n", "friction:\n  4-3: {phi: 3 deg}\n", 1)
    assert "4-3: {phi: 3 deg}" in text
    with pytest.raises(ProblemFileError, match="given twice"):
        loads(text)


def test_a_branch_that_the_drive_decides_otherwise_is_refused() -> None:
    with pytest.raises(AssemblyError, match=r"'B left of A' contradicts.*60°.*'B right of A'"):
        solve(loads(changed(("C above AD", "C above AD, B left of A"))), repeats=0)


@pytest.mark.parametrize(
    ("pair", "said"),
    [
        (("C above AD", "C above AD, B right of A"), "'B right of A' decides nothing"),
        (("find:", "guesses: {C: [1 mm, 1 mm]}\nfind:"), "guesses"),
        (("60 deg", "75 rad"), "write 75 deg"),
        (("find:", "scales: {mu_v: 0.1 (m/s)/mm}\nfind:"), "too small to be read"),
        (("find:", "scales: {mu_v: 0.0001 (m/s)/mm}\nfind:"), "more than an A4 sheet"),
        (("find:", "scales: {mu_a: 1 (m/s^2)/mm}\nfind:"), "not used"),
    ],
)
def test_what_is_hardly_meant_is_told_in_both_languages(pair: tuple[str, str], said: str) -> None:
    solution = solve(loads(changed(pair)), repeats=0)
    assert any(said in words.en for words in solution.warnings) and all(
        words.zh != words.en for words in solution.warnings
    )
    assert solution.as_json()["warnings"]


def test_a_coefficient_of_friction_above_1_is_told() -> None:
    text = load("5-1").text
    assert not loads(text).warnings
    (words,) = loads(text.replace("f: ", "f: 9", 1)).warnings
    assert "coefficient of friction" in words.en and "data.f" in words.en


def test_an_angle_that_a_linkage_is_turned_to_is_no_angle_of_friction() -> None:
    text = load("cognates").text
    assert text and not loads(text.replace("phi: 40 deg", "phi: 65 deg")).warnings


def test_no_problem_of_the_library_is_warned_of() -> None:
    from vecpoly.problem.library import library

    problems = [load(entry.path) for entry in few(library(), 3)]
    assert len(problems) > 80 and [problem.id for problem in problems if problem.warnings or idle(problem)] == []


def test_what_decides_nothing_may_be_left_out_together() -> None:
    either = (
        (load("scissor-lift").text or "")
        .replace("id: scissor-lift", "id: lift")
        .replace("C right of A]", "C right of A, C right of E]")
    )
    (words,) = idle(loads(either))
    assert "'C right of E' decides nothing" in words.en and idle(loads(either.replace(", C right of E]", "]"))) == ()
    with pytest.raises(AssemblyError, match="of which 2 fulfil what is said"):
        solve(loads(either.replace(", C right of A, C right of E]", "]")), repeats=0)


def test_two_drives_are_both_drawn() -> None:
    text = changed(
        ("D: [120 mm, 0 mm]", "F: [120 mm, 0 mm]"),
        ("3: {CD: 80 mm}", "3: {CD: 90 mm}\n  4: {FD: 50 mm}"),
        ("above AD", "left of BD"),
        (INPUT, f"[{INPUT}, {{link: 4, phi: 100 deg, omega: 5 rad/s cw}}]"),
        ("[v_C]", "[v_C, a_C, omega_2, alpha_3]"),
    )
    answers = solve(loads(text), by="exact", repeats=0).answers
    assert len(answers) == 4 and all(abs(one.deviation) < 1e-9 * abs(one.exact) for one in answers.values())


def test_a_printed_direction_is_weighed() -> None:
    text = changed(("find:", "printed: [{symbol: v_C, value: 0.233 m/s, direction: 10 deg}]\nfind:"))
    (wrong,) = check_problem(loads(text)).answers
    assert wrong.verdict is Verdict.WRONG and wrong.slip is not None and "10°" in wrong.slip.en
    there = wrong.slip.en.split("is ")[1].split("°")[0]
    (right,) = check_problem(loads(text.replace("10 deg", f"{there} deg"))).answers
    assert right.verdict is Verdict.REPRODUCED


@pytest.mark.parametrize(("way", "across"), [("portrait", False), ("landscape", True)])
def test_a_sheet_is_turned_as_the_file_says(way: str, across: bool) -> None:
    solution = solve(loads(changed(("find:", f"sheet: {{orientation: {way}}}\nfind:"))), repeats=0)
    assert {sheet.landscape for sheet in sheets(solution.construction, on=solution.problem.paper)} == {across}


# -- characters and limits --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("sign", "called"),
    [
        ("\u202e", "RIGHT-TO-LEFT OVERRIDE"),
        ("\x1b", "U+001B"),
        ("\ud800", "U+D800"),
        ("\u200b", "ZERO WIDTH SPACE"),
        ("\x85", "U+0085"),
    ],
)
@pytest.mark.parametrize("escaped", [False, True])
def test_a_sign_that_nobody_sees_is_refused_with_its_column(sign: str, called: str, escaped: bool) -> None:
    new = f'title: "a\\u{ord(sign):04x}b"' if escaped else f"title: ab{sign}"
    with pytest.raises(ProblemFileError, match=rf"line 2, column {9 if escaped else 10}: .*{re.escape(called)}"):
        loads(changed(("title: test", new)))


@pytest.mark.parametrize(
    "pair",
    [
        ("title: test", "title: " + "x" * (limits.SCALAR + 1)),
        ("40 mm", "40 " + "m*" * limits.SCALAR + "m"),
        ("title: test", "title: t\nstatement: " + "x" * (limits.PROSE + 1)),
        ("find: [v_C]", f"find: [{', '.join(['v_C'] * (limits.ENTRIES + 1))}]"),
        ("find: [v_C]", f"find: {'[' * 60}v_C{']' * 60}"),
        ("AB: 40", "A" * 300 + ": 40"),
    ],
)
def test_what_is_too_long_is_refused_at_its_line(pair: tuple[str, str]) -> None:
    with pytest.raises(ProblemFileError, match=r"line \d") as caught:
        loads(changed(pair))
    assert len(str(caught.value)) < 700


def test_a_statement_may_be_longer_than_a_value() -> None:
    assert loads(changed(("title: test", "title: t\nstatement: " + "x" * limits.PROSE))).statement.en


# -- files out of reach -----------------------------------------------------------------------------------------


@pytest.fixture
def out_of_reach(tmp_path: Path) -> Path:
    """A folder `in` beside a file that it must not read."""
    (tmp_path / "in").mkdir()
    (tmp_path / "secret.yaml").write_text(FOUR_BAR, encoding="utf-8")
    return tmp_path / "in"


@pytest.mark.parametrize("named", ["../secret.yaml", "{outside}", "link.yaml", "../missing.yaml"])
def test_a_file_outside_the_folder_is_not_read_unless_the_user_says_so(out_of_reach: Path, named: str) -> None:
    outside = out_of_reach.parent / "secret.yaml"
    (out_of_reach / "link.yaml").symlink_to(outside)
    file = out_of_reach / "x.yaml"
    file.write_text(f"id: x\nextends: {named.format(outside=outside)}\n", encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"line 2.*lies outside.*--allow-outside"):
        load(file)
    if "missing" not in named:
        assert load(file, allow_outside=True).id == "x"


def test_tables_and_assignments_stay_in_the_folder_too(out_of_reach: Path) -> None:
    (out_of_reach.parent / "t.csv").write_text("phi1\n", encoding="utf-8")
    (out_of_reach / "x.yaml").write_text(changed(("find:", "tables: [../t.csv]\nfind:")), encoding="utf-8")
    (out_of_reach / "all.yaml").write_text("title: t\nproblems: [../secret.yaml]\n", encoding="utf-8")
    for act in (lambda: load(out_of_reach / "x.yaml"), lambda: load_assignment(out_of_reach / "all.yaml")):
        with pytest.raises(ProblemFileError, match="lies outside"):
            act()
    assert load_assignment(out_of_reach / "all.yaml", allow_outside=True).problems


def test_of_a_file_that_is_no_problem_nothing_is_told(tmp_path: Path) -> None:
    (tmp_path / "shadow").write_text("root:$6$hash:19000:0\nname: [\n", encoding="utf-8")
    (tmp_path / "x.yaml").write_text("id: x\nextends: shadow\n", encoding="utf-8")
    with pytest.raises(ProblemFileError) as caught:
        load(tmp_path / "x.yaml")
    assert "no problem file" in str(caught.value) and "$6$" not in str(caught.value) and "hash" not in str(caught.value)


# -- templates --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "said"),
    few(
        [
            ("{% for p in problems %}", "{% for p in problems", "line 9"),
            ("{{ p.title }}", "{{ p.titel }}", "titel"),
            ("{{ title }}", "{{ 1 / 0 }}", "division"),
            ("{{ title }}", "{{ cycler.__init__.__globals__ }}", "unsafe"),
            ("{{ title }}", "{{ ''.__class__.__mro__ }}", "unsafe"),
            ("{{ title }}", "{{ 'x' * 10**9 }}", "takes numbers below"),
            ("{{ title }}", "{{ problems.append(1) }}", "unsafe|callable|not safely"),
            ("{{ title }}", "{% include '/etc/passwd' %}", "does not exist"),
        ],
        2,
    ),
)
def test_a_slip_in_a_template_is_told_with_file_and_line_and_reaches_nothing(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    text = (Path(__file__).resolve().parents[2] / "templates" / "solution.en.xml.j2").read_text(encoding="utf-8")
    assert old in text
    (tmp_path / "solution.en.xml.j2").write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ReportTemplateError, match=said) as caught:
        report_bytes([solve(load("3-9"), repeats=0)], lang="en", templates=tmp_path)
    assert "solution.en.xml.j2" in str(caught.value)


# -- tables -----------------------------------------------------------------------------------------------------


def workbook(change: Callable[[bytes], bytes]) -> bytes:
    """A workbook whose sheet is changed."""
    good, out = xlsx_bytes(table(cycle(load("3-9"), 5)), "3-9", "en"), BytesIO()
    with zipfile.ZipFile(BytesIO(good)) as parts, zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as made:
        for name in parts.namelist():
            made.writestr(name, change(parts.read(name)) if name.endswith("sheet1.xml") else parts.read(name))
    return out.getvalue()


DOCTYPE = b'<?xml version="1.0"?><!DOCTYPE x [<!ENTITY e SYSTEM "file:///etc/passwd">]>'
BOOKS: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "cut": (lambda xml: xml[: len(xml) // 2], "damaged"),
    "no number": (lambda xml: xml.replace(b"<v>0</v>", b"<v>x1</v>", 1), "damaged"),
    "entities": (lambda xml: DOCTYPE + xml.replace(b"<v>0</v>", b"<v>&e;</v>", 1).partition(b"?>")[2], "DOCTYPE"),
    "bomb": (lambda xml: xml + b" " * (limits.TABLE_UNPACKED + 1), "when unpacked"),
}


@pytest.mark.parametrize("case", BOOKS)
def test_a_damaged_or_malicious_workbook_is_refused(case: str, tmp_path: Path) -> None:
    change, said = BOOKS[case]
    (tmp_path / "t.xlsx").write_bytes(workbook(change))
    with pytest.raises(TableError, match=said):
        check_table(load("3-9"), tmp_path / "t.xlsx")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"phi1,v_B\n" + b"1,2\n" * (limits.TABLE_ROWS + 1), "rows"),
        (b",".join([b"a"] * 300) + b"\n1\n", "300 columns"),
        (b"phi1,v_B\n1," + b"2" * 2000 + b"\n", "characters"),
        (b'phi1,v_B\n1,"' + b"2\n" * 5_000, "characters"),
        (b"1,2\n" * (limits.TABLE_BYTES // 4 + 1), "20 MB"),
    ],
)
def test_a_table_beyond_the_limits_is_refused(text: bytes, said: str, tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_bytes(text)
    with pytest.raises(TableError, match=said):
        check_table(load("3-9"), tmp_path / "t.csv")


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="devices of another kind")
def test_a_table_is_a_regular_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "zero.csv").symlink_to("/dev/zero")
    for name in ("pipe.csv", "zero.csv", "."):
        with pytest.raises(TableError, match="no regular file"):
            check_table(load("3-9"), tmp_path / name)


# -- arguments --------------------------------------------------------------------------------------------------


WRONG: Any = None  # what no type allows


@pytest.mark.parametrize(
    "act",
    [
        lambda: vecpoly.solve(WRONG),
        lambda: vecpoly.solve(cast("Any", "3-9")),
        lambda: vecpoly.loads(WRONG),
        lambda: vecpoly.load(WRONG),
        lambda: vecpoly.write_report([], "x.pdf"),
        lambda: vecpoly.write_report(WRONG, "x.pdf"),
        lambda: vecpoly.solve(load("3-9"), repeats=-1),
        lambda: vecpoly.solve(load("3-9"), repeats=10**9),
        lambda: vecpoly.solve(load("3-9"), seed=-1),
        lambda: vecpoly.solve(load("3-9"), by="nobody"),
        lambda: report_bytes([solve(load("3-9"), repeats=0)], lang=WRONG),
        lambda: vecpoly.check_problem(WRONG),
        lambda: vecpoly.check_table(WRONG, "x"),
        lambda: vecpoly.load_assignment(WRONG),
    ],
)
def test_a_wrong_argument_is_told_by_name(act: Callable[[], object]) -> None:
    with pytest.raises(VecpolyError) as caught:
        act()
    assert caught.value.words.zh and caught.value.words.en


def test_a_wrong_argument_is_a_value_error_too() -> None:
    assert issubclass(ArgumentError, ValueError)


@pytest.mark.parametrize("name", ["3-9", "4-3a", "5-1", "2-1"])
def test_problems_and_solutions_pickle_and_copy(name: str) -> None:
    solution = solve(load(name), repeats=5)
    for again in (pickle.loads(pickle.dumps(solution)), copy.deepcopy(solution)):
        assert again.as_json() == solution.as_json() and again.problem == solution.problem


def test_a_mechanism_hashes_and_its_maps_do_not_change() -> None:
    one, other = load("3-9").mechanism, load("3-9").mechanism
    assert hash(one) == hash(other) and one == other
    with pytest.raises(TypeError):
        one.frame["A"] = 1j  # type: ignore[index]
    with pytest.raises((TypeError, AttributeError)):
        one.frame._held = {}  # type: ignore[attr-defined]
    with pytest.raises(TypeError):
        solve(load("3-9"), repeats=0).answers["v_B"] = None  # type: ignore[index]


def test_an_acceleration_of_the_drive_decides_nothing_of_velocities() -> None:
    text = changed(("omega: 10 rad/s ccw", "omega: 10 rad/s ccw, alpha: 5 rad/s^2"))
    assert "alpha: 5" in text
    asked = text.split("find: [")[0]
    (words,) = (one for one in idle(loads(asked + "find: [v_C, omega_2]\n")) if "acceleration" in one.en)
    assert "may be left out" in words.en
    assert not [one for one in idle(loads(asked + "find: [v_C, a_C]\n")) if "acceleration" in one.en]
