"""Chapter 8.1, how the mechanism moves:
full rotation, turns, limit positions with their cause, quick return, evenness of the output."""

from __future__ import annotations

from collections.abc import Iterator

from ..mechanism.groups.assur import decompose
from ..mechanism.rams import driver_words
from ..words import Words
from .conditioning import Conditioning
from .grashof import full_rotation
from .guide_bars import winding
from .output_links import ends, on_frame
from .shown import shown
from .strokes import limits_and_ratio, repeated_strokes
from .study.study import Study
from .symmetry import symmetry
from .transmission import least_places


def motion(study: Study, groups: list[Conditioning]) -> Iterator[Words]:
    """The facts of the cycle in order."""
    loops = tuple(full_rotation(study))
    yield from loops
    yield from _range(study, bool(loops), groups)
    yield from _turns(study)
    for stroke in study.facts.strokes:
        yield limits_and_ratio(study, stroke)
    yield from repeated_strokes(study)
    yield from symmetry(study)
    for link in study.facts.turns or {}:
        yield from evenness(study, link)


def _driver(study: Study) -> Words:
    """原动件 1 / the driving link 1; 油缸 2-3 / the cylinder 2-3."""
    if study.mech.drive.between:
        return driver_words(study.mech)
    return Words(f"原动件 {study.mech.drive.link} ", f"the driving link {study.mech.drive.link}")


def _through_changes(study: Study, one: Conditioning) -> Words:
    """How a linkage moves that passes change points."""
    at = least_places(study, one.gamma) if one.gamma is not None else None
    where = at or Words.same(study.where(one.phi))
    return Words(
        f"计算按题设的装配形式连续通过变点（{where.zh}）：机构在全部位置均可装配，但在变点处须靠惯性或附加的约束"
        "保持这一装配形式。",
        f"The calculation goes on through the change points, at {where.en}, in the given assembly: the mechanism "
        "can be assembled in every position, but there inertia or an additional constraint must keep it in that "
        "assembly.",
    )


def _all_round(study: Study, told: bool, groups: list[Conditioning]) -> Words:
    """That the drive turns right round, through change points where there are any."""
    driver, changed = _driver(study), [one for one in groups if one.is_none]
    if changed:
        return _through_changes(study, changed[0])
    return Words(
        f"计算结果{'与此一致' if told else '表明'}：{driver.zh}整周转动时，机构在全部位置均可装配，无死点。",
        f"The calculation {'agrees' if told else 'shows'}: the mechanism can be assembled in "
        f"every position of {driver.en}, and there is no dead point.",
    )


def _range(study: Study, told: bool, groups: list[Conditioning]) -> Iterator[Words]:
    driver, whole, free = _driver(study), study.entire, study.facts.unlimited
    if whole.whole:
        yield _all_round(study, told, groups)
        return
    dead, drive = _singular(study, groups), whole.drive
    low, high = (study.place(q) for q in (whole.low, whole.high))
    if all(free):
        yield Words(
            f"{driver.zh}的行程不受杆组限制；计算取 ${drive.symbol}$ 由 {low} 至 {high}。",
            f"Nothing limits the stroke of {driver.en}; ${drive.symbol}$ is taken from {low} to {high}.",
        )
        return
    if any(free):
        end, taken = (high, low) if free[0] else (low, high)
        yield Words(
            f"{driver.zh}的行程一端受限：${drive.symbol}$ = {end} 处，{dead.zh}，为死点；另一端不受限制，"
            f"计算取至 {taken}。",
            f"The stroke of {driver.en} is limited at one end: at ${drive.symbol}$ = {end} "
            f"{dead.en}, a dead point; the other end is free, and {taken} is only as far as is "
            "computed.",
        )
        return
    bound = (
        Words("的行程有限", "has a limited stroke")
        if study.mech.drive.slide
        else Words("不能整周运动", "cannot make full revolutions")
    )
    yield Words(
        f"{driver.zh}{bound.zh}，${drive.symbol}$ 只能在 {low} 至 {high} 之间"
        + (f"；在两极限位置，{dead.zh}，为以{driver.zh}驱动时的死点，速度无确定值。" if study.facts.dead else "。"),
        f"{driver.en[0].upper()}{driver.en[1:]} {bound.en}: ${drive.symbol}$ is limited to {low} … "
        f"{high}"
        + (f". At these limits {dead.en}: dead points, with no definite velocities." if study.facts.dead else "."),
    )


