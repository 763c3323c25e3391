"""Class III groups with all kinds of legs: a pose is laid out first, and the lengths are taken from it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .family import family

LEGS = ("hinged", "guided", "slotted-block", "slotted-slot", "pin")


@dataclass(slots=True)
class Layout:
    """Links as lettered places in the plane (mm), and what becomes the text of a problem."""

    rng: np.random.Generator
    frame: dict[str, complex] = field(default_factory=dict)
    bars: dict[str, dict[str, complex]] = field(default_factory=dict)
    texts: dict[str, str] = field(default_factory=dict)
    joints: list[str] = field(default_factory=list)
    guesses: list[str] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)
    letters: list[str] = field(default_factory=lambda: list("ZYXWVUTSRQPONMLKJIHGFEDC"))

    def letter(self) -> str:
        return self.letters.pop()

    def on(self, link: str, at: complex) -> str:
        """A new letter at this place on a link, or on the frame."""
        name = self.letter()
        (self.frame if link == "frame" else self.bars[link])[name] = at
        return name

    def near(self, at: complex, span: float) -> complex:
        return at + span * complex(*self.rng.uniform(-1, 1, 2))

    def way(self) -> complex:
        return complex(np.exp(1j * self.rng.uniform(0, 2 * np.pi)))

    def length(self) -> float:
        return float(self.rng.uniform(40, 160))


def bar_text(points: dict[str, complex]) -> str:
    """A link by its first length and the offsets of its further points."""
    (p, a), (q, b), *rest = points.items()
    x = (b - a) / abs(b - a)
    text = f"{p}{q}: {abs(b - a):.9f} mm"
    for name, at in rest:
        local = (at - a) / x
        text += f", {name}: {{along: {p}{q}, at: {local.real:.9f} mm, left: {local.imag:.9f} mm}}"
    return "{" + text + "}"


def leg(lay: Layout, kind: str, plate: str, parent: str, at: complex, link: str) -> None:
    """One leg of this kind at the place `at` of the plate, on a known link."""
    if kind == "hinged":
        inner = lay.on(plate, at)
        far = at + lay.length() * lay.way()
        outer = lay.on(parent, far)
        lay.bars[link] = {outer: far, inner: at}
        lay.finds += [f"{kind}_{inner}{'' if parent == 'frame' else outer}" for kind in ("an", "at")]
    elif kind == "guided":
        _guided(lay, lay.on(plate, at), parent, at, link)
    elif kind == "parallel":
        _parallel(lay, plate, parent, at, link)
    else:
        _slotted(lay, kind, plate, parent, at, link)


def _guided(lay: Layout, inner: str, parent: str, at: complex, link: str) -> None:
    way, off = lay.way(), round(float(lay.rng.choice([0.0, lay.rng.uniform(-30, 30)])), 4)
    foot = at - 1j * way * off
    lay.texts[link] = f"{{block: {inner}}}"
    offset = beside(inner, off)
    lay.finds += [f"{kind}_{inner}{link}{inner}{parent}" for kind in ("v", "ak", "ar") if parent != "frame"]
    if parent == "frame" and lay.rng.random() < 0.5:
        at_frame, angle = lay.on("frame", foot - lay.length() * way), np.degrees(np.angle(way))
        lay.joints.append(f"{link} slides on line through {at_frame} at {angle:.9f} deg{offset}")
        return
    one, two = lay.on(parent, foot - lay.length() * way), lay.on(parent, foot + lay.length() * way)
    lay.joints.append(f"{link} slides on {one}{two}{offset}")


def _slotted(lay: Layout, kind: str, plate: str, parent: str, at: complex, link: str) -> None:
    """A pin Q on the parent: a block or a pin in a slide of the plate, or a slot about Q in which the plate slides."""
    way, pin = lay.way(), lay.on(parent, at)
    if kind != "pin":
        lay.finds += [f"{rel}_{pin}{plate}{pin}{link}" for rel in ("v", "ak", "ar")]
    if kind == "slotted-slot":
        off = round(float(lay.rng.choice([0.0, lay.rng.uniform(-20, 20)])), 4)
        inner = lay.on(plate, at + lay.length() * way + 1j * way * off)
        lay.texts[link] = f"{{slot: {pin}}}"
        first, second, *_ = lay.bars[plate].values()
        turn = np.degrees(np.angle((second - first) / way))
        lay.joints.append(f"{inner} of {plate} slides in {link}{beside(inner, off)} turned {turn:.9f} deg")
        return
    off = round(float(lay.rng.choice([0.0, lay.rng.uniform(-20, 20)])), 4) if kind == "slotted-block" else 0.0
    foot = at - 1j * way * off
    one, two = lay.on(plate, foot - lay.length() * way), lay.on(plate, foot + lay.length() * way)
    if kind == "pin":
        lay.joints.append(f"{pin} runs in {one}{two} of {plate}")
        return
    lay.texts[link] = f"{{block: {pin}}}"
    lay.joints.append(f"{link} slides on {one}{two}{beside(pin, off)}")


def _parallel(lay: Layout, plate: str, parent: str, at: complex, link: str) -> None:
    """A block that slides on the parent and on the plate: the plate keeps its angle to the parent."""
    own, guide, slide = lay.letter(), lay.way(), lay.way()
    if parent == "frame":
        joint = (
            f"{link} slides on line through {lay.on('frame', at - 60 * guide)} at {np.degrees(np.angle(guide)):.9f} deg"
        )
    else:
        joint = f"{link} slides on {lay.on(parent, at - 60 * guide)}{lay.on(parent, at + 60 * guide)}"
    one, two = lay.on(plate, at - 60 * slide), lay.on(plate, at + 60 * slide)
    lay.texts[link] = f"{{block: {own}}}"
    lay.joints += [
        joint,
        f"{link} slides on {one}{two} of {plate} turned {np.degrees(np.angle(guide / slide)):.9f} deg",
    ]
    lay.guesses.append(f"{own}: [{at.real:.3f} mm, {at.imag:.3f} mm]")
    lay.finds += [f"v_{own}", f"a_{own}"]


def beside(letter: str, off: float) -> str:
    """A point beside its guide."""
    return f" with {letter} {abs(off)} mm {'left' if off > 0 else 'right'}" if off else ""


def crank(lay: Layout) -> str:
    """A crank AB; its further points come with the legs that hang on it."""
    phi = float(lay.rng.integers(0, 360))
    lay.frame["A"], lay.bars["1"] = (
        0j,
        {"A": 0j, "B": lay.rng.uniform(20, 60) * complex(np.exp(1j * np.radians(phi)))},
    )
    return (
        f"{{link: 1, phi: {phi} deg, omega: {lay.rng.choice([-8, 3, 10])} rad/s, alpha: "
        f"{lay.rng.choice([0, 5, -20])} rad/s^2}}"
    )


def slider(lay: Layout) -> str:
    """A driving slider on a fixed guide, with a plate of its own."""
    s, tilt = float(lay.rng.integers(10, 80)), float(lay.rng.integers(-180, 180))
    way = complex(np.exp(1j * np.radians(tilt)))
    lay.frame["A"], lay.bars["1"] = 0j, {"B": s * way, lay.letter(): s * way + 50 * lay.way()}
    # a bar that slides without turning: its line is turned against the guide
    first, second = list(lay.bars["1"].values())
    turn = np.degrees(np.angle((second - first) / way))
    lay.joints.append(f"1 slides on line through A at {tilt} deg turned {turn:.9f} deg")
    return f"{{link: 1, s: {s} mm, v: {lay.rng.choice([-0.5, 0.2, 1])} m/s, a: {lay.rng.choice([0, 3])} m/s^2}}"


def four_bar(lay: Layout) -> tuple[str, str]:
    """A crank, coupler and rocker before the group: legs may hang on any of the three."""
    drive = crank(lay)
    b = lay.bars["1"]["B"]
    d, c = (
        complex(lay.rng.uniform(120, 200), lay.rng.uniform(-40, 40)),
        complex(lay.rng.uniform(60, 160), lay.rng.uniform(70, 130)),
    )
    name_c, name_d = lay.letter(), lay.letter()
    lay.frame[name_d] = d
    lay.bars["2"], lay.bars["3"] = {"B": b, name_c: c}, {name_d: d, name_c: c}
    left = ((c - b) / (d - b)).imag > 0
    return drive, f"branch: [{name_c} {'left' if left else 'right'} of B{name_d}]"


def text_of(lay: Layout, drive: str, branch: str, plate: str, finds: list[str]) -> str:
    """The problem as text."""
    points = lay.bars[plate]
    guesses = ", ".join([*(f"{p}: [{at.real:.3f} mm, {at.imag:.3f} mm]" for p, at in points.items()), *lay.guesses])
    links = "\n".join(
        f"  {name}: {lay.texts.get(name) or bar_text(lay.bars[name])}"
        for name in sorted({*lay.texts, *lay.bars}, key=int)
    )
    frame = ", ".join(f"{p}: [{at.real:.9f} mm, {at.imag:.9f} mm]" for p, at in lay.frame.items())
    quoted = ", ".join(f'"{joint}"' for joint in lay.joints)
    return (
        f"id: class-iii\ntitle: class III\nframe: {{{frame}}}\nlinks:\n{links}\njoints: [{quoted}]\n"
        f"input: {drive}\n{branch}\nguesses: {{{guesses}}}\nfind: [{', '.join(finds)}]\n"
    )


def asked(lay: Layout, plate: str) -> list[str]:
    """Velocities and accelerations of the plate's points, ω and α of every link."""
    names = sorted({*lay.texts, *lay.bars} - {"1"}, key=int)
    points = [f"{kind}_{p}" for kind in ("v", "a") for p in lay.bars[plate]]
    return [*points, *(f"{kind}_{name}" for kind in ("omega", "alpha") for name in names), *lay.finds]


