"""The structure of a mechanism: its diagram, not to scale, degree of freedom,
replacement of higher pairs, Assur groups, class."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Expr, Quantity, Times, magnitude
from ....board.construction import Pane, View
from ....board.otherwise.slip import Chance, Mistake
from ....devices.structure import Structure
from ....devices.structure_named import DETERMINED, F_LOCAL, P_H, P_L, P_REDUNDANT, F, N
from ....devices.structure_pairs import Form, Pair
from ....names import subscripted
from ....words import Words, begun
from ..bench import Bench
from ..registry import device_method
from .apart import draw_groups, no_groups
from .count import Count, count
from .low_pairs import draw_replacement
from .remedy import remedies
from .repeated import brings
from .replacement import replaced
from .sketch import draw_chain, pane, ring_compound

_NAMES = {
    Form.R: Words("转动副", "revolute joints"),
    Form.P: Words("移动副", "prismatic joints"),
    Form.H: Words("高副", "higher pairs"),
    Form.G: Words("齿轮高副", "gear pairs"),
}


@device_method(
    Structure,
    title=Words("机构的结构分析", "Structure of a mechanism"),
    source="机械原理, structure of mechanisms: F = 3n − 2p_L − p_H − F′ + p′, Assur groups",
    example="2-6",
)
def draw_structure(bench: Bench, device: Structure) -> None:
    """F = 3n − 2p_L − p_H − F′ + p′; the higher pairs replaced, and the Assur groups detached for every driver."""
    drivers = tuple(dict.fromkeys(link for together in device.drive_sets for link in together))
    found = count(device.chain, drivers)
    place = _diagram(bench, device)
    _freedom(bench, device, found, place)
    if device.drivers:
        _motion(bench, device, found)
    low = replaced(found.reduced, device)
    if device.touching:
        draw_replacement(bench, device, low)
    for together in device.drive_sets:
        if found.freedom == len(together):
            draw_groups(bench, device, low, together)
        else:
            no_groups(bench, together)
    if found.freedom < 1:
        remedies(bench, device, found)


def _diagram(bench: Bench, device: Structure) -> Pane:
    """All links and pairs, as given; compound hinges are found later."""
    board = bench.board
    board.section(Words("机构示意图", "Diagram of the mechanism"))
    place = pane(board, View.MECHANISM, "diagram", Words("机构示意图", "Diagram of the mechanism"))
    kinds = [(form, [pair for pair in device.chain.pairs if pair.form is form]) for form in Form]
    zh = "，".join(f"{_NAMES[form].zh} {'、'.join(_letters(pairs))}" for form, pairs in kinds if pairs)
    names = {form: _NAMES[form].en.removesuffix("s" if len(pairs) == 1 else "") for form, pairs in kinds}
    en = "; ".join(f"{names[form]} {', '.join(_letters(pairs))}" for form, pairs in kinds if pairs)
    links = [device.number(link) for link in device.chain.links]
    board.step(
        Words(
            f"用规定的符号画出机构示意图（不按比例），标出构件号和运动副字母：活动构件 {'、'.join(links)}；{zh}。",
            "Draw the mechanism, not to scale, with the standard symbols, number the links and letter "
            f"the joints: moving links {', '.join(links)}; {en}.",
        ),
        place,
    )
    draw_chain(board, place, device, device.chain, device.drive_sets[0] if device.drivers else (), ringed=False)
    return place


def _letters(pairs: list[Pair]) -> list[str]:
    return [f"${subscripted(pair.letter)}$" for pair in pairs]


def _freedom(bench: Bench, device: Structure, found: Count, place: Pane) -> None:
    """n, p_L, p_H; F′ and p′ with their reasons; F, and the same F from the reduced chain."""
    board, chain = bench.board, found.given
    board.section(Words("自由度", "Degree of freedom"))
    _compound(bench, device, found, place)
    board.step(
        Words(
            f"活动构件数、低副数（转动副与移动副{'，复合铰链按上述计' if found.compound else ''}）和高副数为：",
            "The numbers of moving links, of lower pairs (revolute and prismatic joints"
            f"{', multiple joints counted as above' if found.compound else ''}) and of higher pairs are:",
        )
    )
    n, low, high = (
        bench.counted(N, float(len(chain.links)), {Chance(Mistake.WITH_FRAME): len(chain.links) + 1.0}),
        bench.counted(P_L, float(chain.lower), _as_one(found)),
        bench.stated(P_H, float(chain.higher)),
    )
    local, redundant = _local(bench, device, found), _redundant(bench, found)
    board.step(Words("机构的自由度为：", "The degree of freedom is:"))
    freedom: Expr = Times(3, n) - Times(2, low) - high  # and of what there is none the formula says nothing
    freedom = freedom - local if np.any(local.value) else freedom
    bench.worked(F, freedom + redundant if np.any(redundant.value) else freedom)
    if found.rollers or found.repeated:
        _check(bench, found)


def _as_one(found: Count) -> dict[Chance, float]:
    """What p_L is where a compound hinge counts as a single revolute."""
    lower = float(found.given.lower)
    return {Chance(Mistake.AS_ONE, pair.letter): lower - pair.count + 1 for pair in found.compound}


def _compound(bench: Bench, device: Structure, found: Count, place: Pane) -> None:
    """The hinges of more than two links, each marked by a second circle."""
    for pair in found.compound:
        told = [device.number(link) for link in pair.links]
        bench.board.step(
            Words(
                f"${subscripted(pair.letter)}$ 处有 {len(told)} 个构件（{'、'.join(told)}）在同一轴线上铰接，"
                f"是复合铰链，按 {len(told)} − 1 = {pair.count} 个转动副计。",
                f"At ${subscripted(pair.letter)}$ {len(told)} links ({', '.join(told)}) are pinned "
                f"on one axis: a multiple joint, which counts as {len(told)} − 1 = {pair.count} "
                "revolute joints.",
            ),
            place,
        )
        ring_compound(bench.board, place, pair)


def _check(bench: Bench, found: Count) -> None:
    """The same F from the chain without rollers and redundant parts."""
    rest = found.reduced
    zh = "并".join(["把滚子与从动件固接"] * bool(found.rollers) + ["去掉虚约束部分"] * bool(found.repeated))
    en = " and ".join(
        ["the rollers welded"] * bool(found.rollers) + ["the redundant part taken away"] * bool(found.repeated)
    )
    bench.board.step(
        Words(
            f"校核：{zh}后，剩下 {len(rest.links)} 个活动构件、{rest.lower} 个低副、{rest.higher} 个高副，"
            "不再有局部自由度和虚约束，自由度为：",
            f"Check: with {en} there remain {len(rest.links)} moving links, {rest.lower} lower "
            f"and {rest.higher} higher pairs, without passive degrees of freedom and redundant "
            "constraints:",
        )
    )
    bench.board.formula("F", _gruebler(float(len(rest.links)), float(rest.lower), float(rest.higher)), "")


def _gruebler(n: float, low: float, high: float) -> Expr:
    return Times(3, magnitude("n", n, "")) - Times(2, magnitude("p_L", low, "")) - magnitude("p_H", high, "")


def _local(bench: Bench, device: Structure, found: Count) -> Quantity:
    """F′: the rollers."""
    if found.rollers:
        for roller in found.rollers:
            carrier = device.number(roller.carrier)
            bench.board.step(
                Words(
                    f"构件 {roller.link} 是滚子：它只以转动副 ${subscripted(roller.pin.letter)}$ 与构件 {carrier} "
                    f"相连，只以高副 ${subscripted(roller.contact.letter)}$ 与别的构件接触，公法线通过其转动中心，"
                    f"它绕 ${subscripted(roller.pin.letter)}$ 的转动不影响其他构件的运动，是局部自由度。",
                    f"Link {roller.link} is a roller: it is pinned only at "
                    f"${subscripted(roller.pin.letter)}$, to link {carrier}, and touches "
                    f"only at ${subscripted(roller.contact.letter)}$; the common normal "
                    "passes through its pin. Its turning about "
                    f"${subscripted(roller.pin.letter)}$ moves nothing else: a passive "
                    "degree of freedom.",
                )
            )
    else:
        bench.board.step(
            Words(
                "没有绕自身轴线空转的滚子，无局部自由度：",
                "No roller turns freely about its own axis, so there is no passive (local) degree of freedom:",
            )
        )
    return bench.stated(F_LOCAL, float(len(found.rollers)))


def _redundant(bench: Bench, found: Count) -> Quantity:
    """p′: the parts that repeat constraints."""
    board = bench.board
    if not found.repeated:
        board.step(
            Words(
                "没有对运动重复起作用的部分，无虚约束：",
                "No part repeats the constraint of another, so there are no redundant constraints:",
            )
        )
        return bench.stated(P_REDUNDANT, 0.0)
    for part in found.repeated:
        board.step(begun(part.why) + brings(part))
        high = magnitude("p′_H", float(abs(part.higher)), "")
        terms = (
            Times(2, magnitude("p′_L", float(part.lower), "")) + high
            if part.higher >= 0
            else Times(2, magnitude("p′_L", float(part.lower), "")) - high
        )
        if part.links:
            terms = terms - Times(3, magnitude("n′", float(len(part.links)), ""))
        if len(found.repeated) == 1:
            return bench.worked(P_REDUNDANT, terms)
        board.formula("p′", terms, "")
    board.step(Words("虚约束总数：", "The number of redundant constraints in all:"))
    return bench.stated(P_REDUNDANT, float(found.redundant))


def _motion(bench: Bench, device: Structure, found: Count) -> None:
    """Determined, locked, or free to move in more ways than it is driven."""
    board, drive = bench.board, device.drive_sets[0]
    board.section(Words("运动是否确定", "Is the motion determined?"))
    told, f = f"{'、'.join(drive)}", found.freedom
    board.step(
        Words(
            f"机构具有确定运动的条件：$F$ > 0，且原动件数等于 $F$。此处原动件为构件 {told}，共 {len(drive)} 个；",
            "The motion is determined if $F$ > 0 and the number of inputs equals $F$. Here the "
            f"input link{'s are' if len(drive) > 1 else ' is'} {' and '.join(drive)}; ",
        )
    )
    if f < 1:
        f_text = f"{f}".replace("-", "−")
        verdict = Words(
            f"$F$ = {f_text}，各构件之间没有相对运动，是{'桁架' if f == 0 else '超静定桁架'}，机构不能运动，"
            "不能实现设计意图",
            f"$F$ = {f_text}: no link can move against another; this is a truss, and it cannot do its work",
        )
    elif f == len(drive):
        verdict = Words(
            f"原动件数等于自由度 $F$ = {f}，机构的运动确定",
            f"the number of inputs equals the mobility, $F$ = {f}: the motion is determined",
        )
    elif f > len(drive):
        verdict = Words(
            f"原动件数少于自由度 $F$ = {f}，运动不确定，应再增加 {f - len(drive)} 个原动件，或增加约束",
            f"there are fewer inputs than the mobility $F$ = {f}: the motion is not determined; drive "
            f"{f - len(drive)} more, or add constraints",
        )
    else:
        verdict = Words(
            f"原动件数多于自由度 $F$ = {f}，各原动件的运动互相矛盾，只能有 {f} 个原动件",
            f"there are more inputs than the mobility $F$ = {f}: they contradict each other; only {f} may drive",
        )
    bench.judged(DETERMINED, float(f > 0 and f == len(drive)), verdict)
    board.remark(Words("。", "."))
