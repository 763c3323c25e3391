"""Every centre of the library has its step, its letter and its place;
the arrows of velocities stand as the links turn."""

from __future__ import annotations

import re

from tests.drawn_library import desk_of, drawn, ids
from tests.each import Later, each
from vecpoly import oracle
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Block, Ground, Point, Role, Segment, Vector
from vecpoly.errors import NotAskedError
from vecpoly.mechanism.asked.centres import centre, count, link_pairs, real_links
from vecpoly.methods.centres.direct import direct_centres
from vecpoly.methods.centres.size import NAME
from vecpoly.oracle.centres import Centres

IDS = Later(
    lambda: (
        name for name in ids() if any(step.section.en == "Instant centres" for step in drawn(name).construction.steps)
    )
)
SEEN = 1e-4  # mm
LETTER = r"P_\{?[\d,]+\}?"
TO_LETTER = 2.0  # mm from an arrow's tip to its letter, at most


def figure(name: str) -> Figure:
    """The figure of the centres: one of its own, or the diagram."""
    found = drawn(name).figures(View.MECHANISM)
    return next((f for f in found if f.name == NAME), next(f for f in found if not f.name))


def is_own(name: str) -> bool:
    """Whether the mechanism is drawn once more for them."""
    return figure(name).name == NAME


def steps(name: str) -> list[str]:
    """The sentences under the heading of the centres."""
    return [step.words.zh for step in drawn(name).construction.steps if step.section.en == "Instant centres"]


@each(IDS)
def test_the_number_of_centres_is_counted_first(name: str) -> None:
    k = len(real_links(drawn(name).problem.mechanism))
    assert f"$k$ = {k} 个构件" in steps(name)[0] and count(drawn(name).problem.mechanism) == k * (k - 1) // 2
    first = 2 if is_own(name) else 1
    assert any("重画机构图" in words for words in steps(name)) is is_own(name)
    assert steps(name)[first].startswith("直接相连的构件，其瞬心由观察得到：")


@each(IDS)
def test_every_centre_that_is_sought_has_one_step_that_names_the_lines_on_which_it_lies(name: str) -> None:
    mech = drawn(name).problem.mechanism
    head = re.compile(r"(?:求 |由△[\d,]+、△[\d,]+ 得 )\$(P_\{?[\d,]+\}?)")
    named = [(words, head.match(words)) for words in steps(name)]
    sought = [words for words, first in named if first]
    found = [re.sub("[{}]", "", first[1]) for _, first in named if first]
    direct = {
        re.sub("[{}]", "", centre(mech, *one.pair).symbol)
        for one in direct_centres(desk_of(name))
        if one.centre is not None
    }
    assert len(found) == len(set(found)) and not set(found) & direct
    letters = {letter for letter in shown(name) if letter not in direct}
    assert letters <= set(found)
    assert all(re.search("既在.*又在|试作|既在|的交点", words) for words in sought)


def shown(name: str) -> dict[str, complex]:
    """Where each centre is lettered on the figure (mm)."""
    places = {}
    for mark in figure(name).marks:
        if isinstance(mark, Point):
            for letter in re.findall(LETTER, mark.label):
                places[re.sub("[{}]", "", letter)] = mark.at
    return places


@each(IDS)
def test_a_centre_is_lettered_where_the_oracle_has_it(name: str) -> None:
    mech = drawn(name).problem.mechanism
    truth, on_paper = Centres(mech), 0
    by_symbol = {re.sub("[{}]", "", centre(mech, a, b).symbol): (a, b) for a, b in link_pairs(mech)}
    for letter, at in shown(name).items():
        exact = _place(truth, by_symbol[letter])
        if isinstance(exact, complex) and letter not in off_the_paper(name):
            assert abs(at - exact / figure(name).scale.value) < SEEN, letter
            on_paper += 1
    assert on_paper >= 2