def made(lay: Layout, drive: str, branch: str, parents: list[str], kinds: list[str]) -> str:
    """A group on the known links: at least one leg hangs on a moving one."""
    plate, start = str(len(lay.bars) + 1), complex(lay.rng.uniform(40, 140), lay.rng.uniform(60, 200))
    lay.bars[plate] = {lay.letter(): lay.near(start, 60), lay.letter(): lay.near(start, 60)}
    homes = [str(home) for home in lay.rng.choice(parents, 3)]
    if len(set(homes)) == 1:  # the whole group would move as one with that link
        homes[0] = parents[0] if homes[0] != parents[0] else parents[-1]
    kinds = ["hinged" if kind == "pin" and home == "frame" else kind for kind, home in zip(kinds, homes, strict=True)]
    number = int(plate) + 1
    for kind, home in zip(kinds, homes, strict=True):
        leg(lay, kind, plate, home, lay.near(start, 70), str(number))
        number += kind != "pin"
    return text_of(lay, drive, branch, plate, asked(lay, plate))


@family("class-iii", often=1)
def class_iii(rng: np.random.Generator) -> str:
    """Any three legs on a crank and the frame."""
    lay = Layout(rng)
    return made(lay, crank(lay), "", ["frame", "1"], [str(kind) for kind in rng.choice(LEGS, 3)])


