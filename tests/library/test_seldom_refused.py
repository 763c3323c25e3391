"""Claims about limits: what is just within is taken, what is just beyond is refused, and both languages tell the same
numbers."""

from __future__ import annotations

import re
from typing import Any

import pytest

from vecpoly.devices.base import Device
from vecpoly.errors import MobilityError, ProblemFileError
from vecpoly.mechanism.groups import assur
from vecpoly.mechanism.model import FRAME, Link, Mechanism, Revolute
from vecpoly.problem.load import loads

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
    kind: str, data: str, within: tuple[float, ...], beyond: tuple[float, ...]
) -> None:
    for angle in within:
        subject = loads(DEVICE.format(kind=kind, data=data.format(angle))).subject
        assert isinstance(subject, Device) and subject.kind == kind
    for angle in beyond:
        with pytest.raises(ProblemFileError, match=re.escape(f"= {angle} deg")) as refused:
            loads(DEVICE.format(kind=kind, data=data.format(angle)))
        (fault,) = refused.value.faults
        assert fault.code == "out-of-range"
        assert re.findall(r"[\d.]+", fault.words.zh) == re.findall(r"[\d.]+", re.sub(r"\.$", "", fault.words.en))


def test_many_links_without_their_drive_are_refused_before_all_their_sets_are_tried(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    links = tuple(Link(name=str(i), points={f"P{i}": 0j, f"P{i + 1}": 1 + 0j}) for i in range(1, 25))
    joints = tuple(Revolute(point=f"P{i}", a=str(i), b=str(i - 1) if i > 1 else FRAME) for i in range(1, 25))
    tried, group = list[tuple[str, ...]](), assur._group

    def counted(*args: Any) -> assur.Group | None:
        tried.append(args[1])
        return group(*args)

    monkeypatch.setattr(assur, "MOST", 400)
    monkeypatch.setattr(assur, "_group", counted)
    with pytest.raises(MobilityError, match="form no Assur group"):
        assur.decompose(Mechanism(frame={"P1": 0j}, links=links, joints=joints, drives=()))
    assert len(tried) == 400
