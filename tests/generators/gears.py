"""Random mechanisms with gears: a driven crank or gear, then gears on arms,
couplers and pivots, racks, planets, trains, dyads on crank pins.

Every mechanism is grown at its given position:
a new link is put where it pleases, and its lengths, radii and angles are read off there.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import dataclass, field
from math import degrees, pi

import numpy as np

from .family import family

Random = np.random.Generator
LETTERS = [a + b for b in ("", "a", "b") for a in "ABCDEFGHIJKLMNOQRSTUVWXYZ"]


@dataclass(slots=True)
class Circle:
    """A pitch circle: link, letter of the centre, radius (mm)."""

    link: str
    centre: str
    radius: float


@dataclass(slots=True)
class Growing:
    """The mechanism so far, at its given position (mm)."""

    random: Random
    at: dict[str, complex] = field(default_factory=dict)
    frame: list[str] = field(default_factory=list)
    links: dict[str, list[str]] = field(default_factory=dict)  # as written
    carries: dict[str, list[str]] = field(default_factory=dict)
    joints: list[str] = field(default_factory=list)
    branch: list[str] = field(default_factory=list)
    circles: list[Circle] = field(default_factory=list)
    travel: float | None = None  # of a rack that drives (mm)
    letters: list[str] = field(default_factory=lambda: LETTERS.copy())

    def letter(self) -> str:
        return self.letters.pop(0)

    def fixed(self, at: complex) -> str:
        name = self.letter()
        self.at[name] = at
        self.frame.append(name)
        return name

    def link(self, written: list[str], carries: list[str]) -> str:
        name = str(len(self.links) + 1)
        self.links[name], self.carries[name] = written, carries
        return name

    def length(self, p: str, q: str) -> str:
        return f"{p}{q}: {abs(self.at[q] - self.at[p])!r} mm"

    def between(self, low: float, high: float) -> float:
        return float(self.random.uniform(low, high))

    def one(self, items: list[str]) -> str:
        return items[int(self.random.integers(len(items)))]

    def near(self, p: complex, low: float = 30, high: float = 120) -> complex:
        return p + cmath.rect(self.between(low, high), self.between(-pi, pi))

    def side(self, c: str, p: str, q: str) -> None:
        left = ((self.at[q] - self.at[p]).conjugate() * (self.at[c] - self.at[p])).imag > 0
        self.branch.append(f"{c} {'left' if left else 'right'} of {p}{q}")

    def text(self) -> str:
        frame = ", ".join(f"{p}: [{self.at[p].real!r} mm, {self.at[p].imag!r} mm]" for p in self.frame)
        links = "\n".join(f"  {name}: {{{', '.join(written)}}}" for name, written in self.links.items())
        joints = "\n".join(f"  - {joint}" for joint in self.joints)
        rates = [f"{kind}_{name}" for name in self.links for kind in ("omega", "alpha")]
        moving = dict.fromkeys(p for carried in self.carries.values() for p in carried if p not in self.frame)
        asked = ", ".join([*rates, *(f"{kind}_{p}" for p in moving for kind in "pva")])
        alpha = self.one(["", ", alpha: 40 rad/s^2", ", alpha: -25 rad/s^2"])
        turning = (
            f"phi: {degrees(cmath.phase(self.drive)) % 360!r} deg, omega: "
            f"{self.one(['10 rad/s ccw', '4 rad/s cw'])}{alpha}"
        )
        told = turning if self.travel is None else f"s: {self.travel!r} mm, v: 0.4 m/s, a: 3 m/s^2"
        return (
            f"id: random\ntitle: random gears\nframe: {{{frame}}}\nlinks:\n{links}\njoints:\n{joints}\n"
            f"branch: [{', '.join(self.branch)}]\ninput: {{link: 1, {told}}}\nfind: [{asked}]\n"
        )

    @property
    def drive(self) -> complex:
        a, b = (self.carries["1"] * 2)[:2]
        return self.at[b] - self.at[a] if a != b else cmath.rect(1.0, 0.7)


def started(random: Random) -> Growing:
    """A crank with a gear about its pivot or about its pin, a gear that drives, or a rack that turns a pinion."""
    g = Growing(random)
    a = g.fixed(0j)
    kind = g.one(["plain", "about pivot", "about pin", "gear", "rack"])
    radius = g.between(15, 60)
    if kind == "rack":
        return _driving_rack(g, a, radius)
    if kind == "gear":
        g.circles.append(Circle(g.link([f"gear: {a}", f"radius: {radius!r} mm"], [a]), a, radius))
        return g
    b = g.letter()
    g.at[b] = g.near(0j, 25, 70)
    centre = b if kind == "about pin" else a
    g.link([g.length(a, b)] + ([] if kind == "plain" else [f"gear: {centre}", f"radius: {radius!r} mm"]), [a, b])
    if kind != "plain":
        g.circles.append(Circle("1", centre, radius))
    return g


def _driving_rack(g: Growing, a: str, radius: float) -> Growing:
    """The input is a rack on a fixed guide; its pinion turns about A."""
    p, angle, g.travel = g.letter(), g.between(-pi, pi), g.between(-50, 50)
    along = cmath.rect(1, angle)
    k = g.fixed(-1j * along * radius + along * g.between(-30, 30))
    g.at[p] = g.at[k] + along * g.travel
    g.link([f"block: {p}", f"rack: {p}"], [p])
    g.joints.append(f"1 slides on line through {k} at {degrees(angle)!r} deg")
    gear = pinned(g, a, radius)
    g.joints.append(f"{gear} rolls {g.one(['on', 'left of'])} 1 at {g.letter()}")
    g.circles.append(Circle(gear, a, radius))
    return g


def pinned(g: Growing, centre: str, radius: float) -> str:
    """A gear as written, often with a crank pin whose angle is told from the x axis, or by phi."""
    written, carried = [f"gear: {centre}", f"radius: {radius!r} mm"], [centre]
    form = g.one(["none", "point", "phi", "line"])
    if form != "none":
        p, r, angle = g.letter(), g.between(0.3, 1.3) * min(radius, 60.0), g.between(-pi, pi)
        start = 0.0
        if form == "line" and len(g.frame) > 1:
            q, s = g.frame[0], g.frame[1]
            start = cmath.phase(g.at[s] - g.at[q])
            written.append(f"{p}: {{{centre}{p}: {r!r} mm, angle: {degrees(angle)!r} deg from {q}{s}}}")
        elif form == "phi":
            written = [f"{centre}{p}: {r!r} mm", *written, f"phi: {degrees(angle)!r} deg"]
        else:
            written.append(f"{p}: {{{centre}{p}: {r!r} mm, angle: {degrees(angle)!r} deg}}")
        g.at[p] = g.at[centre] + cmath.rect(r, angle + start)
        carried.append(p)
    return g.link(written, carried)


def meshes(g: Growing, gear: str, mine: float, other: Circle, how: str) -> None:
    """The joint of a new gear with a known one; a ring is what the smaller one rolls in."""
    h = g.letter()
    one, two = (gear, other.link) if mine < other.radius or how == "on" else (other.link, gear)
    g.joints.append(f"{one} rolls {how} {two} at {h}")


def dyad(g: Growing) -> None:
    """Two bars between points of two links; the first may carry a gear fixed to it, or be a plate."""
    moving = [p for name in g.links for p in g.carries[name] if p not in g.frame]
    if not moving:
        return
    p = g.one(moving)
    owners = {name for name in g.links if p in g.carries[name]}
    others = [
        q
        for name in g.links
        if name not in owners
        for q in g.carries[name]
        if q not in g.frame and not any(q in g.carries[o] for o in owners)
    ]
    q = g.one(others) if others and g.random.random() < 0.5 else g.fixed(g.near(g.at[p], 60, 200))
    c = g.letter()
    g.at[c] = g.near((g.at[p] + g.at[q]) / 2, 40, 150)
    written = [g.length(p, c)]
    if g.random.random() < 0.4:
        centre, radius = g.one([p, c]), g.between(15, 50)
        written += [f"gear: {centre}", f"radius: {radius!r} mm"]
        g.circles.append(Circle(str(len(g.links) + 1), centre, radius))
    g.link(written, [p, c])
    g.link([g.length(q, c)], [q, c])
    g.side(c, p, q)


def slider(g: Growing) -> None:
    """A rod and a slider, which may be a rack that turns a pinion."""
    moving = [p for name in g.links for p in g.carries[name] if p not in g.frame]
    if not moving:
        return
    p, c = g.one(moving), g.letter()
    g.at[c] = g.near(g.at[p], 80, 200)
    y = g.at[c].imag
    turned = g.one(["block", "rack"])
    g.link([g.length(p, c)], [p, c])
    rod_right = g.at[c].real > g.at[p].real
    name = g.link([f"block: {c}"] + ([f"rack: {c}"] if turned == "rack" else []), [c])
    g.joints.append(f"{name} slides on y = {y!r} mm")
    g.branch.append(f"{c} {'right' if rod_right else 'left'} of {p}")
    if turned == "rack":
        radius, way = g.between(15, 60), g.one(["above", "below"])
        d = g.fixed(g.at[c] + complex(g.between(-60, 60), radius if way == "above" else -radius))
        gear = pinned(g, d, radius)
        g.circles.append(Circle(gear, d, radius))
        g.joints.append(f"{gear} rolls {g.one([way, 'on'])} {name} at {g.letter()}")


def gear_on_pivot(g: Growing) -> None:
    """A gear on a new fixed pivot, meshing with one on a fixed pivot."""
    known = [c for c in g.circles if c.centre in g.frame]
    if not known:
        return
    other = known[int(g.random.integers(len(known)))]
    how, mine = g.one(["on", "inside"]), g.between(12, 70)
    if how == "inside" and abs(mine - other.radius) < 5:
        return
    away = mine + other.radius if how == "on" else abs(mine - other.radius)
    d = g.fixed(g.at[other.centre] + cmath.rect(away, g.between(-pi, pi)))
    gear = pinned(g, d, mine)
    meshes(g, gear, mine, other, how)
    g.circles.append(Circle(gear, d, mine))


def gear_on_link(g: Growing) -> None:
    """A gear about a hinge of a link that also carries the centre of a known gear, or of a fixed one."""
    spots: list[tuple[str, str, Circle | None]] = []
    for name, carried in g.carries.items():
        for x in carried:
            for y in carried:
                if x != y and y not in g.frame and sum(y in c for c in g.carries.values()) < 4:
                    spots += [(x, y, c) for c in g.circles if c.centre == x and c.link != name]
                    spots += [(x, y, None)] if x in g.frame else []
    if not spots:
        return
    x, y, circle = spots[int(g.random.integers(len(spots)))]
    away = abs(g.at[y] - g.at[x])
    fixed = Circle("0", x, g.between(0.2, 2.2) * away) if circle is None else circle
    mine = (
        fixed.radius - away
        if fixed.radius > away and g.random.random() < 0.7
        else away - fixed.radius
        if fixed.radius < away
        else fixed.radius + away
    )
    how = "on" if mine == away - fixed.radius else "inside"
    if mine < 5 or (circle is None and how == "inside" and mine > fixed.radius):
        return
    gear = pinned(g, y, mine)
    if circle is None:
        g.joints.append(f"{gear} rolls {how} circle about {x} of {fixed.radius!r} mm at {g.letter()}")
    else:
        meshes(g, gear, mine, fixed, how)
    g.circles.append(Circle(gear, y, mine))


def rack_on_guide(g: Growing) -> None:
    """A rack on a fixed guide, driven by a gear on a fixed pivot."""
    known = [c for c in g.circles if c.centre in g.frame]
    if not known:
        return
    pinion = known[int(g.random.integers(len(known)))]
    angle, beside, travel = g.between(-pi, pi), g.one(["0", "1"]), g.between(-60, 60)
    e = g.between(-20, 20) if beside == "1" else 0.0
    along = cmath.rect(1, angle)
    k = g.fixed(g.at[pinion.centre] - 1j * along * (pinion.radius + e) + along * g.between(-30, 30))
    p = g.letter()
    g.at[p] = g.at[k] + along * travel
    line = f"rack: {p}" if not e else f"rack: {{through: {p}, left: {e!r} mm}}"
    name = g.link([f"block: {p}", line, f"s: {travel!r} mm"], [p])
    g.joints += [
        f"{name} slides on line through {k} at {degrees(angle)!r} deg",
        f"{pinion.link} rolls on {name} at {g.letter()}",
    ]


def rolling_centre(g: Growing) -> None:
    """A bar with a gear at its end that rolls on a known gear or a fixed rack,
    its centre held by contact alone; the hinge may be off the centre."""
    moving = [p for name in g.links for p in g.carries[name] if p not in g.frame]
    if not moving:
        return
    p, c, mine = g.one(moving), g.letter(), g.between(12, 50)
    g.at[c] = g.near(g.at[p], 60, 180)
    known = [k for k in g.circles if k.link not in [n for n in g.links if p in g.carries[n]] and k.centre != p]
    h = g.letter()
    side: tuple[str, ...]
    if known and g.random.random() < 0.6:
        other = known[int(g.random.integers(len(known)))]
        way = cmath.rect(1, g.between(-pi, pi))
        inside = mine < 0.8 * other.radius and g.random.random() < 0.4
        g.at[c] = g.at[other.centre] + way * (other.radius - mine if inside else other.radius + mine)
        joint = f"rolls {'inside' if inside else 'on'} {other.link} at {h}"
        side = (p, other.centre)
    else:
        joint, side = f"rolls {g.one(['on', 'above'])} y = {g.at[c].imag - mine!r} mm at {h}", ()
    q = g.one([c, "off"])
    if q == "off":
        q, arm = g.letter(), cmath.rect(g.between(8, 40), g.between(-pi, pi))
        g.at[q] = g.at[c] + arm
        g.link([g.length(p, q)], [p, q])
        gear = g.link(
            [
                f"gear: {c}",
                f"radius: {mine!r} mm",
                f"{q}: {{{c}{q}: {abs(arm)!r} mm, angle: {degrees(cmath.phase(arm))!r} deg}}",
            ],
            [c, q],
        )
    else:
        g.link([g.length(p, c)], [p, c])
        gear = pinned(g, c, mine)
    g.joints.append(f"{gear} {joint}")
    if side and q == c:
        g.side(q, side[0], side[1])
    elif side:
        shifted = g.at[side[1]] + g.at[q] - g.at[c]
        ghost = ((shifted - g.at[p]).conjugate() * (g.at[q] - g.at[p])).imag > 0
        mirrored = _mirrored(g.at[q], g.at[p], shifted)
        _told(g, q, p, side[1], mirrored, ghost)
    else:
        g.branch.append(f"{q} {'right' if g.at[q].real > g.at[p].real else 'left'} of {p}")
    g.circles.append(Circle(gear, c, mine))


def _mirrored(q: complex, p: complex, o: complex) -> complex:
    """The other meeting point of two circles about p and o."""
    ray = (o - p) / abs(o - p)
    return p + ray * ((q - p) / ray).conjugate()


def _told(g: Growing, q: str, p: str, o: str, other: complex, ghost: bool) -> None:
    """A branch statement about letters that tells the two meeting points apart."""
    for a, b in ((p, o), (o, p), *((x, y) for x in g.frame for y in g.frame if x != y), *((p, x) for x in g.frame)):
        here, there = (((g.at[b] - g.at[a]).conjugate() * (at - g.at[a])).imag for at in (g.at[q], other))
        if here * there < 0:
            g.side(q, a, b)
            return


def slider_gear(g: Growing) -> None:
    """A slider whose pin is the centre of a gear that rolls on a known one (PRG)."""
    if not g.circles:
        return
    other = g.circles[int(g.random.integers(len(g.circles)))]
    mine, c = g.between(12, 50), g.letter()
    way = cmath.rect(1, g.between(-pi, pi))
    g.at[c] = g.at[other.centre] + way * (other.radius + mine)
    gear = pinned(g, c, mine)
    y = g.at[c].imag
    block = g.link([f"block: {c}"], [c])
    g.joints += [f"{block} slides on y = {y!r} mm", f"{gear} rolls on {other.link} at {g.letter()}"]
    g.branch.append(f"{c} {'right' if way.real > 0 else 'left'} of {other.centre}")
    g.circles.append(Circle(gear, c, mine))


def rack_on_pin(g: Growing) -> None:
    """A rack hinged to a moving pin that turns a pinion on a fixed pivot or on a moving pin."""
    moving = [p for name in g.links for p in g.carries[name] if p not in g.frame]
    if not moving:
        return
    p, radius = g.one(moving), g.between(12, 45)
    d = g.fixed(g.near(g.at[p], radius + 50, 220))
    rack = g.link(
        [f"rack: {p}"] if g.random.random() < 0.5 else [f"rack: {{through: {p}, left: {g.between(-20, 20)!r} mm}}"], [p]
    )
    gear = pinned(g, d, radius)
    g.joints.append(f"{gear} rolls {g.one(['on', 'below'])} {rack} at {g.letter()}")
    g.circles.append(Circle(gear, d, radius))


def rack_on_link(g: Growing) -> None:
    """A gear on a hinge of a bar that drives a rack along that bar, or is driven from a gear on the other hinge."""
    spots = [
        (c, name, y)
        for c in g.circles
        for name, carried in g.carries.items()
        if c.centre in carried and c.link != name
        for y in carried
        if y != c.centre and len(carried) == 2
    ]
    if not spots:
        return
    pinion, name, y = spots[int(g.random.integers(len(spots)))]
    x = pinion.centre
    if "gear:" in " ".join(g.links[name]):
        return
    first, second = (x, y) if g.carries[name].index(x) == 0 else (y, x)
    way = (g.at[second] - g.at[first]) / abs(g.at[second] - g.at[first])
    p, travel, side = g.letter(), g.between(-40, 60), g.one(["left", "right"])
    off = pinion.radius if side == "left" else -pinion.radius
    g.at[p] = g.at[first] + way * (travel + 1j * off)
    rack = g.link([f"block: {p}", f"rack: {p}", f"s: {travel!r} mm"], [p])
    g.joints += [
        f"{rack} slides on {first}{second} of {name} with {p} {pinion.radius!r} mm {side}",
        f"{pinion.link} rolls on {rack} at {g.letter()}",
    ]


def planet_rod(g: Growing) -> None:
    """An idler between two gears on fixed pivots, then a planet about a dyad's hinge: gears in a row."""
    gear_on_pivot(g)
    gear_on_pivot(g)
    dyad(g)
    gear_on_link(g)
    gear_on_link(g)


