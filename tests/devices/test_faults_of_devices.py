"""What is wrong in the data of a device is told at the line of the key, of several keys at all of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from vecpoly import load, loads
from vecpoly.errors import Fault, ProblemFileError

SEVERAL = {  # data, an entry after each bar; the keys that disagree
    "screw-jack": ("d: 24 mm | d1: 26 mm | p: 4 mm | D: 30 mm | d0: 15 mm | l: 300 mm | f: 0.1 | F: 90 N", {"d", "d1"}),
    "wedges": ("alpha: 80 deg | beta: 20 deg | Q: 100 N | f: 0.1 | f12: 0.2", {"f", "f12"}),
    "epicyclic": ("sun: 20 | planet: 22 | ring: 65 | m: 1 mm | omega_1: 10 rad/s", {"sun", "planet", "ring"}),
    "cam": (
        "follower: {roller: 10 mm, offset: 60 mm} | motion: [rise 30 mm in 180 deg sine, return in 180 deg sine] | "
        "r0: 50 mm",
        {"follower.offset", "r0"},
    ),
    "flywheel": ("M_d: 100 N*m | M_r: 100 N*m | n: 620 r/min | delta: 0.01", {"M_d", "M_r"}),
    "run-up": ("motor: [240 N*m, 1.5 N*m*s] | load: 300 N*m | J: 4 kg*m^2 | to: 95 %", {"motor", "load"}),
    "in-line-engine": (
        "cranks: [0 deg, 180 deg] | pitch: 90 mm | m: 1 kg | r: 42 mm | l: 40 mm | n: 900 r/min",
        {"r", "l"},
    ),
    "eccentric-clamp": (
        "R: 30 mm | e: 40 mm | theta: 20 deg | l: 100 mm | handle: 40 deg | F: 300 deg | Q: 90 N | f: 0 | closing: cw",
        {"R", "e"},
    ),
}


def fault_of(kind: str, written: str) -> tuple[Fault, dict[str, int]]:
    """What is told of these data, written a line each, and the lines of the keys."""
    data = written.split(" | ")
    head = ["id: mine", "title: mine", f"device: {kind}", "data:"]
    text = "\n".join([*head, *(f"  {entry}" for entry in data)])
    with pytest.raises(ProblemFileError) as refused:
        loads(text)
    return refused.value.faults[0], {entry.split(":")[0]: len(head) + n for n, entry in enumerate(data, start=1)}


@pytest.mark.parametrize("kind", SEVERAL)
def test_a_fault_of_several_keys_names_the_lines_of_all_of_them(kind: str) -> None:
    data, keys = SEVERAL[kind]
    fault, lines = fault_of(kind, data)
    assert fault.place
    told = {fault.path: fault.place, **dict(fault.beside)}
    assert {".".join(map(str, path[1:])) for path in told} == keys
    assert all(place.line == lines[str(path[1])] for path, place in told.items())
    assert fault.place.line == min(place.line for place in told.values())
    assert all(f"(line {place.line})" in fault.words.en for _, place in fault.beside)
    assert all(f"（第 {place.line} 行）" in fault.words.zh for _, place in fault.beside)
    assert [one["line"] for one in fault.as_json()["beside"]] == [place.line for _, place in fault.beside]


def test_keys_on_one_line_are_named_without_its_number_again() -> None:
    with pytest.raises(ProblemFileError) as refused:
        loads("id: mine\ntitle: mine\ndevice: wedges\ndata: {alpha: 80 deg, beta: 20 deg, Q: 9 N, f: 0.1, f12: 0.2}")
    assert "data.f, data.f12: write f" in str(refused.value)


def test_a_hole_of_which_the_disc_is_not_told_is_named() -> None:
    masses = "{1: {m: 5 kg, r: 20 mm, at: 0 deg}, 2: {hole: 5 mm, r: 12 mm, at: 20 deg}}"
    fault, lines = fault_of("rotor", f"correct: {{I: {{r: 50 mm}}}} | masses: {masses}")
    assert fault.path == ("data", "masses", "2", "hole")
    assert fault.place and fault.place.line == lines["masses"]
    fault, lines = fault_of(
        "rotor", "masses: {1: {m: 5 kg, r: 2 m, at: 0 deg}} | correct: {I: {r: 2 m, hole: through}}"
    )
    assert fault.path == ("data", "correct", "I", "hole")
    assert fault.place and fault.place.line == lines["correct"]


@pytest.mark.parametrize("teeth", ["20.5/80", "20/0", "-20/80", "20/80.25"])
def test_numbers_of_teeth_are_whole(teeth: str) -> None:
    shafts = "{1: {J: 1 kg*m^2, drives: 9 N*m}, 2: {J: 1 kg*m^2}}"
    fault, _ = fault_of("reduced-train", f"shafts: {shafts} | pairs: [1 to 2 by {teeth}] | to: 1")
    assert fault.path == ("data", "pairs", 0) and "whole" in fault.words.en and "正整数" in fault.words.zh


def test_a_key_of_the_problem_that_is_extended_is_told_with_its_file(tmp_path: Path) -> None:
    """What stands in the file at hand comes first, whatever its line."""
    base = "id: base\ntitle: t\ndevice: screw-jack\n"
    base += "data: {d1: 20 mm, d: 24 mm, p: 4 mm, D: 30 mm, d0: 15 mm, l: 300 mm, f: 0.1, F: 90 N}\n"
    (tmp_path / "base.yaml").write_text(base, encoding="utf-8")
    mine = "extends: base.yaml\nid: mine\ntitle: t\nstatement: s\ndata: {d: 18 mm}\n"
    (tmp_path / "mine.yaml").write_text(mine, encoding="utf-8")
    with pytest.raises(ProblemFileError) as refused:
        load(tmp_path / "mine.yaml")
    (fault,) = refused.value.faults
    assert fault.place and (fault.place.file, fault.place.line) == (str(tmp_path / "mine.yaml"), 5)
    assert "data.d, data.d1 (" in fault.words.en and "base.yaml, line 4, column 8): d = 18 mm" in fault.words.en
    (other,) = fault.as_json()["beside"]
    assert (other["path"], other["line"], other["column"]) == ("data.d1", 4, 8) and other["file"].endswith("base.yaml")


@pytest.mark.parametrize(
    ("kind", "written", "key"),
    [
        ("flywheel", "areas: [320, -320] | mu_A: 1 J/mm^2 | period: 360 deg | n: 600 r/min | delta: 0.02", "period"),
        ("flywheel", "areas: [320, -320] | mu_A: 1 J/mm^2 | n: 600 r/min | J: 9 kg*m^2 | shaft: 2 kg*m^2", "shaft"),
    ],
)
def test_a_key_that_belongs_to_others_is_told_at_its_own_line(kind: str, written: str, key: str) -> None:
    fault, lines = fault_of(kind, written)
    assert fault.path == ("data", key) and fault.place and fault.place.line == lines[key]
