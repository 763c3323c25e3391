"""How the player cuts the steps of the library into beats: one vector, one line at a time."""

from __future__ import annotations

import numpy as np

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.acts import Arrow
from vecpoly.board.paper.marks import Vector
from vecpoly.board.place import View
from vecpoly.player.beats import READ, beats, stepped
from vecpoly.player.figures import key_of
from vecpoly.player.pointing import pointed

POLYGONS = (View.VELOCITY, View.ACCELERATION, View.FORCE)


@each(IDS)
def test_a_beat_draws_one_vector_and_writes_one_line(name: str) -> None:
    cut = beats(drawn(name).construction)
    assert [beat.number for beat in cut] == list(range(1, len(cut) + 1))
    for beat in cut:
        assert sum(isinstance(act, Arrow) and act.shown for act in beat.acts) <= 1 and len(beat.formulas) <= 1


@each(IDS)
def test_beats_leave_nothing_out_and_keep_the_order_of_the_steps(name: str) -> None:
    construction = drawn(name).construction
    cut = beats(construction)
    assert list(dict.fromkeys(beat.step for beat in cut)) == [step.number for step in construction.steps]
    acts, done = [a for a in construction.acts if a.head.step], [act for beat in cut for act in beat.acts]
    assert sorted(act.number for act in done) == [act.number for act in acts]
    # what is read when all is drawn is read where the line stands that it is for
    kept = [[act.number for act in some if not isinstance(act, READ)] for some in (done, acts)]
    assert kept[0] == kept[1]
    for step in construction.steps:
        written = [n for beat in cut if beat.step == step.number for n in beat.formulas]
        assert sorted(written) == list(range(len(step.formulas))) and len(step.written) == len(step.formulas)


@each(IDS)
def test_a_polygon_gains_one_vector_in_a_beat(name: str) -> None:
    for figure in stepped(drawn(name).construction).figures:
        if figure.view in POLYGONS:
            own = [mark.step for mark in figure.marks if isinstance(mark, Vector)]
            assert len(own) == len(set(own)), key_of(figure)


@each(IDS)
def test_what_a_beat_points_at_is_there_already_and_a_coriolis_term_is_a_quarter_turn(name: str) -> None:
    construction = drawn(name).construction
    cut = beats(construction)
    keys = {key_of(figure) for figure in construction.figures}
    for beat, data in zip(cut, pointed(construction, cut), strict=True):
        assert all(glow < beat.number for glow in data.get("glow", ()))  # type: ignore[attr-defined]
        assert {mark[0] for mark in data.get("marks", ())} <= keys  # type: ignore[attr-defined]
        if turn := data.get("turn"):
            assert turn[0] in keys and turn[6] < beat.number  # type: ignore[index]
            assert np.isclose(abs(turn[5]), 90.0, atol=0.11)  # type: ignore[index]
