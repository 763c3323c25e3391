"""A chain of stages as it is written becomes a plan: which body each pin is on, and which loops come of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...errors import FaultError
from ...words import Words
from ..base import between_limits
from .loops import Hinged, Loop, Sliding
from .plan import FRAME, Assemble, Body, Find, Limit, Limits, On, Pin, Plan, Position, Slide, Stage, Through
from .step import Step


class Assembly:
    """What is known so far, while the stages are read; raises FaultError for letters that are not known."""

    def __init__(
        self,
        frame: Mapping[str, complex],
        links: Mapping[str, float],
        rays: Mapping[str, tuple[float, ...]],
        points: Mapping[str, tuple[complex, ...]],
    ) -> None:
        self._links, self._rays = links, rays
        self._count = _one_count(rays, points)
        self._slides = {letter: _slide(letter, places) for letter, places in points.items()}
        self._pivots = {letter: letter for letter in frame}  # of every pin on a link that turns about the frame
        self._pins = [Pin(letter=letter, on=FRAME, at=at) for letter, at in frame.items()]
        self._bodies = {name: self._body(name, angles, frame) for name, angles in rays.items()}
        self._driver = next((body.pivot for body in self._bodies.values() if body.pivot), "")
        for name, body in self._bodies.items():
            if body.pivot and name in links:
                self._pins.append(Pin(letter=name[1], on=name, at=complex(links[name])))
                self._pivots[name[1]] = body.pivot

    def plan(self, steps: Iterable[Step]) -> Plan:
        """The whole of it."""
        made = [self._stage(step) for step in steps]
        return Plan(
            count=self._count,
            bodies=tuple(self._bodies.values()),
            pins=tuple(self._pins),
            slides=tuple(self._slides.values()),
            stages=tuple(stage for stage, _ in made),
            loops=tuple(loop for _, loop in made),
        )

    def _body(self, name: str, angles: tuple[float, ...], frame: Mapping[str, complex]) -> Body:
        """A ray in its positions: about a fixed pivot, or from the pin of a slider."""
        start = name[:1]
        if start in frame:
            return Body(name=name, pivot=start, positions=tuple(Position(at=frame[start], angle=at) for at in angles))
        if start not in self._slides:
            raise _unknown(start, (*frame, *self._slides))
        places = self._slides[start].places
        return Body(
            name=name, positions=tuple(Position(at=at, angle=angle) for at, angle in zip(places, angles, strict=True))
        )

    def _stage(self, step: Step) -> tuple[Stage, Loop]:
        if step.kind == "join":
            return self._join(step)
        return self._limits(step) if step.kind == "limits" else self._find(step)

    def _find(self, step: Step) -> tuple[Stage, Loop]:
        assert step.find and step.on and step.start
        pivot = self._ray(step.on)
        self._known(step.start)
        lies = None if self._count == 3 else On() if step.line is None else self._through(step.line)
        stage = Find(pin=step.find, on=step.on, known=step.start, lies=lies, kept=step.onto - 1)
        if not pivot:
            slide = self._slides[step.on[0]]
            return stage, Sliding(a=step.start, b=step.find, c=slide.letter, along=slide.along)
        self._pivots[step.find] = pivot
        if step.start in self._slides:
            along = self._slides[step.start].along
            return stage, Sliding(a=pivot, b=step.find, c=step.start, along=along)
        return stage, self._hinged(pivot, step.find, step.start)

    def _hinged(self, pivot: str, pin: str, known: str) -> Hinged:
        """The loop, from the pivot of the driver."""
        other = self._pivots[known]
        if pivot == self._driver:
            return Hinged(a=pivot, b=pin, c=known, d=other)
        return Hinged(a=other, b=known, c=pin, d=pivot)

    def _join(self, step: Step) -> tuple[Stage, Loop]:
        assert step.join and step.to and step.side
        one, two = (self._known(letter) for letter in _two(step.to))
        lengths = [self._link(step.join, letter) for letter in (one, two)]
        side = 1 if step.side == "left" else -1
        stage = Assemble(pin=step.join, one=one, to_one=lengths[0], two=two, to_two=lengths[1], side=side)
        pivot, pin = self._pivot_and_pin(step.join, one, two)
        self._pivots[step.join] = pivot
        return stage, Hinged(a=self._pivots[pin], b=pin, c=step.join, d=pivot)

    def _pivot_and_pin(self, joined: str, one: str, two: str) -> tuple[str, str]:
        """Which of two letters is the fixed pivot of a rocker, and which the pin that moves, in whichever order."""
        pivots = [letter for letter in (one, two) if self._pivots.get(letter) == letter]
        pins = [letter for letter in (one, two) if letter in self._pivots and letter not in pivots]
        if not pivots or not pins or self._pivots[pins[0]] == pivots[0]:
            raise _not_one_pivot(joined, one, two)
        return pivots[0], pins[0]

    def _limits(self, step: Step) -> tuple[Stage, Loop]:
        assert step.limits and step.on and step.crank and step.K and step.first and step.limit
        about, pin = (step.crank[0], step.crank[1])
        stage = Limits(
            pin=step.limits,
            of=step.on,
            pivot=self._known(step.on[0]),
            crank=pin,
            about=self._known(about),
            theta=between_limits(step.K),
            first=step.first.at,
            limit=Limit.LEFT if step.limit == "left" else Limit.RIGHT,
        )
        self._pivots |= {step.limits: stage.pivot, pin: about, step.on: stage.pivot}
        return stage, Hinged(a=about, b=pin, c=step.limits, d=stage.pivot)

    def _ray(self, name: str) -> str:
        """The pivot of a ray, nothing where it starts from a slider."""
        if name in self._bodies:
            return self._bodies[name].pivot
        if name not in self._pivots:
            raise _unknown(name, self._rays)
        return self._pivots[name]

    def _known(self, letter: str) -> str:
        if letter not in self._pivots and letter not in self._slides:
            raise _unknown(letter, (*self._pivots, *self._slides))
        return letter

    def _through(self, letters: str) -> Through:
        one, two = (self._known(letter) for letter in _two(letters))
        return Through(one=one, two=two)

    def _link(self, one: str, two: str) -> float:
        for letters in (one + two, two + one):
            if letters in self._links:
                return self._links[letters]
        raise _unknown(two + one, self._links)


def _slide(letter: str, places: tuple[complex, ...]) -> Slide:
    span = places[-1] - places[0]
    if len(places) < 2 or span == 0 or any(abs(((at - places[0]) / span).imag) > 1e-9 for at in places):
        raise FaultError(
            Words(
                f'{letter} 的各位置应是一条直线上的不同点（滑块的导路）；如写 ["(90, 0) mm", "(110, 0) mm"]',
                f"the places of {letter} must be different points of one straight line, its guide; write e.g. "
                '["(90, 0) mm", "(110, 0) mm"]',
            ),
            "points",
            letter,
            code="contradiction",
        )
    return Slide(letter=letter, places=places, along=span / abs(span))


def _one_count(rays: Mapping[str, tuple[float, ...]], points: Mapping[str, tuple[complex, ...]]) -> int:
    """How many positions there are: as many of each ray and point."""
    counts = {name: len(values) for name, values in (*rays.items(), *points.items())}
    if len(set(counts.values())) != 1 or not set(counts.values()) <= {2, 3}:
        told = ", ".join(f"{name}: {count}" for name, count in counts.items())
        raise FaultError(
            Words(
                f"每条射线、每个点都应有相同数目（2 或 3）的位置，此处为 {told or '无'}；请补齐",
                f"every ray and every point must have one number of positions, 2 or 3, and here are {told or 'none'}; "
                "write as many of each",
            ),
            code="contradiction",
        )
    return next(iter(counts.values()))


def _two(letters: str) -> tuple[str, str]:
    if len(letters) != 2:
        raise FaultError(
            Words(f"“{letters}”应为两个字母；如写 BD", f"'{letters}' should be two letters; write e.g. BD"),
            code="spelling",
        )
    return letters[0], letters[1]


def _not_one_pivot(pin: str, one: str, two: str) -> FaultError:
    return FaultError(
        Words(
            f"{pin} 须联接一个固定铰链和一个绕固定铰链转动的构件上的铰链，{one}、{two} 不是这样的一对；如写 to: BD",
            f"{pin} must join a fixed pivot and a pin of a link that turns about another, which "
            f"{one} and {two} are not; write e.g. to: BD",
        ),
        "stages",
        code="contradiction",
    )


def _unknown(name: str, known: Iterable[str]) -> FaultError:
    have = ", ".join(known)
    return FaultError(
        Words(
            f"到这一步还不知道“{name}”；已知 {have or '无'}",
            f"'{name}' is not known at this stage; known are {have or 'none'}",
        ),
        "stages",
        code="unknown-name",
    )