@family("class-iii-hinged", often=1)
def class_iii_hinged(rng: np.random.Generator) -> str:
    """A plate on three bars."""
    lay = Layout(rng)
    return made(lay, crank(lay), "", ["frame", "1"], ["hinged"] * 3)


@family("class-iii-slider", often=1)
def class_iii_slider(rng: np.random.Generator) -> str:
    """Any three legs, driven by a slider."""
    lay = Layout(rng)
    return made(lay, slider(lay), "", ["frame", "1"], [str(kind) for kind in rng.choice(LEGS, 3)])


@family("class-iii-later", often=1)
def class_iii_later(rng: np.random.Generator) -> str:
    """Any three legs on the links of a four-bar."""
    lay = Layout(rng)
    drive, branch = four_bar(lay)
    return made(lay, drive, branch, ["frame", "1", "2", "3"], [str(kind) for kind in rng.choice(LEGS, 3)])


@family("class-iii-parallel", often=1)
def class_iii_parallel(rng: np.random.Generator) -> str:
    """One leg with two slides, two others of any kind, on a crank and the frame or on a four-bar."""
    lay = Layout(rng)
    drive, branch = four_bar(lay) if rng.random() < 0.5 else (crank(lay), "")
    kinds = ["parallel", *(str(kind) for kind in rng.choice(LEGS, 2))]
    rng.shuffle(kinds)
    return made(lay, drive, branch, ["frame", "1", "2", "3"] if branch else ["frame", "1"], kinds)


