"""What a statement names stands on its figure, in its data, or is what is asked: nothing is left to be guessed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Point, Vector
from vecpoly.devices.balancing.engine import InlineEngine
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.eccentric_clamp import EccentricClamp
from vecpoly.mechanism.asked.forces import load_symbol
from vecpoly.mechanism.loads import Force
from vecpoly.report.content import statement
from vecpoly.report.question.sketch import sketched
from vecpoly.words import Words

_NAMED = re.compile(r"\$([^$]+)\$")
_SIZED = re.compile(r"\$([^$]+)\$ = [−\d]")
_SEQUENCE = re.compile(r"(?:[A-Z](?:_\d|′)?)+x?")  # of points: BC, BCG, DC_1, and the axis Ax
_LENGTH = re.compile(r"l_([A-Z])([A-Z])")
_NO_NAME = re.compile(r"[\d. ()−+/]*|[xyz]|log x")
_PLAIN = re.compile(r"[{}]")


def plain(text: str) -> str:
    """Without the braces of subscripts."""
    return _PLAIN.sub("", text)


def symbols(text: str) -> Iterator[str]:
    """Each symbol of a statement by itself, of AO = 2e both, unless the statement tells its size."""
    told = set(_SIZED.findall(text))
    for found in (one for one in _NAMED.findall(text) if one not in told):
        for part in re.split(r" ?[=≤<>…/()] ?", plain(found)):
            symbol = re.sub(r"^[\d. ]+", "", part)
            if not _NO_NAME.fullmatch(symbol):
                yield symbol


def letters(figures: Iterable[Figure | None]) -> set[str]:
    """All letters on these figures."""
    marks = (mark for figure in figures if figure is not None for mark in figure.marks)
    texts = (getattr(mark, name, "") for mark in marks for name in ("label", "words", "number"))
    return {plain(text.en if isinstance(text, Words) else text) for text in texts if text}


def pictured(name: str) -> Figure | None:
    """The figure of a statement."""
    return sketched(drawn(name).problem, drawn(name).construction, 125.0, 62.0)


def is_told(symbol: str, texts: Iterable[str]) -> bool:
    """Whether one of these texts has it, or its differential, a length by either order of its ends, a sequence of
    points by its points."""
    texts = tuple(texts)
    ways = {symbol, f"d{symbol}", f"x_{symbol}", f"y_{symbol}", *(f"l_{b}{a}" for a, b in _LENGTH.findall(symbol))}
    if any(re.search(rf"(?<!\w){re.escape(way)}(?:_\d|(?!\w))", text) for way in ways for text in texts):
        return True
    points = {text[0] for text in texts if re.match(r"[A-Z](?![a-z])", text)}
    ends = symbol.removeprefix("l_")
    return bool(_SEQUENCE.fullmatch(ends)) and len(ends) > 1 and points.issuperset(re.findall("[A-Z]", ends))


@each(IDS)
def test_what_a_statement_names_stands_on_its_figure_or_in_its_data_or_is_found(name: str) -> None:
    one = drawn(name)
    said = statement(one.solution, "en")
    found = letters(one.construction.figures)
    texts = {*letters([pictured(name)]), *found, plain(said["given"]), plain(said["asked"])}
    missing = [symbol for symbol in symbols(said["statement"]) if not is_told(symbol, texts)]
    missing = [symbol for symbol in missing if symbol.rpartition("_")[2] != "i"]  # of any gear, any link: link i
    assert not missing, missing


LOADED = Later(lambda: (name for name in IDS if given(name).loads or given(name).machine))


@each(LOADED)
def test_a_load_that_is_given_is_drawn_on_the_figure_of_the_statement(name: str) -> None:
    problem = drawn(name).problem
    loads = problem.loads or (problem.machine.loads if problem.machine is not None else None)
    assert loads is not None
    here = letters([pictured(name)])
    acting = [one.name for one in loads.all if one.size is not None]
    assert {plain(load_symbol(one)) for one in acting} <= here


@each(LOADED)
def test_a_force_that_is_given_pulls_at_its_point_or_presses_on_it_alike_on_all_figures(name: str) -> None:
    one, loads = drawn(name), drawn(name).problem.loads
    here = [pictured(name), *(f for f in one.construction.figures if f.view in (View.MECHANISM, View.BODY))]
    for force in loads.forces if loads is not None else ():
        ways = {way for figure in here if figure is not None and (way := pulls(figure, force)) is not None}
        assert force.against or len(ways) < 2, force.name


def pulls(figure: Figure, load: Force) -> bool | None:
    """Whether the arrow of a load begins at its point; None where one of the two is not drawn."""
    at = next((m.at for m in figure.marks if isinstance(m, Point) and m.label == load.point), None)
    arrow = next((m for m in figure.marks if isinstance(m, Vector) and m.label == load_symbol(load.name)), None)
    return None if at is None or arrow is None else abs(arrow.a - at) < abs(arrow.b - at)


SIZED = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Cam | EccentricClamp | InlineEngine)))
_TOLD = {"m", "r", "l", "n", "f", "ρ", "Q"}  # of an engine's cylinder, of friction: not on the sketch of the whole


@each(SIZED)
def test_lengths_and_angles_of_cams_clamps_and_crankshafts_stand_on_their_sketch(name: str) -> None:
    subject, here = drawn(name).problem.subject, pictured(name)
    if here is None:  # what no first step can draw: the least cam for given pressure angles
        assert isinstance(subject, Cam) and subject.r0 is None
        return
    told = _TOLD - {"l", "Q"} if isinstance(subject, EccentricClamp) else _TOLD
    wanted = {plain(symbol) for symbol, _ in subject.given()}  # type: ignore[union-attr]
    assert {one for one in wanted - told if not one.startswith("α_")} <= letters([here])


def test_drum_and_pulley_are_drawn_and_a_rotor_without_length_is_seen_from_its_end() -> None:
    drum, disc = pictured("6-7"), pictured("6-1")
    assert drum is not None and disc is not None
    tall = [mark for mark in drum.marks if getattr(mark, "role", None) == "given"]
    assert len(tall) == 8 and disc.view.name == "end-view"


@pytest.mark.parametrize("name", ["straight-roberts", "straight-hoecken", "straight-chebyshev"])
def test_a_mechanism_that_is_given_whole_is_shown_whole_and_small(name: str) -> None:
    shown = pictured(name)
    assert shown is not None and set("ABCDE") <= letters([shown])
    places = [mark.at for mark in shown.marks if isinstance(mark, Point) and mark.label in set("ABCDE")]
    assert max(at.imag for at in places) - min(at.imag for at in places) < 50


def test_the_height_of_the_guide_that_is_asked_for_is_on_the_drawing() -> None:
    assert "h" in letters(drawn("8-17").construction.figures)
