"""Claims about the command as a process: exit codes, pipes, signals, and what it imports."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.laws import few

ROOT = Path(__file__).parents[2]
HEAVY = ("matplotlib", "reportlab", "shapely", "jinja2", "pypdfium2",
         "vecpoly.oracle.synthesis.registry", "vecpoly.oracle.devices.registry")  # fmt: skip


def command(
    *words: str, cwd: Path | None = None, env: dict[str, str] | None = None
) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([sys.executable, "-m", "vecpoly", *words], capture_output=True, cwd=cwd, check=False,
                          env={**os.environ, **(env or {})}, timeout=120)  # fmt: skip


def test_version_and_help_leave_with_0() -> None:
    assert command("--version").stdout.startswith(b"vecpoly ")
    assert b"report" in command("--help").stdout


def test_a_refusal_leaves_with_2_and_no_traceback() -> None:
    done = command("solve", "no-such-problem")
    assert done.returncode == 2 and done.stdout == b""
    assert done.stderr.startswith(b"vecpoly: no problem 'no-such-problem'") and done.stderr.count(b"\n") == 1


@pytest.fixture(scope="module")
def piped() -> subprocess.CompletedProcess[bytes]:
    """Several problems solved into a pipe, where the locale knows ASCII alone."""
    ascii_only = {"LC_ALL": "C", "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    return command("solve", "3-9", "3-14", "3-8", "--lang", "zh", env=ascii_only)


def test_output_is_utf_8_whatever_the_locale(piped: subprocess.CompletedProcess[bytes]) -> None:
    assert piped.returncode == 0 and "ω_3" in piped.stdout.decode() and "顺时针" in piped.stdout.decode()


def test_piped_output_has_no_progress_bar_and_no_escape_codes(piped: subprocess.CompletedProcess[bytes]) -> None:
    assert piped.stderr == b"" and b"\x1b" not in piped.stdout


@pytest.mark.skipif(sys.platform == "win32", reason="pipes of another kind")
def test_a_reader_that_goes_away_is_met_with_silence() -> None:
    read, write = os.pipe()
    os.close(read)
    process = subprocess.Popen([sys.executable, "-m", "vecpoly", "list"], stdout=write, stderr=subprocess.PIPE)
    os.close(write)
    _, said = process.communicate(timeout=60)
    assert said == b"" and process.returncode == 0


@pytest.mark.skipif(sys.platform == "win32", reason="a shell of another kind")
@pytest.mark.parametrize("words", few(["solve 3-9 --json -", "list", "--help"], 2))
def test_closed_streams_are_no_error(words: str) -> None:
    done = subprocess.run(
        ["sh", "-c", f'exec "$0" -m vecpoly {words} >&-', sys.executable],
        stderr=subprocess.PIPE,
        check=False,
        timeout=60,
    )
    assert done.returncode == 0 and done.stderr == b""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("words", few(["list", "--help", "--version"], 2))
def test_a_full_disk_behind_the_output_is_told_in_a_line(words: str) -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "vecpoly", words], stdout=full, stderr=subprocess.PIPE, check=False, timeout=60
        )
    assert done.returncode == 2 and done.stderr == b"vecpoly: No space left on device\n"


@pytest.fixture
def heard() -> Iterator[None]:
    """Ctrl-C is heard by children, also where the tests run in the background of a shell that has it ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("heard")
@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to send")
def test_ctrl_c_leaves_with_130_and_nothing_half_written(tmp_path: Path) -> None:
    many = ["5-1", "3-5", "3-8", "3-10", "3-11", "3-12", "3-14", "A-16", "A-26", "A-27", "A-30", "B-24"]
    words = ["-m", "vecpoly", "report", *many, "-o", str(tmp_path), "--jobs", "1"]
    process = subprocess.Popen([sys.executable, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    while not any(tmp_path.glob("*.pdf")):  # past start-up, in the middle of drawing
        assert process.poll() is None
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130 and b"Traceback" not in said
    assert not [p for p in tmp_path.iterdir() if p.suffix != ".pdf"]


@pytest.mark.usefixtures("heard")
@pytest.mark.skipif(sys.platform == "win32", reason="no signal that ends a process")
def test_ctrl_c_leaves_with_130_wherever_it_was_met(tmp_path: Path) -> None:
    assert interrupted(tmp_path, "exec('signal.raise_signal(signal.SIGINT)')") == (130, b"")  # as dataclasses are made
    assert interrupted(tmp_path, "signal.raise_signal(signal.SIGINT)") == (130, b"")


@pytest.mark.skipif(sys.platform == "win32", reason="no signal that ends a process")
def test_ctrl_c_after_the_work_is_done_changes_nothing(tmp_path: Path) -> None:
    assert interrupted(tmp_path, "atexit.register(signal.raise_signal, signal.SIGINT)") == (0, b"")


def interrupted(folder: Path, where: str) -> tuple[int, bytes]:
    """How the program leaves whose command does this: exit code, and what it says."""
    lines = ("import atexit, signal, vecpoly.cli", "from vecpoly.__main__ import main", "",
             f"vecpoly.cli.main = lambda: {where}", "main()")  # fmt: skip
    (folder / "command.py").write_text("\n".join(lines), encoding="utf-8")
    done = subprocess.run([sys.executable, "-m", "command"], cwd=folder, stderr=subprocess.PIPE, check=False,
                          env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=60)  # fmt: skip
    return done.returncode, done.stderr


def test_solve_imports_nothing_it_does_not_need() -> None:
    code = (
        "import sys; from typer.testing import CliRunner; from vecpoly.cli import app\n"
        "assert CliRunner().invoke(app, ['solve', '3-9']).exit_code == 0\n"
        f"print([name for name in {(*HEAVY, 'vecpoly.cycle')!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_the_command_line_itself_is_light() -> None:
    code = (
        "import sys, vecpoly.cli; print([n for n in ('numpy', 'pydantic', 'ruamel.yaml', 'pint', 'rich.table') "
        "if n in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
