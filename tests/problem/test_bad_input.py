"""Bad input: one clear error each, with file, line and YAML path; never a traceback of another kind."""

from __future__ import annotations

from pathlib import Path

import pytest

from vecpoly import load, loads
from vecpoly.errors import MobilityError, NotAskedError, ProblemFileError, UnknownNameError, VecpolyError
from vecpoly.limits import FILE as LIMIT
from vecpoly.problem.assignment import load_assignment
from vecpoly.problem.library import library

GOOD = """\
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


def refusal(old: str, new: str) -> str:
    """The message for the good file with one thing changed."""
    assert old in GOOD
    with pytest.raises(ProblemFileError) as caught:
        loads(GOOD.replace(old, new), "p.yaml")
    return str(caught.value)


def test_the_good_file_is_good() -> None:
    loads(GOOD)


CASES = {
    "unknown letter in find": ("v_C", "v_X", "line 10", "find[0]", "'X' does not exist"),
    "unknown link in find": ("v_C", "omega_7", "line 10", "find[0]", "link '7' does not exist"),
    "no symbol": ("v_C", "speed", "line 10", "find[0]", "'speed' is no symbol"),
    "unknown letter in branch": ("C above AD", "C above AZ", "line 9", "branch[0]", "'Z' does not exist"),
    "no branch": ("C above AD", "C over AD", "line 9", "branch[0]", "'C above AD'"),
    "unknown link as input": ("link: 1", "link: 9", "line 8", "input.link", "link '9' does not exist"),
    "input on no fixed pivot": ("link: 1", "link: 2", "line 8", "input.link", "no fixed pivot"),
    "unknown joint": ("branch", "joints: [4 slides in 9]\nbranch", "line 9", "joints[0]", "link '4' does not exist"),
    "no joint": ("branch", "joints: [3 glides in 2]\nbranch", "line 9", "joints[0]", "is no joint"),
    "missing length": ("{AB: 40 mm}", "{}", "line 5", "links.1", "needs a mapping such as"),
    "empty length": ("{AB: 40 mm}", "{AB: }", "line 5", "links.1.AB", "a length is expected here"),
    "no length, only a point": (
        "3: {CD: 80 mm}",
        "3: {E: {along: CD, at: 3 mm}}",
        "line 7",
        "links.3",
        "has no length",
    ),
    "a length that overflows": (
        "AB: 40 mm",
        "AB: 1e300 mm",
        "line 5",
        "links.1.AB",
        "'1e300 mm' is too large for a length",
    ),
    "a length that vanishes": (
        "AB: 40 mm",
        "AB: 1e-300 mm",
        "line 5",
        "links.1.AB",
        "'1e-300 mm' must be greater than zero",
    ),
    "an angle lost in rounding": ("60 deg", "1e18 deg", "line 8", "input.phi", "'1e18 deg' is too large for an angle"),
    "a speed whose square overflows": (
        "10 rad/s",
        "1e160 rad/s",
        "line 8",
        "input.omega",
        "too large for an angular velocity",
    ),
    "a direction from a point to itself": ("60 deg", "60 deg from AA", "line 8", "input.phi", "A and A are one place"),
    "two lengths": ("CD: 80 mm", "CD: 80 mm, DF: 3 mm", "line 7", "links.3.DF", "already has the length CD"),
    "misspelt key": ("frame", "fram", "line 3", "fram", "did you mean 'frame'?"),
    "misspelt key of the input": ("omega:", "omgea:", "line 8", "input.omgea", "did you mean 'omega'?"),
    "misspelt key of a link": ("3: {CD: 80 mm}", "3: {CD: 80 mm, blok: C}", "line 7", "links.3.blok", "'block'?"),
    "misspelt key of a place": ("side: left", "sid: left", "line 6", "links.2.E.sid", "did you mean 'side'?"),
    "missing key": ("title: test\n", "", "line 1", "title", "'title' is missing"),
    "unit of the wrong dimension": ("40 mm", "40 deg", "line 5", "links.1.AB", "is an angle; write e.g. 30 mm"),
    "rate with the unit of a speed": ("10 rad/s ccw", "10 m/s", "line 8", "input.omega", "is a velocity"),
    "unknown unit": ("40 mm", "40 furlong", "line 5", "links.1.AB", "unit 'furlong' is unknown"),
    "bare number": ("40 mm", "40", "line 5", "links.1.AB", "write e.g. 40 mm"),
    "no number": ("40 mm", "long", "line 5", "links.1.AB", "'long' is not a length"),
    "sense twice": ("10 rad/s ccw", "-10 rad/s cw", "line 8", "input.omega", "both a minus sign and a sense"),
    "sense of a length": ("40 mm", "40 mm ccw", "line 5", "links.1.AB", "no sense of rotation"),
    "zero length": ("40 mm", "0 mm", "line 5", "links.1.AB", "must be greater than zero"),
    "negative length": ("40 mm", "-40 mm", "line 5", "links.1.AB", "must be greater than zero"),
    "length from a point to itself": ("CD: 80 mm", "DD: 80 mm", "line 7", "links.3.DD", "from D to itself"),
    "nan": ("40 mm", "nan mm", "line 5", "links.1.AB", "not a finite number"),
    "infinity": ("40 mm", "inf mm", "line 5", "links.1.AB", "not a finite number"),
    "number too large": ("40 mm", "1e999 mm", "line 5", "links.1.AB", "not a finite number"),
    "no triangle": ("BE: 60 mm", "BE: 20 mm", "line 6", "links.2.E", "BE = 20, CE = 70, BC = 100 mm", "(100 > 90)"),
    "no side": (", side: left of BC", "", "line 6", "links.2.E", "on which side is E?"),
    "length to a strange point": ("CE: 70", "XE: 70", "line 6", "links.2.E.XE", "must join E with B or C"),
    "list for a mapping": ("{AB: 40 mm}", "[40 mm]", "line 5", "links.1", "needs a mapping"),
    "list for links": ("frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}", "frame: [A, D]", "line 3", "frame", "a mapping"),
    "value for a list": ("[v_C]", "v_C", "line 10", "find", "a list is expected here"),
    "number for a list": ("[v_C]", "5", "line 10", "find", "a list is expected here"),
    "mapping for a list": ("[v_C]", "{v: C}", "line 10", "find", "write e.g. [v_C, a_C]"),
    "mappings for a list": ("[C above AD]", "{C: {above: AD}}", "line 9", "branch", "write e.g. [C left of BD]"),
    "sentence for a list": ("[C above AD]", "{C above: AD}", "line 9", "branch", "write [C above AD]"),
    "one coordinate": ("[120 mm, 0 mm]", "[120 mm]", "line 3", "frame.D", "two values are expected here"),
    "strange letter": ("D: [", "d: [", "line 3", "frame.d", "is no letter of a point"),
    "link without number": ("  3: {", "  rocker: {", "line 7", "links.rocker", "links are numbered"),
    "turning and sliding": ("phi:", "s: 3 mm, phi:", "line 8", "input", "not both"),
    "no rate": (", omega: 10 rad/s ccw", "", "line 8", "input", "needs phi and omega"),
    "no space after the colon": ("AB: 40", "AB:40", "line 5", "AB:40", "write a space"),
    "bad scale": ("find", "scales: {mu_l: 2 mm}\nfind", "line 10", "scales.mu_l", "is not a length scale"),
    "scale of nothing": ("find", "scales: {mu_v: 0 (m/s)/mm}\nfind", "line 10", "scales.mu_v", "greater than zero"),
    "duplicate key": ("  3: {CD", "  1: {AB: 41 mm}\n  3: {CD", "line 7", "'1' occurs twice", "first in line 5"),
    "syntax": ("[v_C]", "[v_C", "line 10", "'['", "not closed"),
    "tab": ("  1: {AB", "\t1: {AB", "line 5", "column 1", "a tab; indent with spaces"),
    "alias": ("1: {AB: 40 mm}", "1: &a {AB: 40 mm}\n  4: *a", "line 5", "no YAML aliases", "write the value out"),
    "id of strange letters": ("id: t", "id: ../t", "line 1", "id", "may hold only"),
    "second colon": ("title: test", "title: a: b", "line 2", "a second ':'", "quotes"),
    "text with a comma": ("title: test", "title: {zh: a, en: b, c}", "line 2", "title", "between quotes"),
}


@pytest.mark.parametrize("name", CASES)
def test_one_fault_is_told_with_its_line_and_path(name: str) -> None:
    old, new, *words = CASES[name]
    message = refusal(old, new)
    assert message.startswith("p.yaml")
    assert len(message.splitlines()) == 1, message
    for word in words:
        assert word in message, message


def test_several_faults_come_first_line_first() -> None:
    text = GOOD.replace("40 mm", "40").replace("CD: 80 mm", "CD: 0 mm")
    with pytest.raises(ProblemFileError) as caught:
        loads(text, "p.yaml")
    first, second = str(caught.value).splitlines()
    assert "line 5" in first and "line 7" in second


def test_two_inputs_on_one_degree_of_freedom() -> None:
    two = "input: [{link: 1, phi: 60 deg, omega: 10 rad/s}, {link: 3, phi: 99 deg, omega: 1 rad/s}]"
    with pytest.raises(MobilityError, match=r"p\.yaml, line 8"):
        loads(GOOD.replace("input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}", two), "p.yaml")


def test_empty_file_and_comment_only() -> None:
    for text in ("", "# nothing\n", "---\n"):
        with pytest.raises(ProblemFileError, match="empty"):
            loads(text, "p.yaml")


def test_a_list_is_no_problem() -> None:
    with pytest.raises(ProblemFileError, match="must be a mapping"):
        loads("- a\n- b\n", "p.yaml")


def test_a_large_file_is_refused_by_its_size(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    with path.open("wb") as file:
        file.truncate(10 * LIMIT)
    with pytest.raises(ProblemFileError, match=r"10\.0 MB"):
        load(path)


def test_another_encoding_is_named_with_its_byte(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_bytes(GOOD.replace("test", "机构").encode("gb18030"))
    with pytest.raises(ProblemFileError, match=r"line 2: byte 13 \(0xbb\) is not UTF-8"):
        load(path)


def test_utf_16_and_control_characters(tmp_path: Path) -> None:
    for data in (GOOD.encode("utf-16"), b"id: \x00\x01", b"\x07"):
        path = tmp_path / "p.yaml"
        path.write_bytes(data)
        with pytest.raises(ProblemFileError):
            load(path)


def test_deep_nesting_is_refused() -> None:
    for text in ("a: " + "[" * 3_000, "a: " + "{a: " * 1_100, "a: " + "[" * 60 + "]" * 60):
        with pytest.raises(ProblemFileError, match="nest"):
            loads(text, "p.yaml")


def test_an_alias_bomb_is_refused() -> None:
    names = zip("abcdefgh", "bcdefghi", strict=True)
    bomb = "a: &a [x, x, x]\n" + "".join(f"{n}: &{n} [*{m}, *{m}, *{m}]\n" for m, n in names)
    with pytest.raises(ProblemFileError, match="aliases"):
        loads(bomb, "p.yaml")


def test_unknown_id_with_a_guess() -> None:
    with pytest.raises(UnknownNameError, match="did you mean '3-5-xD400'"):
        load("3-5-xd40")
    with pytest.raises(ProblemFileError, match="no such file"):
        load("nowhere.yaml")
    for name in ("", "..", "ch3", "../problems/ch3/3-9", "*"):
        with pytest.raises(VecpolyError):
            load(name)


def test_a_folder_is_no_problem_file(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").mkdir()
    with pytest.raises(ProblemFileError):
        load(tmp_path / "p.yaml")


def test_a_folder_is_told_from_an_unknown_problem(tmp_path: Path) -> None:
    (tmp_path / "class-7").mkdir()
    with pytest.raises(ProblemFileError, match="class-7: is a folder, not a problem file"):
        load(tmp_path / "class-7")


def test_a_base_that_is_no_file_is_told_with_the_line_that_names_it(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("id: a\nextends: gone.yaml\n", encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"a\.yaml, line 2: extends: gone\.yaml: no such file"):
        load(tmp_path / "a.yaml")


def test_extends_in_a_circle_and_of_nothing(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("id: a\nextends: b.yaml\n", encoding="utf-8")
    (tmp_path / "b.yaml").write_text("id: b\nextends: a.yaml\n", encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"line 2: extends: .* in a circle"):
        load(tmp_path / "a.yaml")
    with pytest.raises(ProblemFileError, match="line 2: extends: no problem '99'"):
        loads("id: a\nextends: 99\n", "p.yaml")


def test_a_fault_in_the_base_names_the_base(tmp_path: Path) -> None:
    (tmp_path / "base.yaml").write_text(GOOD.replace("40 mm", "40"), encoding="utf-8")
    (tmp_path / "over.yaml").write_text("id: o\nextends: base.yaml\nlinks: {3: {CD: 0 mm}}\n", encoding="utf-8")
    with pytest.raises(ProblemFileError) as caught:
        load(tmp_path / "over.yaml")
    text = str(caught.value)
    assert "base.yaml, line 5" in text and "over.yaml, line 3" in text


def test_duplicate_ids_in_the_library(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.yaml").write_text(GOOD, encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"b\.yaml, line 1: id: 't' is also the id of .*a\.yaml"):
        library(tmp_path)


def sheet(tmp_path: Path, text: str) -> str:
    path = tmp_path / "sheet.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ProblemFileError) as caught:
        load_assignment(path)
    return str(caught.value)


ASSIGNMENTS = {
    "twice one id": ("problems: [3-9, 3-9]", "problems[1]: id '3-9' is already that of problems[0]"),
    "unknown id": ("problems: [3-99]", "problems[0]: no problem '3-99'"),
    "misspelt field": (
        "title_block: {grad: 1}\nproblems: [3-9]",
        "title_block.grad: unknown field 'grad'; did you mean",
    ),
    "misspelt key": (
        "problems: [{problem: 3-9, input: {omga: 1 rad/s}}]",
        "input.omga: unknown key 'omga'; did you mean",
    ),
    "no name": ("problems: [{id: x}]", "problems[0]: name the problem"),
    "no problems": ("problems: []", "problems: at least one entry"),
}


@pytest.mark.parametrize("name", ASSIGNMENTS)
def test_faults_of_an_assignment(name: str, tmp_path: Path) -> None:
    text, message = ASSIGNMENTS[name]
    found = sheet(tmp_path, f"title: t\n{text}\n")
    assert message in found and "sheet.yaml, line " in found


def test_what_has_no_value_is_refused_by_its_name() -> None:
    text = load("4-1").text
    assert "l2: 180 mm" in text
    with pytest.raises(NotAskedError, match="f_vee has no value with these data"):
        loads(text.replace("l2: 180 mm", "l2: 1e-15 mm")).solve()


def test_a_find_that_asks_for_nothing_is_refused_at_its_place() -> None:
    message = refusal("find: [v_C]", "find: []")
    assert "p.yaml, line 10" in message and "find: at least one entry is needed" in message
