"""Claims about what is written: whole or not at all, and never over what is read or over what is no file."""

from __future__ import annotations

import os
import stat
import sys
import threading
import time
from collections.abc import Callable
from datetime import datetime, timedelta, timezone, tzinfo
from pathlib import Path
from types import SimpleNamespace

import pytest
from typer.testing import CliRunner, Result

from vecpoly.cli import app
from vecpoly.cycle import cycle, table, xlsx_bytes
from vecpoly.foundation import files
from vecpoly.foundation.files import write_whole
from vecpoly.problem.load import load
from vecpoly.report.document import report_bytes
from vecpoly.solution import solve

Run = Callable[..., Result]
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="files of another kind")


@pytest.fixture(params=["nameless", "beside"])
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Both ways of writing: with files that have no name yet, and without."""
    if request.param == "beside":
        monkeypatch.setattr(files, "_DESCRIPTORS", "/nowhere")
    return str(request.param)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, list(words))


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_a_new_file_is_alone_in_its_folder_and_has_the_umask_s_permissions(way: str, tmp_path: Path) -> None:
    write_whole(tmp_path / "deep" / "x.txt", b"1")
    assert names(tmp_path / "deep") == {"x.txt"}
    (tmp_path / "plain").touch()
    assert (tmp_path / "deep" / "x.txt").stat().st_mode == (tmp_path / "plain").stat().st_mode


@POSIX
def test_an_old_file_keeps_its_permissions(way: str, tmp_path: Path) -> None:
    (tmp_path / "x").touch(0o600)
    write_whole(tmp_path / "x", b"2")
    assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o600 and names(tmp_path) == {"x"}


@POSIX
def test_a_link_stays_a_link_and_its_file_is_the_new_one(way: str, tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"old")
    (tmp_path / "link").symlink_to("x")
    write_whole(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "x").read_bytes() == b"new"


def piped(pipe: Path, write: Callable[[], object]) -> bytes:
    """What is heard at the other end of a pipe while something is written."""
    heard: list[bytes] = []
    reader = threading.Thread(target=lambda: heard.append(pipe.read_bytes()), daemon=True)
    reader.start()
    assert write() in (0, pipe)
    reader.join(20)  # it waits for ever at a pipe that nobody writes into
    return b"".join(heard)


@POSIX
def test_a_pipe_is_written_into_and_stays_a_pipe(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    heard = piped(tmp_path / "pipe", lambda: write_whole(tmp_path / "pipe", b"through"))
    assert heard == b"through" and (tmp_path / "pipe").is_fifo()


def test_what_stands_there_is_not_overwritten_by_a_file_that_must_be_new(way: str, tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"mine")
    with pytest.raises(FileExistsError):
        write_whole(tmp_path / "x", b"yours", new=True)
    assert (tmp_path / "x").read_bytes() == b"mine" and names(tmp_path) == {"x"}


@POSIX
def test_a_name_as_long_as_the_system_allows_can_be_written(way: str, tmp_path: Path) -> None:
    assert write_whole(tmp_path / ("n" * 255), b"1").is_file()


class Full:
    """A disk that is full after the first byte."""

    def __call__(self, *_: object) -> None:
        raise OSError(28, "No space left on device")


@pytest.mark.parametrize("there", [False, True])
def test_a_full_disk_leaves_what_was_there(
    way: str, there: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if there:
        (tmp_path / "x").write_bytes(b"old")
    monkeypatch.setattr(files, "_fill", Full())
    with pytest.raises(OSError, match=r"No space left.*x'"):
        write_whole(tmp_path / "x", b"new")
    assert names(tmp_path) == ({"x"} if there else set())
    assert not there or (tmp_path / "x").read_bytes() == b"old"


def test_what_a_killed_run_left_is_cleared_away_and_what_another_is_writing_is_not(tmp_path: Path) -> None:
    old, fresh, other = (tmp_path / name for name in (".vecpoly-0.tmp", ".vecpoly-1.tmp", ".other.tmp"))
    for path in (old, fresh, other):
        path.touch()
    for path in (old, other):
        os.utime(path, (time.time() - 2 * files.ABANDONED,) * 2)
    write_whole(tmp_path / "x", b"1")
    assert names(tmp_path) == {"x", fresh.name, other.name}


@pytest.mark.parametrize(
    "words",
    [
        ("solve", "in.yaml", "--json", "in.json"),
        ("exact", "in.yaml", "--json", "in.json"),
        ("check", "in.yaml", "--json", "in.json"),
        ("play", "in.yaml", "-o", "in.html"),
        ("draw", "in.yaml", "-o", "in.svg"),
        ("cycle", "in.yaml", "-o", "in.csv"),
        ("cycle", "in.yaml", "--plot", "in.svg"),
        ("report", "in.yaml", "-o", "in.pdf"),
        ("check", "3-9", "--table", "in.json", "--json", "in.json"),
    ],
)
def test_an_output_that_is_read_too_is_refused_before_any_work(
    run: Run, tmp_path: Path, words: tuple[str, ...]
) -> None:
    text = load("3-9").text.encode()
    (tmp_path / "in.yaml").write_bytes(text)
    target = tmp_path / words[-1]
    target.hardlink_to(tmp_path / "in.yaml")
    result = run(*words)
    assert result.exit_code == 2 and "is read by this command" in result.stderr
    assert target.read_bytes() == text


def test_a_file_that_is_only_extended_is_spared_too(run: Run, tmp_path: Path) -> None:
    (tmp_path / "base.json").write_text(load("3-9").text, encoding="utf-8")
    (tmp_path / "base.yaml").hardlink_to(tmp_path / "base.json")
    (tmp_path / "on.yaml").write_text("id: on\nextends: base.yaml\n", encoding="utf-8")
    assert "is read by this command" in run("solve", "on.yaml", "--json", "base.json").stderr


@pytest.mark.parametrize(
    "words",
    [
        ("solve", "3-9", "--json", "x.yaml"),
        ("schema", "-o", "x.yaml"),
        ("report", "3-9", "-o", "x.docx"),
        ("play", "3-9", "-o", "x.txt"),
        ("draw", "3-9", "-o", "x.gif"),
        ("cycle", "3-9", "-o", "x.txt"),
        ("cycle", "3-9", "--plot", "x.bmp"),
    ],
)
def test_an_ending_that_is_not_known_is_refused_and_nothing_is_made(
    run: Run, tmp_path: Path, words: tuple[str, ...]
) -> None:
    result = run(*words)
    assert result.exit_code == 2 and "; end the file's name so" in result.stderr and names(tmp_path) == set()


@pytest.mark.parametrize(
    "words",
    [
        ("solve", "3-9", "--json", ""),
        ("report", "3-9", "-o", ""),
        ("draw", "3-9", "-o", ""),
        ("cycle", "3-9", "--plot", " "),
    ],
)
def test_an_empty_name_is_refused(run: Run, tmp_path: Path, words: tuple[str, ...]) -> None:
    result = run(*words)
    assert result.exit_code == 2 and "is empty" in result.stderr and names(tmp_path) == set()


@pytest.mark.parametrize(
    ("words", "begins"),
    [
        (("report", "3-9", "-o", "-"), b"%PDF"),
        (("draw", "3-9", "-o", "-"), b"<svg"),
        (("play", "3-9", "--places", "0", "-o", "-"), b"<!"),
        (("cycle", "3-9", "-n", "5", "-o", "-"), b"phi_1"),
        (("schema", "-o", "-"), b"{"),
        (("solve", "3-9", "--json", "-"), b"{"),
    ],
)
def test_a_dash_is_standard_output(run: Run, tmp_path: Path, words: tuple[str, ...], begins: bytes) -> None:
    result = run(*words)
    assert result.exit_code == 0 and result.stdout_bytes.lstrip()[:20].startswith(begins) and names(tmp_path) == set()


@POSIX
def test_a_report_goes_into_a_pipe(run: Run, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    heard = piped(tmp_path / "pipe", lambda: run("report", "5-1", "-o", "pipe").exit_code)
    assert heard.startswith(b"%PDF") and (tmp_path / "pipe").is_fifo()


class Later(datetime):
    """The clock an hour on: the hour of a workbook's properties."""

    @classmethod
    def now(cls, tz: tzinfo | None = None) -> datetime:  # type: ignore[override]
        return datetime.now(tz) + timedelta(hours=1)


def test_a_workbook_has_the_same_bytes_from_run_to_run(monkeypatch: pytest.MonkeyPatch) -> None:
    made = table(cycle(load("3-9"), 5))
    first = xlsx_bytes(made, "3-9", "en")
    later = time.time() + 3600  # the hour of its archive
    monkeypatch.setattr("time.time", lambda: later)
    monkeypatch.setattr("openpyxl.packaging.core.datetime", SimpleNamespace(datetime=Later, timezone=timezone))
    assert xlsx_bytes(made, "3-9", "en") == first


def test_threads_write_the_pdfs_that_one_alone_writes() -> None:
    solutions = [solve(load(name), repeats=0) for name in ("5-1", "2-9")]
    alone = [report_bytes([one]) for one in solutions]
    together: list[bytes] = [b""] * 4

    def write(i: int) -> None:
        together[i] = report_bytes([solutions[i % 2]])

    threads = [threading.Thread(target=write, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone * 2