@family("class-iii-special", often=1)
def class_iii_special(rng: np.random.Generator) -> str:
    """Three bars, two of them parallel or nearly so, or one pointing at another's pin:
    the special point is far, or that pin."""
    lay = Layout(rng)
    drive, start, way = crank(lay), complex(rng.uniform(40, 140), rng.uniform(60, 200)), lay.way()
    pins = [lay.near(start, 70) for _ in range(3)]
    lay.bars["2"] = {lay.letter(): pin for pin in pins}
    if rng.random() < 0.6:
        ways = [way, way * complex(np.exp(1j * rng.choice([0.0, 1e-8, 1e-6, 1e-4, 1e-2, np.pi]))), lay.way()]
    else:
        ways = [lay.way(), (pins[1] - pins[0]) / abs(pins[1] - pins[0]), lay.way()]
    for link, inner, pin, out in zip("345", list(lay.bars["2"]), pins, ways, strict=True):
        far = pin + lay.length() * out
        lay.bars[link] = {lay.on("1" if link == "5" else "frame", far): far, inner: pin}
    return text_of(lay, drive, "", "2", asked(lay, "2"))


@family("class-iii-compound", often=1)
def class_iii_compound(rng: np.random.Generator) -> str:
    """Three bars, two of which share their pin on a known link, the plate's pins shared with a dyad that follows."""
    lay = Layout(rng)
    drive, start = crank(lay), complex(rng.uniform(40, 140), rng.uniform(60, 200))
    pins = [lay.near(start, 70) for _ in range(3)]
    lay.bars["2"] = {lay.letter(): pin for pin in pins}
    inner = list(lay.bars["2"])
    home, other = ("frame", "1") if rng.random() < 0.5 else ("1", "frame")
    shared = lay.on(home, far := pins[0] + lay.length() * lay.way())
    lay.bars["3"], lay.bars["4"] = {shared: far, inner[0]: pins[0]}, {shared: far, inner[1]: pins[1]}
    lay.bars["5"] = {lay.on(other, far := pins[2] + lay.length() * lay.way()): far, inner[2]: pins[2]}
    elbow, ground = pins[0] + lay.length() * lay.way(), pins[0] + lay.length() * lay.way()
    name, base = lay.letter(), lay.on("frame", ground)
    lay.bars["6"], lay.bars["7"] = {inner[0]: pins[0], name: elbow}, {base: ground, name: elbow}
    side = "left" if ((elbow - pins[0]) / (ground - pins[0])).imag > 0 else "right"
    return text_of(
        lay, drive, f"branch: [{name} {side} of {inner[0]}{base}]", "2", [*asked(lay, "2"), f"v_{name}", f"a_{name}"]
    )
