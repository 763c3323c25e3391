"""What is said of a mechanism's structure: moving links, degree of freedom, Assur groups;
the frame's number where forces are meant."""

from __future__ import annotations

from collections.abc import Sequence

from ...foundation.roman import NUMERALS
from ...foundation.slotted import replace
from ...mechanism.asked.pressure import pressure_quantities
from ...mechanism.groups.assur import Group, decompose, hinges
from ...mechanism.groups.mobility import Mobility, mobility
from ...mechanism.model import FRAME, Mechanism
from ...mechanism.seats import seat
from ...problem.problem import Problem
from ...words import Words
from .driver import driver, loads_of

_HIGHER = {f"class {en}": f"{zh} 级" for en, zh in NUMERALS.items() if en not in ("I", "II")}


def structure(problem: Problem) -> Words:
    """Number of links, degree of freedom, Assur groups; nothing for a device."""
    if not isinstance(problem.subject, Mechanism):
        return Words.same("")
    mech = problem.subject
    freedom = "" if _is_taken(problem, "F") else "$F$ = "
    return welded(mech) + _made_of(mech, driver(problem), decompose(mech), freedom)


def _is_taken(problem: Problem, letter: str) -> bool:
    """Whether a point, a load or the force of a pressure angle has this letter: one letter means one thing."""
    mech, asked = problem.mechanism, {ask.rel.key for ask in problem.asks}
    points = {p for link in mech.links for p in link.points} | set(mech.frame)
    acting = loads_of(problem)
    loads = {load.name for load in acting.all} if acting is not None else set()
    return letter in points | loads or bool(asked & set(pressure_quantities(mech)))


def welded(mech: Mechanism) -> Words:
    """Rollers that are no links of their own."""
    if not mech.welded:
        return Words.same("")
    zh = "、".join(f"滚子 {roller} 与构件 {host}" for roller, host in mech.welded)
    en = " and ".join(f"roller {roller} to link {host}" for roller, host in mech.welded)
    return Words(
        f"滚子绕自身轴线的转动为局部自由度，不影响其余构件的运动，先将{zh} 焊成一体。",
        "A roller that turns about its own pin is a passive degree of freedom, without effect on the other "
        f"links; weld {en}. ",
    )


def numbering(problem: Problem) -> Words:
    """The frame's number and what R_ij means, where forces act on a mechanism."""
    if problem.loads is None:
        return Words.same("")
    number = problem.mechanism.frame_number
    return (
        Words(
            f"机架为构件 {number}；$R_{{ij}}$ 表示构件 $i$ 对构件 $j$ 的作用力。",
            f"The frame is link {number}; $R_{{ij}}$ is the force of link $i$ on link $j$.",
        )
        + carried_pins(problem.mechanism)
        + _any_speed(problem)
    )


def carried_pins(mech: Mechanism) -> Words:
    """At each multiple joint: which link carries the pin, so that the others press on it alone;
    nothing where there is none."""
    found = {point: carrier for point in hinges(mech) if (carrier := seat(mech, point)) is not None}
    if not found:
        return Words.same("")
    zh = "；".join(f"${point}$ 处的销轴属于{_carrier(mech, link).zh}" for point, link in found.items())
    en = "; ".join(f"the pin at ${point}$ belongs to {_carrier(mech, link).en}" for point, link in found.items())
    return Words(
        f"复合铰链{zh}，铰接于该处的其他构件只与它相互作用，彼此间无反力。",
        f" At multiple joints one link carries the pin, the others press on it, not on each other: {en}.",
    )


def _carrier(mech: Mechanism, link: str) -> Words:
    return Words("机架", "the frame") if link == FRAME else Words(f"构件 {link}", f"link {link}")


def _any_speed(problem: Problem) -> Words:
    """Where only the sense of the driver's ω is given: that its size does not matter, and which is drawn."""
    drive = problem.mechanism.drive
    if drive.slide or not any(
        datum.words is not None and datum.words.zh.startswith(f"$ω_{drive.link}$") for datum in problem.given.motion
    ):
        return Words.same("")
    return Words(
        f"$ω_{drive.link}$ 只给转向，其大小不影响受力，作图取 1 rad/s。",
        f" Of $ω_{drive.link}$ only the sense is given; its magnitude is immaterial to the forces; 1 rad/s is taken.",
    )


def _seen(mech: Mechanism, count: Mobility) -> tuple[Mobility, Words]:
    """The count of the links that are seen: a pin in a slot is a higher pair, for which the drawing puts a block."""
    pins = len(mech.slot_pins)
    return (
        replace(count, links=count.links - pins, lower=count.lower - 2 * pins, higher=count.higher + pins),
        Words("（销与槽构成的运动副为高副）", " (a pin in a slot is a higher pair)") if pins else Words.same(""),
    )


