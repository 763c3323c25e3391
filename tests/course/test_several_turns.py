"""A machine whose period is two turns of its crank: what its links do in each turn is told once, and as of a turn."""

from __future__ import annotations

from tests.studies import studied
from vecpoly.cycle import path_sentences
from vecpoly.report.content import Objects
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results.tabled import tabled
from vecpoly.words import Words


def test_a_table_of_what_comes_again_in_every_turn_lists_one_of_them() -> None:
    it, press = studied("engine-card"), Press("en", Objects())
    press.chapter = "5"
    made = press.objects.named[tabled(it, press, ["phi_2", "omega_2"], Words("角", "Angles"))]
    angles = {row[n] for row in made.rows for n in range(0, len(row), 4)}  # type: ignore[attr-defined]
    assert "180" in angles and not angles & {"190", "360", "370", "710"}, "half a turn, for it is symmetrical"
    assert "one is listed" in made.caption  # type: ignore[attr-defined]


def test_how_far_a_point_runs_to_and_fro_is_told_of_a_turn() -> None:
    it = studied("engine-card")
    (said,) = path_sentences(it.whole, it.path("C"))
    assert "passes it twice per turn of the input link: the distance travelled is 200 mm" in said.en
