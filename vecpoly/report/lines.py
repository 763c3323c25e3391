"""The table of lines of action: for each reaction a point of its line,
and on which side it touches the friction circle."""

from __future__ import annotations

from math import degrees

from ..algebra.columns import with_zeros
from ..algebra.quantity import number
from ..board.construction import LineOfAction, View
from ..board.said.sides import side_of
from ..check.truths.analysis import pin_of
from ..mechanism.asked.forces import leaning_symbol, pairs, press_named
from ..mechanism.groups.assur import ends, is_held
from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism, Rolling
from ..printed.places import place_parts
from ..solution import Answer, Solution
from ..words import Lang, Words
from .flow.table import DataTable
from .tables import trimmed
from .values import called

_HEADER = {
    "zh": ("力", "$x$ /mm", "$y$ /mm", "作用线的位置", "距精确作用线 /mm"),
    "en": ("Force", "$x$ /mm", "$y$ /mm", "Position of the line of action", "Off the exact line /mm"),
}
_WAY = {True: Words("（逆时针）", ", counter-clockwise"), False: Words("（顺时针）", ", clockwise")}
_TENTH = 0.1  # mm, to which a rule is read
_SENSE = {"ccw": Words("逆时针", "counter-clockwise"), "cw": Words("顺时针", "clockwise")}


def lines_table(solution: Solution, lang: Lang) -> DataTable | None:
    """One line a reaction whose line of action was drawn; none where there is no such reaction."""
    acting = [
        (answer, acts)
        for answer in solution.answers.values()
        if (acts := answer.reading.acts) is not None and (answer.drawn or acts.couple)
    ]
    if not acting:
        return None
    rows = [
        _row(answer, acts, _told(solution, acts), lies(solution, answer.key, acts), lang) for answer, acts in acting
    ]
    if all(row[-1] in ("0", "—") for row in rows):  # every line lies where it must
        rows = [(*row[:-1], "—") for row in rows]
    rows = [(*row[:-1], off) for row, off in zip(rows, with_zeros([row[-1] for row in rows]), strict=True)]
    return trimmed(_HEADER[lang], rows, (), "lddld", lang)


def _row(answer: Answer, acts: LineOfAction, at: complex, how: Words, lang: Lang) -> tuple[str, ...]:
    if acts.couple is not None:
        return called(answer.reading.symbol, answer.key, lang), "∞", "∞", how.of(lang), "—"
    x, y = place_parts(at, 1)
    return called(answer.reading.symbol, answer.key, lang), x, y, how.of(lang), _off(answer, acts)


def _told(solution: Solution, acts: LineOfAction) -> complex:
    """The point of the line (m); one whose place is an answer, as it was read there."""
    figure = solution.construction.figure(View.MECHANISM)
    near = 0.0 if figure is None else figure.scale.value * _TENTH
    places = (one.drawn_vector for one in solution.answers.values() if one.is_place and one.drawn_vector is not None)
    return next((place for place in places if abs(place - acts.point) < near), acts.point)


def lies(solution: Solution, key: str, acts: LineOfAction) -> Words:
    """On which side the line touches a friction circle, that it passes through a pin,
    or how it leans from the normal of a slide."""
    if acts.told is not None:
        return acts.told
    if acts.couple is not None:
        return (
            Words(
                f"在无穷远处：力偶 {number(abs(acts.couple))} N·m",
                f"at infinity: a couple of {number(abs(acts.couple))} N·m",
            )
            + _WAY[acts.couple > 0]
        )
    mech, loads = solution.problem.subject, solution.problem.loads
    links = _links(mech, key) if isinstance(mech, Mechanism) else None
    if not isinstance(mech, Mechanism) or links is None:
        return _tangent(solution, key, acts, "") if acts.tangent else _displaced(loads, key)
    pin = pin_of(mech, *links)
    if acts.tangent:
        return _tangent(solution, key, acts, pin)
    return (
        Words(f"过铰链 ${pin}$ 的中心", f"through the centre of ${pin}$")
        if pin
        else _of_teeth(mech, links) or _leaning(mech, loads, links, key.endswith("_0"))
    )


