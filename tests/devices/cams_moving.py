"""Cams of any law, and the mechanism that each of them drives, written as its problem file would be."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from tests.cam_cases import device
from vecpoly.devices.cams.cam import Cam
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

LAWS = ("parabolic", "cosine", "sine", "3-4-5")
LINKS = {
    "roller": ("2: {block: B}, 3: {disc: B, radius: 9 mm}", "[2 slides on x = 5 mm, 1 touches 3 at T]"),
    "knife": ("2: {block: B, disc: B, radius: 0 mm}", "[2 slides on x = 5 mm, 1 touches 2 at T]"),
    "face": (
        "2: {block: F, face: {through: F, angle: -90 deg from line}}",
        "[2 slides on x = 8 mm, 1 touches 2 at T right of the face]",
    ),
    "right arm": ("2: {AB: 70 mm}, 3: {disc: B, radius: 8 mm}", "[1 touches 3 at T]"),
    "left arm": ("2: {AB: 70 mm}, 3: {disc: B, radius: 8 mm}", "[1 touches 3 at T]"),
    "right face arm": ("2: {AE: 80 mm, face: {through: A, left: -6 mm}}", "[1 touches 2 at T left of the face]"),
    "left face arm": ("2: {AE: 80 mm, face: {through: A, left: 6 mm}}", "[1 touches 2 at T right of the face]"),
}
FOLLOWERS: dict[str, dict[str, Any]] = {
    "roller": {"roller": "9 mm", "offset": "5 mm"},
    "knife": {"knife": "yes", "offset": "5 mm"},
    "face": {"flat": "yes"},
    "right arm": {"roller": "8 mm", "arm": {"OA": "80 mm", "AB": "70 mm"}},
    "left arm": {"roller": "8 mm", "arm": {"OA": "80 mm", "AB": "70 mm", "side": "left"}},
    "right face arm": {"flat": "yes", "arm": {"OA": "90 mm", "face": "6 mm"}},
    "left face arm": {"flat": "yes", "arm": {"OA": "90 mm", "face": "6 mm", "side": "left"}},
}
FRAMES = {"right arm": ", A: [80 mm, 0 mm]", "left arm": ", A: [-80 mm, 0 mm]"}
FRAMES |= {"right face arm": ", A: [90 mm, 0 mm]", "left face arm": ", A: [-90 mm, 0 mm]"}


def moved(follower: str, motion: str, turns: str, phi: float, *, omega: float = 7.0, alpha: float = 3.0) -> Problem:
    """The mechanism whose cam stands at this angle (deg); r0 = 45 mm."""
    links, joints = LINKS[follower]
    end = "F" if follower == "face" else "E" if "face arm" in follower else "B"
    data = str(FOLLOWERS[follower]).replace("'", "")
    return loads(
        f"id: moved\ntitle: moved\nframe: {{O: [0 mm, 0 mm]{FRAMES.get(follower, '')}}}\n"
        f"links:\n  1: {{cam: {{about: O, follower: {data}, r0: 45 mm, turns: {turns}, motion: {motion}}}}}\n"
        + "".join(f"  {entry.strip()}\n" for entry in _entries(links))
        + f"joints: {joints}\ninput: {{link: 1, phi: {phi!r} deg, omega: {omega!r} rad/s ccw, "
        f"alpha: {alpha!r} rad/s^2}}\nfind: [v_{end}, a_{end}]\n"
    )


def _entries(links: str) -> list[str]:
    head, mark, rest = links.partition(", 3:")
    return [head, f"3:{rest}"] if mark else [head]


def cam_of(follower: str, motion: str, turns: str) -> Cam:
    """The cam by itself."""
    found = device("cam", follower=FOLLOWERS[follower], r0="45 mm", turns=turns, motion=_listed(motion))
    assert isinstance(found, Cam)
    return found


def _listed(motion: str) -> list[str]:
    return [entry.strip() for entry in motion.strip("[]").split(",")]


@st.composite
def motions(draw: st.DrawFn, swings: bool) -> str:
    """A rise, a dwell, a return and a dwell; gentle enough for every follower here."""
    by = f"{draw(st.integers(6, 12))} deg" if swings else f"{draw(st.integers(5, 12))} mm"
    up, back = draw(st.integers(100, 130)), draw(st.integers(100, 130))
    rest = draw(st.integers(10, 40))
    laws = [draw(st.sampled_from(LAWS)) for _ in range(2)]
    last = 360 - up - back - rest
    return f"[rise {by} in {up} deg {laws[0]}, dwell {rest} deg, return in {back} deg {laws[1]}, dwell {last} deg]"
