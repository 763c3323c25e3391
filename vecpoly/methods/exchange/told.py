"""How the motion of the link that is thought to drive was found, in words."""

from __future__ import annotations

from math import degrees, floor, log10, pi

import numpy as np

from ...algebra.quantity import number
from ...mechanism.model import Drive
from ...words import Words
from ..registry import Stage
from .trial import Trial

LEAST = 3  # figures of a number that is carried on
ROUNDING = 1e-12  # of the accelerations that the velocity alone makes


def said(trial: Trial, rated: Drive) -> dict[Stage, Words]:
    """What is said at the beginning of each stage."""
    return {
        Stage.POSITION: _placed(trial, rated),
        Stage.VELOCITY: _rated(trial.drive, rated),
        Stage.CENTRES: _rated(trial.drive, rated),
        Stage.ACCELERATION: _accelerated(trial, rated),
    }


def _placed(trial: Trial, rated: Drive) -> Words:
    """The position, by trial."""
    drive, link, symbol = trial.drive, rated.link, "s" if rated.slide else "φ"
    place = _shown(rated.position, rated.slide)
    tried, tried_en = _tried(trial, rated)
    return Words(
        f"输入加在活动构件 {drive.on}、{drive.link} 之间：改取构件 {link} 为假想原动件，"
        f"取一系列 ${symbol}_{link}$ 逐组作图试凑{tried}，当 ${symbol}_{link}$ = {place} 时输入恰为给定的 "
        f"{_shown(drive.position, drive.slide)}。",
        f"The input acts between the moving links {drive.on} and {drive.link}: let link {link} "
        f"drive instead and draw the groups for trial values of ${symbol}_{link}${tried_en}; with "
        f"${symbol}_{link}$ = {place} the input has its given "
        f"{_shown(drive.position, drive.slide)}.",
    )


def _units(drive: Drive) -> tuple[str, str]:
    """Of its rate, and of its acceleration."""
    return ("m/s", "m/s²") if drive.slide else ("rad/s", "rad/s²")


def _factor(drive: Drive, rated: Drive) -> float:
    """The input's rate over that of the link."""
    return drive.rate / rated.rate if rated.rate else 0.0


def _rated(drive: Drive, rated: Drive) -> Words:
    """The velocity, by proportion."""
    link, rate = rated.link, "v" if rated.slide else "ω"
    own, given = _units(rated)[0], _units(drive)[0]
    ratio = (
        f"{number(_factor(drive, rated), 4)} {given}",
        f"{number(drive.rate, 4)} {given}",
        f"${rate}_{link}$ = {_carried_on(rated.rate)} {own}",
    )
    return Words(
        f"各速度与 ${rate}_{link}$ 成正比：先取 ${rate}_{link}$ = 1 {own} 试作速度多边形，"
        f"得输入的速度为 {ratio[0]}；实际为 {ratio[1]}，故 {ratio[2]}。",
        f"All velocities are proportional to ${rate}_{link}$: a trial polygon with "
        f"${rate}_{link}$ = 1 {own} gives the input the rate {ratio[0]}; it is "
        f"{ratio[1]}, so {ratio[2]}.",
    )


def _carried_on(value: float) -> str:
    """The number as the lines that go on with it have it: three figures at least, 0.0330."""
    text = number(value, 4)
    missing = LEAST - len(text.lstrip("−0.").replace(".", ""))
    return text if missing <= 0 or "×" in text else f"{text}{'' if '.' in text else '.'}{'0' * missing}"


def _accelerated(trial: Trial, rated: Drive) -> Words:
    """The acceleration: what is missing at α = 0, by the same proportion."""
    drive, link, rate = trial.drive, rated.link, "a" if rated.slide else "α"
    own, given = _units(rated)[1], _units(drive)[1]
    size, factor = rated.rate**2 / (trial.mech.scale if rated.slide else 1.0), _factor(drive, rated)
    even = (
        f"{_beside(drive.accel - rated.accel * factor, size * factor)} {given}",
        f"{number(drive.accel, 4)} {given}",
        f"${rate}_{link}$ = {_beside(rated.accel, size)} {own}",
    )
    ratio = _by_which(rate, link, f"{number(factor, 4)} {given}", own) if factor else ("", "")
    return Words(
        f"先取 ${rate}_{link}$ = 0 试作加速度多边形，得输入的加速度为 {even[0]}，实际为 {even[1]}；"
        f"差额与 ${rate}_{link}$ 成正比{ratio[0]}，故 {even[2]}。",
        f"A trial polygon with ${rate}_{link}$ = 0 gives the input the acceleration "
        f"{even[0]}; it is {even[1]}. The rest is proportional to ${rate}_{link}${ratio[1]}, so {even[2]}.",
    )


def _by_which(rate: str, link: str, per: str, own: str) -> tuple[str, str]:
    """The factor of the accelerations, which is that of the velocities: 0.52 m/s² for 1 rad/s²."""
    return (
        f"（比例系数同速度：${rate}_{link}$ 每 1 {own} 得 {per}）",
        f" by the factor of the velocities, {per} for ${rate}_{link}$ = 1 {own}",
    )


def _beside(value: float, size: float) -> str:
    """The number as it is printed; what is rounding beside this size is 0."""
    return number(value if abs(value) > ROUNDING * abs(size) else 0.0, 4)


def _tried(trial: Trial, rated: Drive) -> tuple[str, str]:
    """Two of the trials, at round places to either side of the one found."""
    step = 10.0 ** floor(log10(0.1 * trial.mech.scale)) if rated.slide else pi / 36
    near = step * round(rated.position / step)
    shown = [(at, trial.gap(at)) for at in (near - step, near + step)]
    told = [
        (_shown(at, rated.slide), _shown(trial.drive.position + gap, trial.drive.slide))
        for at, gap in shown
        if np.isfinite(gap)
    ]
    if not told:
        return "", ""
    zh = "，".join(f"{at} 时得 {got}" for at, got in told)
    return f"（{zh}）", " (" + ", ".join(f"{at} gives {got}" for at, got in told) + ")"


def _shown(position: float, slide: bool) -> str:
    """620 mm, or 52.5°: as near as paper shows it."""
    return f"{number(1e3 * position, 4)} mm" if slide else f"{number(degrees(position), 4)}°"
