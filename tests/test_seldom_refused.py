"""Claims about limits: what is just within is taken, what is just beyond is refused, and both languages tell the same numbers."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest

from vecpoly.devices.base import Device
from vecpoly.errors import ProblemFileError, VecpolyError
from vecpoly.mechanism import assur
from vecpoly.problem.load import loads
from vecpoly.solution import solve

DEVICE = "id: x\ntitle: t\ndevice: {kind}\ndata: {{{data}}}\n"


@pytest.mark.parametrize(("kind", "data", "within", "beyond"), [
    ("wedges", "alpha: 60 deg, beta: {} deg, Q: 1000 N, f: 0.15", (0.5, 89.5), (-0.5, 0, 90, 90.5)),
    ("wedges", "alpha: {} deg, beta: 70 deg, Q: 1000 N, f: 0.15", (0.5, 109.5), (-0.5, 0, 110, 110.5)),
    ("incline", "alpha: {} deg, beta: 45 deg, Q: 10 N, f: 0.1", (0.5, 89.5), (0, 90, 90.5)),
    ("incline", "beta: {} deg, Q: 10 N, f: 0.1", (-89.5, 89.5), (-90.5, -90, 90, 90.5)),
    ("wedge-clamp", "alpha: {} deg, R: 10 N, f: 0.1", (0.5, 89.5), (0, 90, 90.5)),
    ("ring-spring", "alpha: {} deg, Q: 10 N, f: 0.1", (0.5, 89.5), (0, 90, 90.5)),
    ("vee-guide", "theta: {} deg, G: 10 N, f: 0.1, l1: 120 mm, l2: 180 mm", (5, 85), (4.5, 85.5)),
    ("screw-jack", "d: 24 mm, d1: 20 mm, p: 4 mm, D: 30 mm, d0: 15 mm, l: 300 mm, f: 0.1, F: 100 N, beta: {} deg",
     (0.5, 59.5), (0, 60, 60.5)),
])  # fmt: skip
def test_angles_of_a_device_are_taken_up_to_their_limits_and_no_further(
        kind: str, data: str, within: tuple[float, ...], beyond: tuple[float, ...]) -> None:
    for angle in within:
        subject = loads(DEVICE.format(kind=kind, data=data.format(angle))).subject
        assert isinstance(subject, Device) and subject.kind == kind
    for angle in beyond:
        with pytest.raises(ProblemFileError, match=re.escape(f"= {angle} deg")) as refused:
            loads(DEVICE.format(kind=kind, data=data.format(angle)))
        (fault,) = refused.value.faults
        assert fault.code == "out-of-range"
        assert re.findall(r"[\d.]+", fault.words.zh) == re.findall(r"[\d.]+", re.sub(r"\.$", "", fault.words.en))


def test_many_links_without_their_drive_are_refused_before_all_their_sets_are_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    letters = "ABCDEFGHIJKLMNOPQRSTUVWXY"
    frame = "{A: [0 mm, 0 mm], Y: [900 mm, 0 mm]}"
    links = ", ".join(f"{i}: {{{a}{b}: 50 mm}}" for i, (a, b) in enumerate(pairwise(letters), 1))
    text = f"id: x\ntitle: t\nframe: {frame}\nlinks: {{{links}}}\ninput: {{link: 1, phi: 30 deg, omega: 5 rad/s}}\nfind: [omega_2]\n"
    monkeypatch.setattr(assur, "MOST", 400)
    with pytest.raises(VecpolyError, match=r"F = |form no Assur group"):
        solve(loads(text), repeats=0)
