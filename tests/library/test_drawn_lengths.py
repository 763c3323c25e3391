"""Claims about the vectors of every polygon of the library: each is worked out, as long as its step says, and every
point has its own."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from tests.drawn_library import desk_of, drawn, ids, standing
from tests.each import Later, each
from vecpoly import oracle
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Step, View
from vecpoly.mechanism.model import Prismatic
from vecpoly.names import At, Kind, parse_rel

IDS = Later(lambda: ids(view=View.ACCELERATION))
HALF = 0.05 + 1e-9  # mm: lengths to be laid off are written to 0.1 mm


def computed(name: str) -> Iterator[tuple[Step, str]]:
    """(step, symbol) of every normal and Coriolis acceleration that is not zero in a table."""
    for step in drawn(name).construction.steps:
        if step.equation is not None and step.view is View.ACCELERATION:
            for symbol, size in zip(step.equation.symbols, step.equation.magnitudes, strict=True):
                if re.match(r"a\^[nk]_", symbol) and size not in ("0", "✓", "?"):
                    yield step, symbol.replace("{", "").replace("}", "")


def worked_out(step: Step, symbol: str) -> tuple[list[str], list[str]]:
    """The formulas of a step that give this vector's size, and those that give its length on paper."""
    formulas = [plain(node) for node in step.formulas]
    return [text for text in formulas if text.startswith(f"{symbol} = ")], [
        text for text in formulas if f"({symbol})/(μ_a)" in text and text.endswith(" mm")
    ]


@each(IDS)
def test_a_computed_acceleration_is_worked_out_and_converted_into_a_length_once(name: str) -> None:
    for step, symbol in computed(name):
        sizes, lengths = worked_out(step, symbol)
        assert len(sizes) == len(lengths) == 1, (step.number, symbol, sizes, lengths)


@each(IDS)
def test_a_computed_acceleration_is_as_long_on_paper_as_its_step_says(name: str) -> None:
    desk = desk_of(name)
    drawn_as = {_plain(key): abs(b - a) for key, (view, a, b) in standing(desk).items() if view is View.ACCELERATION}
    for step, symbol in computed(name):
        length = float(worked_out(step, symbol)[1][0].rpartition("= ")[2].removesuffix(" mm").replace("−", "-"))
        if symbol in drawn_as:
            assert length == pytest.approx(drawn_as[symbol], abs=HALF), (step.number, symbol)


@each(Later(lambda: ids(view=View.VELOCITY)))
def test_every_point_of_a_link_has_the_oracle_s_vector_on_every_polygon(name: str) -> None:
    desk = desk_of(name)
    motion = oracle.solve(desk.mech)
    for view, exact in ((View.VELOCITY, motion.velocity), (View.ACCELERATION, motion.acceleration)):
        size = desk.board.scales[view].value if drawn(name).figures(view) else 0.0
        for point in (point for link in desk.mech.links for point in link.points if size):
            assert complex(desk.tip(view, At(point))) * size == pytest.approx(complex(exact(point)), abs=1e-6 * size), (
                point
            )


GUIDES = [
    (re.compile(r"^Join \$(\w)\$ and \$(\w)\$: the direction of link (\w+)"), False),
    (re.compile(r"^From \$(\w)\$ draw the tangent to the arc about \$(\w)\$ .* the guide of link (\w+)"), True),
]


@each(Later(ids))
def test_a_guide_is_joined_where_it_passes_through_both_pins_and_else_a_tangent(name: str) -> None:
    desk = desk_of(name)
    for step in drawn(name).construction.steps:
        for pattern, beside in GUIDES:
            if (told := pattern.match(step.words.en)) is not None:
                joints = [
                    j for j in desk.mech.joints if isinstance(j, Prismatic) and desk.mech.number(j.guide) == told[3]
                ]
                ends = [(j, told[1], told[2]) for j in joints if told[2] in desk.mech.link(j.block).points]
                (joint, q, p), *_ = ends
                off = desk.offset(joint, joint.block, p) - desk.offset(joint, joint.guide, q)
                assert (abs(off) > 1e-9) is beside, step.words
                if beside:  # the tangent is the guide where that passes q; else parallel to it, through p if it is
                    assert ("it is the guide" in step.words.en) is (abs(desk.offset(joint, joint.guide, q)) < 1e-9)
                if "parallel to it, through" in step.words.en:
                    assert abs(desk.offset(joint, joint.block, p)) < 1e-9, step.words


def test_guides_are_joined_and_ruled_as_tangents_in_the_library() -> None:
    steps = [step.words.en for name in ids() for step in drawn(name).construction.steps]
    assert all(sum(bool(pattern.match(text)) for text in steps) for pattern, _ in GUIDES)


def _plain(key: str) -> str:
    rel = parse_rel(key)
    return (
        rel.symbol.replace("{", "").replace("}", "")
        if rel.kind in (Kind.AN, Kind.AK) and isinstance(rel.to, At)
        else ""
    )


def test_computed_accelerations_are_met_in_nearly_every_problem() -> None:
    assert sum(any(True for _ in computed(name)) for name in IDS) > 0.8 * len(IDS)
    assert sum(len(list(computed(name))) for name in IDS) > 2 * len(IDS)
