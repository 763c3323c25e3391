"""Items of a scene as small SVG in whole units of 0.01 mm, y downwards;
looks and set type are written once and referred to."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field
from functools import cache
from itertools import pairwise
from typing import assert_never

from ...drawing.scene import Fill, Item, Stroke, TextBox
from ...drawing.style import Hue
from ...figures.kind import hues
from ...foundation.data import data_dir
from ...typeset import Box
from .type import Faces, set_box

UNIT = 100.0  # units in a millimetre
ROUND = 1e-6  # of the radius: points nearer to a circle than this lie on it
FINE = math.radians(30.0)  # chords that span more are those of a polygon, not of a circle
BOLDER, BOLDEST = 1.7, 90  # how a line of the newest step is strengthened, at most (units of width)

Look = tuple[str, float, tuple[float, ...], str]


@dataclass(slots=True)
class Ink:
    """The looks and the pieces of type that have been used so far."""

    faces: Faces = field(default_factory=Faces)
    looks: dict[Look, str] = field(default_factory=dict)
    boxes: dict[Box, str] = field(default_factory=dict)

    def svg(self, items: tuple[Item, ...]) -> str:
        """The items in order; neighbours of one look are one path."""
        parts: list[tuple[str, str]] = []
        for name, body in (self.piece(item) for item in items):
            if parts and name and parts[-1][0] == name:
                parts[-1] = (name, parts[-1][1] + body)
            else:
                parts.append((name, body))
        return "".join(f'<path class="{name}" d="{body}"/>' if name else body for name, body in parts)

    def piece(self, item: Item) -> tuple[str, str]:
        """Class and path of a stroke or a fill; "" and the whole element for type."""
        match item:
            case Stroke(points=points, width=width, dash=dash, hue=hue, closed=closed):
                return self._look("s", width, dash.pattern, hue), path(points, closed)
            case Fill(points=points, hue=hue):
                return self._look("f", 0.0, (), hue), path(points, True)
            case TextBox(box=box, x=x, y=y, hue=hue):
                at = f'x="{_whole(x)}" y="{_whole(-y)}"'
                ink = "" if hue == Hue.BLACK else f' class="t-{hue.name}"'
                return "", f'<use href="#{self.type(box)}" {at}{ink}/>'
        assert_never(item)

    def type(self, box: Box) -> str:
        """The name under which this piece of type is defined."""
        return self.boxes.setdefault(box, f"t{len(self.boxes)}")

    def _look(self, kind: str, width: float, dash: tuple[float, ...], hue: Hue) -> str:
        return self.looks.setdefault((kind, width, dash, hue.name), f"{kind}{len(self.looks)}")

    def definitions(self) -> str:
        """Each piece of type once, for the defs of the page."""
        return "".join(
            f'<g id="{name}" data-w="{_whole(box.width)}" data-h="{_whole(box.ascent)}">'
            f"{set_box(box, self.faces, UNIT)}</g>"
            for box, name in self.boxes.items()
        )

    def css(self) -> str:
        """The rules of all looks: as drawn, and strengthened where they belong to the newest step."""
        rules = [f".{name}{{{_rule(look)}}}" for look, name in self.looks.items()]
        rules += [
            f".now .{name}{{stroke-width:{_bold(look[1])}}}" for look, name in self.looks.items() if look[0] == "s"
        ]
        own = {f"--{_variable(hue.name)}:": hue.hex for hue in hues()}
        rules += [f":root{{{name}{ink}}}" for name, ink in own.items() if name not in _styled()]
        used = {hue for _, _, _, hue in self.looks} | {hue.name for hue in hues()}
        rules += [f".t-{hue}{{fill:var(--{_variable(hue)})}}" for hue in sorted(used)]
        return "\n".join(rules)


@cache
def _styled() -> str:
    """The stylesheet, which gives most inks a colour by day and one by night."""
    return (data_dir("templates") / "player" / "style.css").read_text(encoding="utf-8")


def inked(html: str, hue: Hue) -> str:
    """A piece of a sentence or a table in the ink of its vector; black is that of its surroundings."""
    return html if hue == Hue.BLACK else f'<span style="color:var(--{_variable(hue.name)})">{html}</span>'


def _variable(hue: str) -> str:
    return hue.replace("_", "-")


def _rule(look: Look) -> str:
    kind, width, dash, hue = look
    ink = f"var(--{_variable(hue)})"
    if kind == "f":
        return f"fill:{ink}"
    pattern = f";stroke-dasharray:{' '.join(str(round(UNIT * part)) for part in dash)}" if dash else ""
    return f"stroke:{ink};stroke-width:calc(var(--bold,1)*{_width(width)}px){pattern}"


def _width(width: float) -> int:
    return max(1, round(UNIT * width))


def _bold(width: float) -> int:
    """A thin line gains most."""
    return max(_width(width), min(round(BOLDER * _width(width)) + 8, BOLDEST))


def _whole(mm: float) -> int:
    return round(UNIT * mm)


def path(points: tuple[complex, ...], closed: bool) -> str:
    """The shortest path data of a polyline; points along a circle become an arc."""
    arc = _arc(points, closed)
    if arc is not None:
        return arc
    spots = [(_whole(z.real), _whole(-z.imag)) for z in points]
    steps = [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(spots) if a != b]
    body = " ".join(_pair(*step) for step in steps) if steps else "0 0"
    return f"M{_pair(*spots[0])}l{body}{'z' if closed else ''}"


def _pair(x: int, y: int) -> str:
    return f"{x}{'' if y < 0 else ' '}{y}"


def _arc(points: tuple[complex, ...], closed: bool) -> str | None:
    """Arc data where the points lie at even steps on a circle; none where they do not."""
    if len(points) < 8:
        return None
    a, b, c = points[0], points[len(points) // 3], points[2 * len(points) // 3]
    centre = _centre(a, b, c)
    if centre is None:
        return None
    radius, turns = abs(a - centre), [cmath.phase((q - centre) / (p - centre)) for p, q in pairwise(points)]
    if (
        any(abs(abs(z - centre) - radius) > ROUND * radius for z in points)
        or any(abs(t - turns[0]) > 1e-6 for t in turns)
        or abs(turns[0]) > FINE
    ):
        return None
    r, sweep = _whole(radius), sum(turns)
    if closed or abs(sweep) > 2 * math.pi - 1e-6:
        x, y = _whole(centre.real) + r, _whole(-centre.imag)
        return f"M{_pair(x, y)}a{r} {r} 0 1 0 {-2 * r} 0a{r} {r} 0 1 0 {2 * r} 0z"
    end = points[-1]
    large, clockwise = int(abs(sweep) > math.pi), int(sweep < 0)
    return (
        f"M{_pair(_whole(a.real), _whole(-a.imag))}A{r} {r} 0 {large} {clockwise} "
        f"{_pair(_whole(end.real), _whole(-end.imag))}"
    )


def _centre(a: complex, b: complex, c: complex) -> complex | None:
    """Centre of the circle through three points."""
    u, v = b - a, c - a
    area = (u.conjugate() * v).imag
    if abs(area) < 1e-12:
        return None
    return a + 1j * (u * abs(v) ** 2 - v * abs(u) ** 2) / (2 * area)