def _tangent(solution: Solution, key: str, acts: LineOfAction, pin: str) -> Words:
    sense, side = _SENSE[acts.tangent], _side(solution, key, acts)
    at = Words(f" ${pin}$ 的", f" of ${pin}$") if pin else Words.same("")
    on = Words(f"{side.zh}侧", f" ({side.en} side)") if side is not None else Words.same("")
    return Words(
        f"切于{at.zh}摩擦圆{on.zh}，对其中心之矩{sense.zh}",
        f"tangent to the friction circle{at.en}{on.en}, moment {sense.en}",
    )


def _side(solution: Solution, key: str, acts: LineOfAction) -> Words | None:
    """To which side of the centre a force lies that has this moment about it."""
    vector = solution.answers[key].drawn_vector if key in solution.answers else None
    return side_of(vector * (-1j if acts.tangent == "ccw" else 1j)) if vector else None


def _displaced(loads: Loads | None, key: str) -> Words:
    """An inertia force and couple joined into one force beside the centre of mass."""
    mass = loads.mass(key.removeprefix("F_I")) if loads is not None and key.startswith("F_I") else None
    if mass is None:
        return Words.same("—")
    spot = f"${mass.centre[0]}_{{{mass.centre[1:]}}}$" if mass.centre[1:] else f"${mass.centre}$"
    if not mass.inertia:
        return Words(f"过质心 {spot}", f"through the centre of mass {spot}")
    return Words(f"自质心 {spot} 偏移 $h_{mass.link}$", f"displaced by $h_{mass.link}$ from the centre of mass {spot}")


def _of_teeth(mech: Mechanism, links: tuple[str, str]) -> Words | None:
    """The line of action of teeth, or only the pitch point where nothing else holds the gears; None without teeth."""
    joint = next((j for j in mech.joints if isinstance(j, Rolling) and set(ends(j)) == set(links)), None)
    if joint is None:
        return None
    through = Words(f"过节点 ${joint.point}$", f"through the pitch point ${joint.point}$")
    if not is_held(mech, joint):
        return through
    alpha = f"{number(degrees(joint.alpha))}°"
    return Words("沿啮合线，", "along the line of action ") + through + Words(f"，α = {alpha}", f", α = {alpha}")


def _leaning(mech: Mechanism, loads: Loads | None, links: tuple[str, str], ideal: bool) -> Words:
    """A reaction of a slide or of a contact, and the friction angle between it and the normal."""
    contact = next((c for c in mech.contacts if set(c.links) == set(links)), None)
    friction = loads.friction if loads is not None and not ideal else None
    phi = (
        0.0
        if friction is None
        else friction.contacts.get(contact.point, 0.0)
        if contact is not None
        else next((angle for pair, angle in friction.slides.items() if set(pair) == set(links)), 0.0)
    )
    normal = (
        Words("导路法线", "the normal of the guide")
        if contact is None
        else Words(f"接触点 ${contact.point}$ 处的公法线", f"the common normal at the contact ${contact.point}$")
    )
    if not phi:
        return Words(f"沿{normal.zh}", f"along {normal.en}")
    lean = f"${leaning_symbol(mech, links if contact is None else contact.point)}$ = {number(degrees(phi))}°"
    return Words(f"偏离{normal.zh} {lean}", f"inclined to {normal.en} by {lean}")


def _off(answer: Answer, acts: LineOfAction) -> str:
    """How far the drawn point lies from the exact line (mm)."""
    if answer.exact_acts is None or not answer.exact_vector:
        return "—"
    along = answer.exact_vector / abs(answer.exact_vector)
    off = 1e3 * abs((along.conjugate() * (acts.point - answer.exact_acts.point)).imag)
    return "0" if off < 1e-6 else number(off, 2)


def _links(mech: Mechanism, key: str) -> tuple[str, str] | None:
    """The two links of a reaction's key, by their names."""
    body = key.removeprefix("R_").removesuffix("_0")
    return next(
        ((a, b) for a, b in pairs(mech) if f"R_{body}" in (press_named(mech, a, b).key, press_named(mech, b, a).key)),
        None,
    )