def _place(truth: Centres, links: tuple[str, str]) -> complex | float | None:
    """None of links that do not move on each other: their pin is lettered, and any other point would do."""
    try:
        return truth.place(*links)
    except NotAskedError:
        return None


def off_the_paper(name: str) -> set[str]:
    """The centres of which their step says so."""
    told = " ".join(steps(name))
    return {re.sub("[{}]", "", one) for one in re.findall(rf"\$({LETTER})\$ 落在图外", told)}


@each(Later(lambda: [name for name in (*IDS, "centre-off-the-paper") if off_the_paper(name)]))
def test_a_centre_off_the_paper_is_lettered_at_arrows_that_lead_there(name: str) -> None:
    mech = drawn(name).problem.mechanism
    by_symbol = {re.sub("[{}]", "", centre(mech, a, b).symbol): (a, b) for a, b in link_pairs(mech)}
    arrows = [mark for mark in figure(name).marks if isinstance(mark, Vector) and mark.role is Role.DIRECTION]
    for letter in off_the_paper(name) & {*shown(name)}:
        exact, at = Centres(mech).place(*by_symbol[letter]), shown(name)[letter]
        (arrow,) = (mark for mark in arrows if abs(mark.b - at) < TO_LETTER)
        left = (exact / figure(name).scale.value - arrow.b) / (arrow.b - arrow.a)
        assert left.real > 0 and abs(left.imag) < SEEN * left.real, letter


@each(IDS)
def test_the_lines_on_which_a_centre_lies_are_drawn(name: str) -> None:
    lines = [mark for mark in figure(name).marks if isinstance(mark, Segment)]
    sought = [step.number for step in drawn(name).construction.steps if step.words.zh.startswith("求 $P_")]
    for number in sought:
        assert sum(mark.step == number for mark in lines) >= 2 or any(
            mark.step == number for mark in figure(name).marks
        ), number
    assert sum(mark.step in sought for mark in lines) >= len(sought)


@each(Later(lambda: [name for name in IDS if any(isinstance(m, Vector) for m in figure(name).marks)]))
def test_velocities_on_the_figure_stand_square_to_the_rays_from_their_centres(name: str) -> None:
    mech = drawn(name).problem.mechanism
    motion = oracle.solve(mech)
    arrows = {
        mark.label: mark
        for mark in figure(name).marks
        if isinstance(mark, Vector) and re.fullmatch("v_{[A-Z]}", mark.label)
    }
    for label, mark in arrows.items():
        exact = complex(motion.velocity(label[3]))
        assert ((mark.b - mark.a) / exact).real > 0 and abs(((mark.b - mark.a) / exact).imag) < 1e-6 * abs(
            (mark.b - mark.a) / exact
        ), label
    assert arrows or name == "D-2" or all("标出各速度的方向" not in words for words in steps(name))


@each(Later(lambda: [name for name in IDS if is_own(name)]))
def test_the_mechanism_stands_once_more_under_its_centres_drawn_to_their_scale(name: str) -> None:
    whole = next(f for f in drawn(name).figures(View.MECHANISM) if not f.name)
    size = whole.scale.value / figure(name).scale.value
    fixed = {
        kind: [
            [m.at * times for m in f.marks if isinstance(m, kind)] for f, times in ((whole, size), (figure(name), 1.0))
        ]
        for kind in (Ground, Block)
    }
    for there, here in fixed.values():
        assert len(there) == len(here) and all(min(abs(a - b) for b in here) < SEEN for a in there)
    assert any(there for there, _ in fixed.values())


@each(IDS)
def test_a_common_normal_is_lettered_at_its_two_ends_and_nowhere_else(name: str) -> None:
    ends = [mark.at for mark in figure(name).marks if isinstance(mark, Point) and mark.label == "n"]
    contacts = [d for d in direct_centres(desk_of(name)) if d.centre is None]
    assert len(ends) <= 2 * max(len(contacts), 1)
