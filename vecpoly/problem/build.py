"""From validated text to a Problem; every fault is noted at its place, and all are told together."""

from __future__ import annotations

import re
from pathlib import Path

from ..errors import FaultError
from ..foundation.indices import LETTER
from ..foundation.slotted import replace
from ..foundation.stock import ANY_A4, paper_of
from ..mechanism.model import Drive, Joint, Mechanism
from ..mechanism.seats import seated
from ..units.reading import Dim, read
from ..words import Words
from .asked.sought import read_wanted
from .asked.tables import read_tables
from .asked.target import read_target
from .gate import read_gate
from .joints.branches import read_branches
from .joints.contacts import is_contact, read_contact
from .joints.idle import idle_gears
from .joints.joints import read_joint, revolutes
from .joints.motion import read_input
from .joints.pins import read_pins
from .joints.profiles import read_profiles
from .joints.rolling import is_rolling, read_rolling
from .joints.slide_data import with_offset
from .links.bodies import Bodies
from .links.draft import refuse_frame
from .links.links import read_link
from .links.masses import read_masses
from .links.profiles import letter_centres
from .links.rollers import weld_rollers
from .links.standing import geared
from .links.starts import say_travels
from .loads.acting import read_acting
from .moves import settle
from .problem import Datum, Given, Problem
from .read_ranges import read_ranges
from .schema.faults import Faults, meant
from .schema.models import ProblemSpec
from .schema.validate import validate
from .schema.warnings import warnings_of
from .text.respelled import respelled
from .text.source import Tree
from .values.written import Written, written_of


def build(tree: Tree, path: Path | None = None, written: Written | None = None) -> Problem:
    """The problem in this tree; raises ProblemFileError with all that is wrong with it. written: the tree, as kept."""
    if (by_data := _by_data(tree := respelled(tree), path)) is not None:
        return by_data
    spec, faults = _spec(tree)
    masses = read_masses(spec, bodies := _bodies(spec, faults), faults)
    mechanism, motion = _mechanism(spec, bodies, faults)
    loads, machine, weighed, acting = read_acting(spec, bodies, (mechanism, motion), masses, faults)
    asks, curvature, printed, scales = read_wanted(spec, bodies, mechanism, loads, machine, weighed, faults)
    ranges, gate = read_ranges(spec.vary, tree.data, faults), read_gate(spec.gate, faults)
    tables, target = read_tables(spec, tree, faults), read_target(spec, mechanism, faults)
    settle(mechanism, tree, faults)
    return Problem(
        id=spec.id,
        title=spec.title,
        source=spec.source,
        statement=spec.statement,
        explain=tuple(spec.explain),
        subject=mechanism,
        loads=loads,
        machine=machine,
        counterweights=weighed,
        by_centres=spec.method == "centres",
        curvature=curvature,
        asks=asks,
        scales=scales,
        printed=printed,
        errata=tuple(spec.errata),
        tables=tables,
        given=_given(bodies, mechanism, motion, acting),
        paper=paper_of(spec.sheet.format, spec.sheet.orientation) if spec.sheet else ANY_A4,
        path=path,
        text=tree.text,
        read=tree.files,
        ranges=ranges,
        target=target,
        gate=gate,
        warnings=warnings_of(tree),
        written=written or written_of(tree),
    )


def _spec(tree: Tree) -> tuple[ProblemSpec, Faults]:
    """What stands in the file, and a list for what is wrong with it."""
    faults = Faults(tree.name, tree.places)
    return validate(ProblemSpec, {key: value for key, value in tree.data.items() if value is not None}, faults), faults


def _by_data(tree: Tree, path: Path | None) -> Problem | None:
    """The problem, where it is about a device, or about a mechanism that is to be found."""
    if not {"device", "synthesis", "data"} & tree.data.keys():
        return None
    from .by_data import build_by_data, sort_of  # late: a mechanism needs none of it

    return build_by_data(tree, sort, path) if (sort := sort_of(tree)) is not None else None


def _mechanism(spec: ProblemSpec, bodies: Bodies, faults: Faults) -> tuple[Mechanism, tuple[Datum, ...]]:
    """The mechanism, of use only where no fault was found, and the data of its input."""
    joints = _joints(spec, bodies, faults)
    say_travels(bodies.drafts.values(), joints)
    drives, motion = _inputs(spec, bodies, joints, faults)
    branches = read_branches(spec.branch, bodies, faults)
    guesses = _points("guesses", spec.guesses, faults, bodies.letters())
    mech = Mechanism(
        frame=bodies.frame,
        links=tuple(draft.link() for draft in bodies.drafts.values()),
        joints=joints,
        drives=drives,
        branches=branches,
        contacts=tuple(bodies.contacts),
        starts=tuple(draft.start for draft in bodies.drafts.values() if draft.start is not None),
        guesses=guesses,
        welded=tuple(bodies.welded.items()),
        idle=idle_gears(bodies, joints),
    )
    mech = replace(mech, cams=read_profiles(mech, bodies, faults))
    return geared(seated(mech, read_pins(spec.pins, mech, faults)), spec, faults), motion