def _made_of(mech: Mechanism, drives: Words, groups: tuple[Group, ...], freedom: str) -> Words:
    counted = mobility(mech)
    count, slots = _seen(mech, counted)
    higher = f" − {count.higher}" if count.higher else ""
    sum_up = f"{freedom}3×{count.links} − 2×{count.lower}{higher} = {count.freedom}"
    if any("G" in g.kind or g.kind in ("gear", "rack", "gear train") for g in groups):
        return (
            Words(
                f"机构有 {count.links} 个活动构件，自由度 {sum_up}",
                f"The mechanism has {count.links} moving links; its degree of freedom is {sum_up}",
            )
            + _rolling(counted.higher > len(mech.contacts))
            + Words("；", ". ")
            + drives
            + Words("。", ".")
        )
    zh = "、".join(f"{group_zh(g)}（{_links(mech, g.links).zh}{_as_bar(g).zh}）" for g in groups)
    *named, last = [f"{kind_of(g).en} ({_links(mech, g.links).en}{_as_bar(g).en})" for g in groups] or [""]
    en = " and ".join(filter(None, (", ".join(named), last)))
    kind = "the Assur group" if len(groups) == 1 else "made up of the Assur groups"
    kind += " of" if len(groups) == 1 and groups[0].kind in _HIGHER else ""
    opening = _counted(mech, count) + Words(
        f"，自由度 {sum_up}{slots.zh}；{drives.zh}，", f"; its degree of freedom is {sum_up}{slots.en}. {drives.en}"
    )
    if any(g.kind == "driven" for g in groups):
        return opening + _inside(groups)
    replaced = Words("", ";")
    if mech.contacts:
        replaced = Words("高副低代后，", "; with the higher pair replaced by a link and lower pairs,")
    elif slots.zh:
        replaced = Words("在销处各加一滑块作高副低代后，", "; with a block put in place of each pin in its slot,")
    rest = Words(
        f"其余为 {zh}，属{_class(groups).zh}机构。",
        f" the rest is {kind} {en}, so this is a {_class(groups).en} mechanism.",
    )
    return opening + replaced + rest


def _counted(mech: Mechanism, count: Mobility) -> Words:
    """How many links there are; where a roller is none of them, the numbers on the diagram run on past it."""
    if not mech.welded:
        return Words(
            f"机构有 {count.links} 个活动构件（连机架共 {count.links + 1} 个构件）",
            f"The mechanism has {count.links} moving links ({count.links + 1} with the frame)",
        )
    rollers = [roller for roller, _ in mech.welded]
    zh, en = "、".join(rollers), " and ".join(rollers)
    return Words(
        f"焊接后滚子 {zh} 不另计，机构有 {count.links} 个活动构件，连机架 {mech.frame_number} 共 "
        f"{count.links + 1} 个构件",
        f"With roller{'s' * (len(rollers) > 1)} {en} not counted, the mechanism has {count.links} moving links "
        f"({count.links + 1} with the frame, link {mech.frame_number})",
    )


def _rolling(higher: bool) -> Words:
    """How pure rolling is counted; higher: as gears whose centres a link holds apart."""
    if higher:
        return Words(
            "（中心距由构件保证的齿轮副，按高副计）", " (gears whose centres links hold apart count as a higher pair)"
        )
    return Words(
        "（纯滚动副限制两个自由度，按低副计）",
        " (pure rolling removes two degrees of freedom and counts as a lower pair)",
    )


def _inside(groups: tuple[Group, ...]) -> Words:
    """Of which links the group consists in which the input acts, and what is done about it; the other groups."""
    own = next(g for g in groups if g.kind == "driven")
    rest = [g for g in groups if g is not own]
    zh, en = "、".join(own.links), ", ".join(own.links)
    others = (
        Words(
            "；其余为 " + "、".join(f"{group_zh(g)}（构件 {'、'.join(g.links)}）" for g in rest),
            "; the rest is made up of " + ", ".join(f"{kind_of(g).en} (links {', '.join(g.links)})" for g in rest),
        )
        if rest
        else Words.same("")
    )
    return (
        Words(
            f"它所连的都是活动构件，驱动作用在构件 {zh} 组成的杆组之内，不能由原动件起逐组求解；"
            "作图时改取其中一个与机架相连的构件为假想原动件",
            f", acting between two moving links inside the group of links {en}, which cannot be taken "
            "group by group from the input; for the drawing a link of the group on the frame is "
            "thought to drive instead",
        )
        + others
        + Words("。", ".")
    )


def kind_of(group: Group) -> Words:
    """The kind of a group as printed; with a cylinder of known length as one of its bars."""
    told = {"cylinder RR": "RRR", "cylinder RP": "RRP"}.get(group.kind, group.kind)
    return (
        Words("含驱动副的", "the group with the driven pair")
        if told == "driven"
        else Words(_HIGHER.get(told, told), told)
    )


def group_zh(group: Group) -> str:
    """RRR 杆组, Ⅲ 级杆组."""
    kind = kind_of(group).zh
    return f"{kind}{' ' * kind.isascii()}杆组"


def _as_bar(group: Group) -> Words:
    return Words.same("") if group.ram is None else Words("，油缸视为一杆", ", the cylinder being one bar")


def _class(groups: tuple[Group, ...]) -> Words:
    """The class of the highest group."""
    kinds = [kind for kind in _HIGHER if any(group.kind == kind for group in groups)]
    return Words(f" {_HIGHER[kinds[-1]]}", kinds[-1]) if kinds else Words(" Ⅱ 级", "class II")


def _links(mech: Mechanism, links: Sequence[str]) -> Words:
    """Links 2, 3; link 2, the substitute for K."""
    told = {link: _told(mech, link) for link in links}
    numbered = [one for one in links if told[one].en == one]
    others = [told[one] for one in links if told[one].en != one]
    first = Words(f"构件 {'、'.join(numbered)}", f"link{'s' * (len(numbered) > 1)} {', '.join(numbered)}")
    every = (first, *others) if numbered else others
    return Words("、".join(one.zh for one in every), ", ".join(one.en for one in every))


def _told(mech: Mechanism, link: str) -> Words:
    """A link's number; the link that stands for a higher pair by that contact's letter."""
    if link not in mech.substitutes and not link[0].isdigit():  # the block of a pin that runs in a slot
        point = next(iter(mech.link(link).points))
        return Words(f"销 ${point}$ 处的滑块", f"the block at the pin ${point}$")
    contact = next((c for c in mech.contacts if c.substitute == link), None)
    return (
        Words.same(link)
        if contact is None
        else Words(f"代替高副 ${contact.point}$ 的杆", f"the substitute for ${contact.point}$")
    )
