"""Friction as written: ``A: {rho: 6 mm}`` of a pin, ``3-4: {phi: 8 deg}`` of a slide, ``K: {f: 0.15}`` of a contact."""

from __future__ import annotations

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.loads import Friction, slide_name
from ...mechanism.model import FRAME, Mechanism, Prismatic, Rolling
from ...words import Words
from ..problem import Datum
from ..schema.faults import Faults, meant
from ..schema.models import FrictionSpec
from .how_much_friction import friction_angle, friction_circle, pins_of

_SLIDE = pattern(r"(\d+[a-z']?)\s*[-–]\s*(\d+[a-z']?)")


def read_friction(
    entries: dict[str, FrictionSpec], mech: Mechanism, faults: Faults
) -> tuple[Friction, tuple[Datum, ...]]:
    """Friction by pin, slide and contact, and its data for 已知."""
    pins: dict[str, float] = {}
    slides: dict[tuple[str, str], float] = {}
    contacts: dict[str, float] = {}
    data: list[Datum] = []
    letters = {contact.point for contact in mech.contacts}
    for name, spec in entries.items():
        with faults.at("friction", name):
            if m := _SLIDE.fullmatch(name):
                joint = _slide(m[1], m[2], mech)
                if joint in slides:
                    raise FaultError(
                        Words(
                            f"移动副 {m[1]}-{m[2]} 的摩擦已经给出；请删去其一",
                            f"the friction of the slide {m[1]}-{m[2]} is given twice; leave out one of the entries",
                        )
                    )
                told, slides[joint] = friction_angle(slide_name(m[1], m[2]), spec)
            elif name in letters:
                told, contacts[name] = friction_angle(name, spec)
            else:
                _pinned(name, mech)
                told, pins[name] = friction_circle(name, spec, mech)
            data.append(told)
    return Friction(pins=pins, slides=slides, contacts=contacts), tuple(data)


def _slide(one: str, other: str, mech: Mechanism) -> tuple[str, str]:
    """(block, guide) of the sliding pair of two links by printed numbers; for a pin in a slot the block is thought."""
    pair = {mech.named(one), mech.named(other)}
    known, thought = [], mech.substitutes
    for joint in mech.joints:
        if not isinstance(joint, Prismatic) or joint.block in thought:
            continue
        pin = mech.slot_pins.get(joint.block)
        blocks = [joint.block] if pin is None else [pin.carrier]
        if any({block, joint.guide} == pair for block in blocks):
            return joint.block, joint.guide
        known += [f"{mech.number(block)}-{mech.number(joint.guide)}" for block in blocks]
    if any({joint.gear.link, joint.on.link} == pair for joint in mech.joints if isinstance(joint, Rolling)):
        raise FaultError(
            Words(
                "此两构件作纯滚动，没有摩擦损失；请去掉此项",
                "these links roll on each other without sliding: no friction is lost there; leave the entry out",
            )
        )
    raise FaultError(
        Words(f"构件 {one} 与 {other} 不组成移动副", f"links {one} and {other} form no sliding pair")
        + (meant(f"{one}-{other}", known) if known else Words("；机构中没有移动副", "; there is none")),
        code="unknown-name",
    )


def _pinned(name: str, mech: Mechanism) -> None:
    """Raise FaultError where the letter is no pin."""
    pins = pins_of(mech)
    if name in pins:
        return
    if slot := next((pin for pin in mech.slot_pins.values() if pin.point == name), None):
        raise _slides_in(name, mech.number(slot.carrier), mech.number(slot.guide))
    if name in {joint.point for joint in mech.joints if isinstance(joint, Rolling)}:
        raise FaultError(
            Words(
                f"在 {name} 处两构件作纯滚动，没有摩擦损失；请去掉此项",
                f"at {name} links roll on each other without sliding: no friction is lost there; leave the entry out",
            )
        )
    if links := mech.links_at(name):
        only, known = _link(links[0]), ", ".join(pins)
        raise FaultError(
            Words(
                f"点 {name} 不是转动副，只有{only.zh}含有它；转动副有：{known}",
                f"point {name} is no pin, since only {only.en} carries it; pins: {known}",
            ),
            code="spelling",
        )
    contacts = [contact.point for contact in mech.contacts]
    raise FaultError(
        Words(
            f"“{name}”既不是转动副、接触点，也不是 3-4 之类的移动副",
            f"'{name}' is neither a pin nor a contact nor a sliding pair such as 3-4",
        )
        + meant(name, [*pins, *contacts]),
        code="unknown-name",
    )


def _slides_in(pin: str, carrier: str, guide: str) -> FaultError:
    """That a pin turns in no bearing; links by printed numbers."""
    return FaultError(
        Words(
            f"销 {pin} 不在轴承中转动，而在构件 {guide} 的槽中滑动；请写 {carrier}-{guide}: {{phi: 8 deg}}，"
            f"若销上套有滑块，请将滑块写成构件（{{block: {pin}}}）",
            f"pin {pin} turns in no bearing but slides in the slot of link {guide}; write {carrier}-{guide}: "
            f"{{phi: 8 deg}}, or, if a block sits on the pin, write the block as a link ({{block: {pin}}})",
        ),
        code="spelling",
    )


def _link(name: str) -> Words:
    return Words("机架", "the frame") if name == FRAME else Words(f"构件 {name}", f"link {name}")