def _points(
    key: str, data: dict[str, tuple[str, str]], faults: Faults, known: tuple[str, ...] = ()
) -> dict[str, complex]:
    points = {}
    for letter, pair in data.items():
        with faults.at(key, letter):
            if not re.fullmatch(LETTER, letter):
                raise FaultError(
                    Words(
                        f"“{letter}”不是点的字母；应写 A 之类的大写字母",
                        f"'{letter}' is no letter of a point, such as A",
                    ),
                    code="spelling",
                )
            if known and letter not in known:
                raise FaultError(
                    Words(f"点“{letter}”不存在", f"point '{letter}' does not exist") + meant(letter, known),
                    code="unknown-name",
                )
            points[letter] = complex(read(pair[0], Dim.LENGTH).si, read(pair[1], Dim.LENGTH).si)
    return points


def _bodies(spec: ProblemSpec, faults: Faults) -> Bodies:
    bodies = Bodies(_points("frame", spec.frame, faults), {})
    for name, data in spec.links.items():
        with faults.at("links", name):
            if not re.fullmatch(r"[1-9]\d*[a-z']?", name):
                raise FaultError(
                    Words(
                        f"“{name}”不是构件号；构件编号为 1、2、3 ……（机架不写）",
                        f"'{name}' is no link number; links are numbered 1, 2, 3 ... (the frame has no entry)",
                    ),
                    code="spelling",
                )
            bodies.drafts[name] = read_link(name, data)
            refuse_frame(bodies.drafts[name], bodies.frame)
    for name, draft in bodies.drafts.items():
        with faults.at("links", name):
            if unknown := sorted(draft.towards - set(bodies.letters())):
                raise FaultError(
                    Words(f"点“{unknown[0]}”不存在", f"point '{unknown[0]}' does not exist")
                    + meant(unknown[0], bodies.letters()),
                    code="unknown-name",
                )
    if not faults.found:
        weld_rollers(spec, bodies, faults)
        letter_centres(bodies, spec.joints)
    if faults.found:  # what follows would only repeat the same faults in other words
        faults.settle()
    return bodies


def _joints(spec: ProblemSpec, bodies: Bodies, faults: Faults) -> tuple[Joint, ...]:
    written: list[Joint] = []
    for i, text in enumerate(spec.joints):
        with faults.at("joints", i):
            written += (
                read_contact(text, bodies)
                if is_contact(text)
                else (read_rolling(text, bodies) if is_rolling(text) else read_joint(text, bodies),)
            )
    return (*revolutes(bodies), *written)


def _inputs(
    spec: ProblemSpec, bodies: Bodies, joints: tuple[Joint, ...], faults: Faults
) -> tuple[tuple[Drive, ...], tuple[Datum, ...]]:
    drives: list[Drive] = []
    motion: list[Datum] = []
    several = isinstance(spec.input, list)
    with faults.at("input"):
        if not spec.input:
            raise FaultError(
                Words(
                    "没有给出原动件；请写如 input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}",
                    "no link is driven; write e.g. input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}",
                )
            )
    for i, item in enumerate(spec.input if isinstance(spec.input, list) else [spec.input]):
        with faults.at(*(("input", i) if several else ("input",))):
            drive, data = read_input(item, bodies, joints)
            if drive.link in [other.link for other in drives]:
                raise FaultError(
                    Words(
                        f"构件 {drive.link} 已由另一项驱动；请删去其一",
                        f"link {drive.link} is driven by another entry already; leave out one of them",
                    ),
                    "link",
                )
            drives.append(drive)
            motion.extend(data)
    return tuple(drives), tuple(motion)


def _given(bodies: Bodies, mech: Mechanism, motion: tuple[Datum, ...], acting: tuple[Datum, ...]) -> Given:
    return Given(
        lengths=tuple(with_offset(datum, mech) for draft in bodies.drafts.values() for datum in draft.lengths),
        motion=motion,
        loads=acting,
        letters=bodies.letters(),
        shapes={name: draft.shape for name, draft in bodies.drafts.items()},
    )
