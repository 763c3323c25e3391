"""Shards of a class, each in a folder of its own: gathered only where all are there, whole and of one class."""

from __future__ import annotations

import json
import shlex
import shutil
import subprocess
from collections.abc import Callable, Sequence
from contextlib import chdir
from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import Workbook
from typer.testing import CliRunner

import vecpoly
from tests.batch.homework import FOUR, TEXT, files, ordered, piloted
from vecpoly.batch.classwork import Made, Order, make_class
from vecpoly.batch.gather import gather
from vecpoly.batch.register import read_register
from vecpoly.batch.run.manifest import SHARDS, manifests
from vecpoly.batch.run.runners import Here
from vecpoly.cli.app import app
from vecpoly.errors import VecpolyError

CLASS, COUNT = FOUR[::-1], 2
ALIKE = TEXT[: TEXT.index("    vary:")]  # everybody the same numbers: no pilot is drawn by three programs


def order_of(out: Path) -> Order:
    return ordered(out, CLASS)


@pytest.fixture(scope="module")
def shards(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    """Each made on a machine of its own, that sees no other's folder."""
    folder = tmp_path_factory.mktemp("shards")
    with piloted():
        for n in range(COUNT):
            make_class(order_of(folder / str(n)), Here(), lambda *_: None, (n, COUNT))
    return tuple(folder / str(n) for n in range(COUNT))


@pytest.fixture
def copies(shards: tuple[Path, ...], tmp_path: Path) -> tuple[Path, ...]:
    return tuple(Path(shutil.copytree(one, tmp_path / one.name)) for one in shards)


def gathered(folders: Sequence[Path], out: Path, order: Order | None = None) -> None:
    gather(order or order_of(out), folders, Here(), lambda *_: None)


def test_folders_of_machines_together_are_the_whole_in_whatever_order_the_roster_is_and_nothing_is_written_anew(
    shards: tuple[Path, ...], whole: tuple[Path, Made], tmp_path: Path
) -> None:
    calls: list[str] = []

    def told(doing: object, done: int, of: int) -> None:
        calls.append(f"{done}/{of}")

    gather(order_of(tmp_path / "hw"), shards[::-1], Here(), told)
    assert files(tmp_path / "hw") == files(whole[0])
    assert all(one.split("/")[0] == one.split("/")[1] for one in calls)  # all was on file when it was looked for


def test_a_manifest_tells_seeds_version_and_the_digest_of_every_file(shards: tuple[Path, ...]) -> None:
    (one,) = manifests(shards[1])
    assert (one.head.vecpoly, one.head.assignment, one.name) == (vecpoly.__version__, "hw3", "1/2")
    assert [line.number for line in one.lines] == ["20230001", "20230003"]
    for line in one.lines:
        assert line.seeds["block"].startswith(f"hw3|block|{line.number}||") and len(line.files) == 2
        assert all(len(digest) == 64 for digest in line.files.values())


def rewritten(folder: Path, change: Callable[[list[dict[str, object]]], None]) -> None:
    file = next((folder / SHARDS).glob("*.jsonl"))
    rows = [json.loads(row) for row in file.read_text("utf-8").splitlines()]
    change(rows)
    file.write_text("".join(json.dumps(row) + "\n" for row in rows), "utf-8")


def test_a_missing_shard_is_named_with_the_option_that_makes_it(shards: tuple[Path, ...], tmp_path: Path) -> None:
    with pytest.raises(VecpolyError, match=r"shards are missing: --shard 1/2; run them"):
        gathered(shards[:1], tmp_path / "hw")
    with pytest.raises(VecpolyError, match="no shards; make them by --shard"):
        gathered((tmp_path,), tmp_path / "hw")


def test_a_file_that_was_changed_is_refused_with_both_digests(copies: tuple[Path, ...], tmp_path: Path) -> None:
    file = next((copies[0] / "questions").glob("*.pdf"))
    file.write_bytes(file.read_bytes()[:-1] + b"?")  # of the same size
    with pytest.raises(VecpolyError, match=r"SHA-256 is \w{12}, shard 0/2 wrote \w{12}; run --shard 0/2 again"):
        gathered(copies, tmp_path / "hw")


def test_a_student_in_two_shards_or_in_none_is_refused(copies: tuple[Path, ...], tmp_path: Path) -> None:
    def twice(rows: list[dict[str, object]]) -> None:
        rows.append(rows[-1] | {"number": "20230000", "files": {}})

    rewritten(copies[1], twice)
    with pytest.raises(VecpolyError, match="student 20230000 is in shards 0/2 and 1/2"):
        gathered(copies, tmp_path / "hw")
    rewritten(copies[1], lambda rows: rows.__delitem__(slice(1, None)))
    with pytest.raises(VecpolyError, match="no shard has student 20230003, 20230001"):
        gathered(copies, tmp_path / "hw")


def test_a_shard_that_was_made_twice_must_have_been_made_alike(copies: tuple[Path, ...], tmp_path: Path) -> None:
    again = Path(shutil.copytree(copies[0], tmp_path / "again"))
    gathered((*copies, again), tmp_path / "hw")
    rewritten(again, lambda rows: rows[1].update(values="other"))
    with pytest.raises(VecpolyError, match=r"shard 0/2 is not the same .* \(student 20230000\)"):
        gathered((*copies, again), tmp_path / "two")


def test_a_class_that_is_not_that_of_its_shards_leaves_no_register(copies: tuple[Path, ...], tmp_path: Path) -> None:
    rewritten(copies[1], lambda rows: rows[1].update(values="other"))
    with pytest.raises(VecpolyError, match=r"student \d+ has other values than in the shard"):
        gathered(copies, tmp_path / "hw")
    assert not (tmp_path / "hw" / "register.json").exists()


@pytest.mark.parametrize(
    ("name", "said"), [("version", f"vecpoly '{vecpoly.__version__}', not 'next'"), ("students", "has roster")]
)
def test_shards_of_another_program_or_roster_are_refused(
    shards: tuple[Path, ...], tmp_path: Path, name: str, said: str
) -> None:
    other = {"version": "next"} if name == "version" else {"students": CLASS[:-1]}
    with pytest.raises(VecpolyError, match=f"{said}.*run --shard 0/2 again"):
        gathered(shards, tmp_path / "hw", replace(order_of(tmp_path / "hw"), **other))


def test_a_broken_manifest_is_named(copies: tuple[Path, ...], tmp_path: Path) -> None:
    file = next((copies[0] / SHARDS).glob("*.jsonl"))
    file.write_bytes(file.read_bytes()[:100])
    with pytest.raises(VecpolyError, match=r"0-of-2\.jsonl: no manifest of a shard; run that --shard again"):
        gathered(copies, tmp_path / "hw")


def test_the_make_example_of_the_manual_makes_the_class(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "docs" / "class.md").read_text(encoding="utf-8")
    (tmp_path / "Makefile").write_text(text.partition("```make\n")[2].partition("```")[0], encoding="utf-8")
    (tmp_path / "hw3.yaml").write_text(ALIKE, encoding="utf-8")
    book = Workbook()
    page = book.active
    assert page is not None
    for row in (("学号", "姓名", "班级"), *((one.number, one.name, one.team) for one in CLASS[:2])):
        page.append(row)
    book.save(tmp_path / "名单.xlsx")
    words = ["make", "--no-print-directory", "--dry-run", "N=2", "CLASS=class hw3.yaml --roster 名单.xlsx -o hw/"]
    told = subprocess.run([*words, "hw/register.json"], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert told.count("--shard") == 2 and told.count("--gather") == 1
    with chdir(tmp_path):
        for line in told.splitlines():
            done = CliRunner().invoke(app, shlex.split(line))
            assert done.exit_code == 0, (line, done.output)
    assert len(read_register(tmp_path / "hw").sheets) == 2
