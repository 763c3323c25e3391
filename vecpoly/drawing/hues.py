"""The ink of a vector: one hue wherever it appears, in equations, tables, polygons, diagrams, free bodies, the player.

Which vectors are one is known to the construction (`board/paper/tones.py`). Beyond as many as there are hues these
come again, with hollow shafts. What has no tone is black; what is printed in grey, or seen by eyes that tell few hues
apart, is known by its letters, its shaft, and without friction by its dashes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..algebra.formula import Node, Row, Sym, plain
from ..board.construction import View
from ..board.paper.marks import Mark, Role
from ..board.paper.tones import HUES, key_of, known_as, whose
from ..figures.hue import TONES, Hue
from .style import Dash, kind_hue

Tones = Mapping[str, int] | None
MOVING = "Vv"  # the initial of vibrations and velocities, which friction does not concern
CENTRODES: Mapping[Role, Hue] = {Role.LOCUS: TONES[0], Role.CARRIED: TONES[1]}


def hue_of(tone: int) -> Hue:
    """The ink of a tone; of none, black."""
    return TONES[(tone - 1) % HUES] if tone else Hue.BLACK


def is_hollow(key: str, tones: Tones) -> bool:
    """Whether a vector is of the second series, whose shafts are hollow."""
    return tones is not None and tones.get(whose(key), 0) > HUES


def ink_of(key: str, tones: Tones) -> Hue:
    """The ink of what has this key."""
    return hue_of(tones.get(whose(key), 0)) if tones else Hue.BLACK


def ink_called(key: str, symbol: str, tones: Tones, line: Node | None = None) -> Hue:
    """The ink of a quantity by its symbol, as equations and figures have it, else by its key, else by the other name
    that its line gives it: v_D = v_D4 = μ_v·pd_4."""
    names = (known_as(key, symbol), key, *_other_names(line))
    return ink_of(next((name for name in names if tones and whose(name) in tones), key), tones)


def _other_names(line: Node | None) -> Iterator[str]:
    """What a line says that its quantity is, before it is worked out."""
    head = line.items[0] if isinstance(line, Row) and line.items else None
    if isinstance(head, Row):
        yield from (known_as("", plain(item)) for item in head.items if isinstance(item, Sym))


def mark_hue(mark: Mark, view: View, label: str, tones: Tones) -> Hue:
    """The ink of an arrow and of its symbol; of an axis, or of a figure without vectors, that of its kind."""
    return (
        kind_hue(view, label) if tones is None or (tones and view.across is not None) else ink_of(key_of(mark), tones)
    )


def curve_hue(role: Role, tones: Tones) -> Hue:
    """The ink of a curve: of its own where it is a centrode, which may lie on a link; black where all is black."""
    return Hue.BLACK if tones is not None and not tones else CENTRODES.get(role, Hue.BLACK)


def line_hue(key: str, tones: Tones, else_: Hue) -> Hue:
    """The ink of a thin line along which a force acts, and of its letter: the force's, where that has one."""
    return hue_of(tone) if key and tones and (tone := tones.get(whose(key), 0)) else else_


def image_hue(view: View, tones: Tones) -> Hue:
    """The ink of the sides of an image: that of its kind of figure, black beside vectors that are told apart."""
    return view.ink if view.images and tones is None else Hue.BLACK


def tint_of(view: View, tones: Tones) -> Hue:
    """The light background of an image; grey where all is black."""
    return view.tint if tones is None or tones else Hue.PLATE


def dash_of(key: str) -> Dash:
    """The pattern of a vector: without friction, beside that with it, it is dashed."""
    return Dash.DASHED if key.endswith(("_0", ",0")) and key[0] not in MOVING else Dash.FULL
