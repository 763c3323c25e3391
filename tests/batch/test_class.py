"""A class is the same however it came about: in what order, in how many runs, with whom beside."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from tests.batch.homework import FOUR, TEXT, files, made, people, piloted
from vecpoly.batch.classwork import Made
from vecpoly.batch.outputs import outputs
from vecpoly.batch.register import Register, Sheet, read_register
from vecpoly.batch.run import tasks
from vecpoly.batch.sheet.apriltag import CODES
from vecpoly.batch.sheet.layout import tags_of
from vecpoly.cli.app import app
from vecpoly.errors import NotAskedError, VecpolyError
from vecpoly.solution import solve

RUN = ["class", "hw3.yaml", "--roster", "r.csv", "-o", "broken", "-j", "1"]


def test_a_student_who_comes_later_changes_nobody(whole: tuple[Path, Made], tmp_path: Path) -> None:
    shutil.copytree(whole[0], tmp_path / "hw")
    later = made(tmp_path / "hw", (*people([77]), *FOUR)).register
    assert [one for one in later.sheets if one.student in FOUR] == list(whole[1].register.sheets)
    now = files(tmp_path / "hw")
    assert all(now[name] == data for name, data in files(whole[0]).items() if name.endswith(".pdf"))
    assert len(later.sheets) == 5


@pytest.mark.parametrize(
    ("was", "now", "key"),
    [("24 mm .. 40 mm by 2 mm", "24 mm .. 38 mm by 2 mm", "vary"), ("omega_3, v_E", "v_E, omega_3", "find")],
)
def test_a_problem_that_was_changed_after_its_sheets_were_made_is_refused(
    whole: tuple[Path, Made], tmp_path: Path, was: str, now: str, key: str
) -> None:
    """Everybody would have other values than those handed out."""
    shutil.copytree(whole[0], tmp_path / "hw")
    before = files(tmp_path / "hw")
    with pytest.raises(VecpolyError, match=rf"problem block was changed \({key}\)"):
        made(tmp_path / "hw", FOUR, TEXT.replace(was, now))
    assert files(tmp_path / "hw") == before


def test_a_sheet_at_which_the_program_breaks_is_told_of_and_stops_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A plate that no page holds (4-7 at the scales of a class) ended the whole run in a traceback."""
    written = tasks._printed

    def printed(register: Register, sheet: Sheet, out: Path) -> Any:
        if sheet.student.number == FOUR[1].number:
            raise ZeroDivisionError("division by zero")
        return written(register, sheet, out)

    monkeypatch.setattr(tasks, "_printed", printed)
    done = made(tmp_path / "hw", FOUR[:3])
    assert {number: error.words.en for number, error in done.refused.items()} == {
        FOUR[1].number: "a fault inside vecpoly (ZeroDivisionError: division by zero); please report it"
    }
    assert len(list((tmp_path / "hw" / "questions").iterdir())) == 2


def test_any_two_students_differ_by_three_tolerances_in_two_answers(whole: tuple[Path, Made]) -> None:
    keys = [sheet.parts[0].key for sheet in whole[1].register.sheets]
    asked = [one.key for one in keys[0].quantities if one.asked and not one.demoted]
    for i, one in enumerate(keys):
        for other in keys[:i]:
            apart = [
                abs(one[key].exact - other[key].exact) > 3 * max(one[key].allowed, other[key].allowed) for key in asked
            ]
            assert sum(apart) >= 2


def test_the_register_gives_every_variant_again_with_its_key(whole: tuple[Path, Made]) -> None:
    register = read_register(whole[0])
    assert register == whole[1].register
    for sheet in register.sheets:
        answers = solve(register.variant(sheet.parts[0]), by="exact", repeats=0, precise=False).answers
        for one in sheet.parts[0].key.quantities:
            if one.asked:
                assert answers[one.key].exact == pytest.approx(one.exact, rel=1e-12)
                assert answers[one.key].reading.mm is None or answers[one.key].reading.mm == pytest.approx(
                    one.mm, rel=1e-9
                )


def test_the_register_knows_where_everything_stands(whole: tuple[Path, Made]) -> None:
    for sheet in whole[1].register.sheets:
        assert sheet.layout is not None and sheet.layout_hash == sheet.layout.hash
        blanks = [blank.key for page in sheet.layout.pages for blank in page.blanks]
        assert sorted(blanks) == sorted(one.key for one in sheet.parts[0].key.quantities if one.asked)


def test_another_assignment_does_not_go_into_the_same_folder(whole: tuple[Path, Made], tmp_path: Path) -> None:
    shutil.copytree(whole[0], tmp_path / "hw")
    with pytest.raises(VecpolyError, match="is of assignment hw3, not hw4"):
        made(tmp_path / "hw", FOUR, TEXT.replace("id: hw3", "id: hw4"))