def _singular(study: Study, groups: list[Conditioning]) -> Words:
    """What stands so at a dead point that the drive goes no further: the group whose determinant vanishes."""
    worst = min(groups, key=lambda one: one.ratio, default=None)
    kind = next((g.kind for g in decompose(study.mech) if worst is not None and g.links == worst.group.links), "")
    if worst is not None and kind == "RRR":
        return Words(f"{worst.group.title.zh}的两杆共线", f"both bars of the {worst.group.title.en} are in one line")
    if worst is not None and kind == "RRP":
        return Words(
            f"{worst.group.title.zh}的连杆垂直于导路",
            f"the coupler of the {worst.group.title.en} is at right angles to the guide",
        )
    if worst is not None and kind in ("PRP", "RPP"):
        return Words(f"{worst.group.title.zh}的两导路平行", f"both guides of the {worst.group.title.en} are parallel")
    return Words(
        "从动杆组处于奇异位置（速度方程组的行列式为零）",
        "the driven group is singular (the determinant of its velocity equations is zero)",
    )


def _turns(study: Study) -> Iterator[Words]:
    """Which driven links turn round, and how often."""
    turns = {name: count for name, count in (study.facts.turns or {}).items() if name != study.mech.drive.link}
    counts = dict.fromkeys(count for count in turns.values() if count)
    alike = [([study.name(n) for n, c in turns.items() if c == count], count) for count in counts]
    rocking = [study.name(n) for n, c in turns.items() if not c]
    if alike:
        zh = "，".join(f"构件 {'、'.join(names)} {'同' if c > 0 else '反'}向转 {abs(c)} 周" for names, c in alike)
        en = "; ".join(
            f"{_links_en(names)} {'makes' if len(names) == 1 else 'make'} {abs(c)} "
            f"{'turn' if abs(c) == 1 else 'turns'} in {'the same' if c > 0 else 'the opposite'} sense"
            for names, c in alike
        )
        yield Words(
            f"原动件每转一周：{zh}" + (f"；构件 {'、'.join(rocking)} 不作整周转动。" if rocking else "。"),
            f"In one turn of the input link, {en}"
            + (f"; {_links_en(rocking)} {'does' if len(rocking) == 1 else 'do'} not turn round." if rocking else "."),
        )


def _links_en(names: list[str]) -> str:
    return f"link {names[0]}" if len(names) == 1 else f"links {', '.join(names[:-1])} and {names[-1]}"


def evenness(study: Study, link: str) -> Iterator[Words]:
    """Of a driven link on the frame that turns round: its coefficient of non-uniformity; of another nothing."""
    key, count = f"omega_{link}", (study.facts.turns or {}).get(link, 0)
    if link == study.mech.drive.link or not count or link not in on_frame(study) or not study.varies(key):
        return
    found, mean = study.extremes(key), abs(count * study.mech.drive.rate)
    if found.highest is None or found.lowest is None or not mean:
        return
    reverses = Words("中途反转", "it reverses on the way")
    if found.highest.value * found.lowest.value > 0:
        reverses = Words(
            "转向不变，没有极限位置，不存在急回",
            "it does not reverse, so there are no limit positions and there is no quick return",
        )
    low, high = (shown(study, key, v) for v in (found.lowest.value, found.highest.value))
    average, delta = shown(study, key, count * study.mech.drive.rate), (found.highest.value - found.lowest.value) / mean
    turns = "1 turn" if abs(count) == 1 else f"{abs(count)} turns"
    round_ = winding(study, link, count)
    kind = Words("输出构件", "output") if link in ends(study) else Words("中间构件", "intermediate")
    yield Words(
        f"{kind.zh} {link} 整周转动{round_.zh}，$ω_{link}$ 在 {low} 至 {high} 之间，"
        f"{reverses.zh}；其平均值为 {average}（每循环 {abs(count)} 周），"
        f"速度不均匀系数 $δ$ = $(ω_{{max}} − ω_{{min}}) / |ω_m|$ = {delta:.2f}。",
        f"The {kind.en} link {link} makes full revolutions{round_.en}, with $ω_{link}$ between {low} and "
        f"{high}: {reverses.en}. Its mean is {average} ({turns} a cycle), "
        f"the coefficient of non-uniformity $δ$ = $(ω_{{max}} − ω_{{min}}) / |ω_m|$ = {delta:.2f}.",
    )