def train(g: Growing, more: float = 0.4) -> None:
    """An arm with one or two planets between a known sun on a fixed pivot and a fixed ring (or a fixed sun).

    more: how often there are two."""
    known = [c for c in g.circles if c.centre in g.frame]
    if not known:
        return
    sun = known[int(g.random.integers(len(known)))]
    a, phi, r = sun.centre, g.between(-pi, pi), g.between(8, 40)
    b = g.letter()
    g.at[b] = g.at[a] + cmath.rect(sun.radius + r, phi)
    planet = pinned(g, b, r)
    g.joints.append(f"{planet} rolls on {sun.link} at {g.letter()}")
    arm, carried = [g.length(a, b)], [a, b]
    last, centre, at = planet, r, b
    if g.random.random() < more:
        c, s = g.letter(), g.between(8, 30)
        g.at[c] = g.at[b] + cmath.rect(r + s, phi + g.between(-1.2, 1.2))
        last, centre, at = pinned(g, c, s), s, c
        g.joints.append(f"{last} rolls on {planet} at {g.letter()}")
        ab, ac = g.at[b] - g.at[a], g.at[c] - g.at[a]
        local = ac / (ab / abs(ab))
        arm.append(f"{c}: {{along: {a}{b}, at: {local.real!r} mm, left: {local.imag!r} mm}}")
        carried.append(c)
    ring = abs(g.at[at] - g.at[a]) + centre
    g.joints.append(f"{last} rolls inside circle about {a} of {ring!r} mm at {g.letter()}")
    g.link([*arm, f"phi: {degrees(phi)!r} deg"], carried)


OPS: dict[str, list[Callable[[Growing], None]]] = {
    "gears-pivots": [gear_on_pivot, gear_on_pivot, dyad, slider, gear_on_link],
    "gears-arms": [gear_on_link, gear_on_link, gear_on_link, dyad, slider],
    "gears-racks": [rack_on_guide, slider, rack_on_pin, gear_on_pivot, dyad],
    "gears-rolling": [rolling_centre, rolling_centre, slider_gear, dyad, gear_on_link],
    "gears-trains": [train, gear_on_pivot, dyad, gear_on_link],
    "gears-moving-racks": [gear_on_link, gear_on_link, rack_on_link, rack_on_link, dyad],
    "gears-rows": [planet_rod, planet_rod, slider, rolling_centre, rack_on_pin],
}


def _maker(name: str) -> Callable[[Random], str]:
    def make(random: Random) -> str:
        g = started(random)
        while not any(" rolls " in joint for joint in g.joints):
            g = started(random)
            for _ in range(int(random.integers(2, 6))):
                OPS[name][int(random.integers(len(OPS[name])))](g)
        return g.text()

    return make


for _name in OPS:
    family(_name, often=1)(_maker(_name))