def test_what_is_no_register_is_refused_in_both_languages(tmp_path: Path) -> None:
    (tmp_path / "register.json").write_text('{"version": 1}', encoding="utf-8")
    with pytest.raises(VecpolyError, match="no register"):
        read_register(tmp_path)
    (tmp_path / "register.json").write_text('{"version": 9}', encoding="utf-8")
    with pytest.raises(VecpolyError, match="version 9, only 1"):
        read_register(tmp_path)


def test_a_run_that_was_killed_goes_on_and_ends_with_the_bytes_of_one_that_was_not(
    whole: tuple[Path, Made], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Killed as soon as the first sheets are there; what was finished is not done again."""
    (tmp_path / "hw3.yaml").write_text(TEXT, encoding="utf-8")
    rows = "".join(f"{one.number},{one.name},{one.team}\n" for one in FOUR)
    (tmp_path / "r.csv").write_text("学号,姓名,班级\n" + rows, encoding="utf-8")
    broken = subprocess.Popen(
        [sys.executable, "-m", "vecpoly", *RUN],
        cwd=tmp_path,
        start_new_session=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    while len(list((tmp_path / "broken" / "questions").glob("*.pdf"))) < 2 and broken.poll() is None:
        time.sleep(0.02)
    assert broken.poll() is None
    os.killpg(broken.pid, signal.SIGKILL)
    broken.wait()
    kept = {file: file.stat().st_mtime_ns for file in (tmp_path / "broken" / ".work").glob("*.json")}
    assert not (tmp_path / "broken" / "register.json").exists() and kept
    monkeypatch.chdir(tmp_path)
    with piloted():
        assert CliRunner().invoke(app, RUN).exit_code == 0
    shutil.copytree(whole[0], tmp_path / "through")
    assert tuple(outputs(whole[1].register, tmp_path / "through", None, lambda *_: None))  # as the command bundles them
    assert files(tmp_path / "broken") == files(tmp_path / "through")
    assert all(file.stat().st_mtime_ns == when for file, when in kept.items())


def test_a_file_that_was_damaged_is_written_anew(whole: tuple[Path, Made], tmp_path: Path) -> None:
    out = tmp_path / "hw"
    shutil.copytree(whole[0], out)
    file = next((out / "questions").glob("*.pdf"))
    good = file.read_bytes()
    file.write_bytes(good[:900] + bytes([good[900] ^ 1]) + good[901:])
    made(out, FOUR)
    assert file.read_bytes() == good


def test_answers_that_were_typed_are_never_written_over(whole: tuple[Path, Made], tmp_path: Path) -> None:
    """A form that is still blank is written anew with its class; one that is filled in stays, and a blank lies beside
    it."""
    out, fewer = tmp_path / "hw", replace(whole[1].register, sheets=whole[1].register.sheets[:3])
    shutil.copytree(whole[0], out)
    written = [{path.name for path in outputs(one, out, None, lambda *_: None)} for one in (fewer, whole[1].register)]
    assert all("answers.xlsx" in names and "answers.new.xlsx" not in names for names in written)
    blank = (out / "answers.xlsx").read_bytes()
    (out / "answers.xlsx").write_bytes(blank + b" typed")
    names = {path.name for path in outputs(whole[1].register, out, None, lambda *_: None)}
    assert (out / "answers.xlsx").read_bytes() == blank + b" typed" and "answers.xlsx" not in names
    assert (out / "answers.new.xlsx").read_bytes() == blank


def test_after_the_last_tag_they_begin_again() -> None:
    every = [tags_of(page) for page in range(1, 200)]
    assert all(len(set(tags)) == 8 and max(tags) < len(CODES) for tags in every)
    assert len({*every[:73]}) == 73 and every[73] == every[0]


def test_more_students_than_values_is_refused_before_anything_is_drawn(tmp_path: Path) -> None:
    few = TEXT.replace(
        "vary: {AB: 24 mm .. 40 mm by 2 mm, phi: 0 deg .. 355 deg by 5 deg, omega: 8 rad/s cw .. 12 rad/s "
        "cw by 0.5 rad/s}",
        "vary: {phi: 20 deg .. 70 deg by 5 deg}",
    )
    with pytest.raises(VecpolyError, match=r"of 11 sets of values some \d+ pass, for 60 students"):
        made(tmp_path / "hw", people(range(60)), few)


def test_a_class_on_other_paper_than_a4_is_refused_for_its_tags_have_their_places_there(tmp_path: Path) -> None:
    with pytest.raises(NotAskedError, match="take `format` out of `sheet`"):
        made(tmp_path / "hw", people(range(2)), TEXT.replace("scales: null", "sheet: {format: letter}"))


def test_values_are_spread_over_their_ranges(whole: tuple[Path, Made]) -> None:
    register: Register = whole[1].register
    drawn = {tuple(part.values.values()) for sheet in register.sheets for part in sheet.parts}
    assert len(drawn) == len(FOUR)
    assert np.ptp([float(values[0].split()[0]) for values in drawn]) >= 4
