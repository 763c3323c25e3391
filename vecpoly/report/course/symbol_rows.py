"""What the list of symbols tells of the formulas, the forces and the drawings of this report."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...analytic.expr import Var
from ...analytic.forces.balance import ForceModel, force_model
from ...board.construction import Figure, Step
from ...figures import views
from ...findings.study.study import Study
from ...foundation.indices import LETTER
from ...mechanism.asked.forces import load_symbol
from ...names import Named, subscripted
from ...words import Words
from .spoken_symbols import Row

_CURVED = (  # by the beginnings of the keys
    ("W", Words("拐点极", "inflection pole"), "—"),
    ("Wr", Words("回归极", "return pole"), "—"),
    ("U", Words("鲍尔点", "Ball’s point"), "—"),
    ("delta", Words("拐点圆直径", "diameter of the inflection circle"), "mm"),
    ("lambda", Words("共线轴与两铰链连线的夹角", "angle of the collineation axis to the line of the pins"), "°"),
    ("rho", Words("轨迹的曲率半径", "radius of curvature of a path"), "mm"),
    ("L", Words("定、动瞬心线的弦长之和", "chords of the fixed, of the moving centrode"), "mm"),
)


_PARTS = (  # of an acceleration, by their superscripts
    ("n", Words("法向", "normal")),
    ("t", Words("切向", "tangential")),
    ("k", Words("哥氏", "Coriolis")),
    ("r", Words("相对", "relative")),
)


def model(study: Study) -> Iterator[Row]:
    """Lengths, angles, coordinates, rates, slides of chapter 4; transmission angles."""
    constants = list(dict.fromkeys(c.symbol for group in study.model.groups for c in group.constants))
    length = next((c for c in constants if c.startswith("l_")), "")
    if length:
        one, two = re.findall(f"{LETTER}|.+", length[3:-1])
        yield (
            f"${length}$",
            Words(f"${one}$、${two}$ 两点的距离，余类推", f"distance from ${one}$ to ${two}$, and so on"),
            "mm",
        )
    yield "$φ_i$", Words("构件 $i$ 的转角", "angle of link $i$"), "°"
    yield "$ω_i$", Words("构件 $i$ 的角速度", "angular velocity of link $i$"), "rad/s"
    yield "$α_i$", Words("构件 $i$ 的角加速度", "angular acceleration of link $i$"), "rad/s²"
    letter = next(iter(study.points), "")
    if letter:
        yield from _point(letter)
    slides = [c.key[2:] for c in study.whole.columns if c.key.startswith("s_")]
    used = {*constants, *study.env}
    if pair := next((pair for pair in slides if f"s_{{{pair}}}" in used), ""):
        yield from _slide(pair, alone=len(slides) == 1)
    beta = next((c for c in constants if c.startswith("β_")), "")
    if beta:
        end = subscripted(beta[3:-1])
        yield f"${beta}$", Words(f"由构件的轴线量至 ${end}$ 的角", f"angle from the link's axis to ${end}$"), "°"
    yield from ((f"${c}$", words, unit) for c, words, unit in _others(constants))
    if gamma := next(iter(study.facts.transmissions), None):
        symbol = study.whole.info(gamma.key).symbol
        yield f"${symbol}$", Words("杆组的传动角（锐角）", "transmission angle (acute)"), "°"


def _point(letter: str) -> Iterator[Row]:
    yield (
        f"$x_{{{letter}}}$、$y_{{{letter}}}$",
        Words(f"${subscripted(letter)}$ 点的坐标，余类推", f"coordinates of ${subscripted(letter)}$, and so on"),
        "mm",
    )
    at = subscripted(letter)
    for stem, zh, en, unit in (("v", "速度", "velocity", "m/s"), ("a", "加速度", "acceleration", "m/s²")):
        yield (
            f"${stem}_{{{letter}x}}$",
            Words(f"${at}$ 点{zh}的 $x$ 分量", f"$x$ component of the {en} of ${at}$"),
            unit,
        )


def _slide(pair: str, *, alone: bool) -> Iterator[Row]:
    one, along = pair[:1], pair[1:]
    rest = Words("", "") if alone else Words("，余类推", ", and so on")
    yield (
        f"$s_{{{pair}}}$",
        Words(f"构件 {one} 沿构件 {along} 的滑移", f"sliding of link {one} along link {along}") + rest,
        "mm",
    )
    for stem, zh, en, unit in (("v", "速度", "velocity", "m/s"), ("a", "加速度", "acceleration", "m/s²")):
        yield f"${stem}_{{{pair}}}$", Words(f"滑移的{zh}", f"{en} of the sliding"), unit


def auxiliary(study: Study) -> Iterator[Row]:
    """Auxiliary quantities of the closed formulas of a dyad."""
    if {"A_0", "B_0"} & {*study.env}:
        yield (
            "$A_0$、$B_0$、$C_0$" if "C_0" in study.env else "$A_0$、$B_0$",
            Words("位置方程消元的辅助量", "auxiliary, position equations"),
            "—",
        )
    if "G_1" in study.env:
        yield "$G_1$", Words("速度、加速度方程组的行列式", "determinant, rate equations"), "—"
    if "G_2" in study.env:
        yield "$G_2$、$G_3$", Words("加速度方程组的右端", "right sides, acceleration equations"), "m/s²"


def _others(constants: list[str]) -> Iterator[Row]:
    """Offsets, fixed angles, pitch radii, the sign of the assembly."""
    for stem, words, unit in (
        ("e_", Words("导路的偏距", "offset of a guide"), "mm"),
        ("ψ_", Words("导路的方向角", "direction of a guide"), "°"),
        ("δ_", Words("移动副两构件的固定夹角", "fixed angle between links of a sliding pair"), "°"),
        ("r_", Words("齿轮的节圆半径", "pitch radius of a gear"), "mm"),
        ("σ", Words("装配模式系数，$σ$ = ±1", "sign that tells the assembly, $σ$ = ±1"), "—"),
    ):
        found = next((c for c in constants if c.startswith(stem)), "")
        if found:
            yield found, words, unit


def forces(study: Study) -> Iterator[Row]:
    """The balancing load, reactions, efficiency, friction."""
    loads = study.problem.loads
    if loads is None:
        return
    unknown = loads.unknown.name
    yield (
        f"${load_symbol(unknown)}$",
        Words("平衡载荷", "the balancing load"),
        study.whole.info(unknown).shown_unit if unknown in study.forces else "—",
    )
    reaction = next((key for key in study.forces if key.startswith("R_")), "")
    if reaction:
        yield (
            f"${study.whole.info(reaction).symbol}$",
            Words(
                f"构件 {reaction[2:-1]} 对构件 {reaction[-1]} 的反力",
                f"force of link {reaction[2:-1]} on link {reaction[-1]}",
            ),
            "N",
        )
    if "eta" in study.forces:
        yield "$η$", Words("机械效率", "efficiency"), "—"
    if loads.friction and loads.friction.pins:
        yield "$ρ$", Words("摩擦圆半径", "radius of a friction circle"), "mm"
    if found := force_model(study.mech, loads, study.model, study.turned):
        yield from _rubbing(study, found)


def _rubbing(study: Study, found: ForceModel) -> Iterator[Row]:
    """Moments and forces of friction, normal forces and couples of guides, as the equations have them."""
    alone = next((one for one in found.touches if one.rub and one not in found.shared_pins), None)
    if alone is not None:
        at = f"${alone.letter}$"
        yield f"${alone.rub}$", Words(f"铰链 {at} 的摩擦力矩，余类推", f"moment of friction at {at}, and so on"), "N·m"
    for one in found.shared_pins:
        a, b, at = study.mech.number(one.a), study.mech.number(one.b), f"${one.letter}$"
        told = Words(f"{at} 处构件 {a} 对 {b} 的摩擦力矩", f"moment of friction of link {a} on {b} at {at}")
        yield f"${one.rub}$", told, "N·m"
    if normal := next((one for touch in found.touches for one in touch.unknowns if one.startswith("N_")), ""):
        yield f"${normal}$", Words("移动副、高副的法向反力", "normal force of a guide or higher pair"), "N"
    if couple := next((one for touch in found.touches for one in touch.unknowns if one.startswith("T_")), ""):
        yield f"${couple}$", Words("移动副反力的力偶矩", "couple of a guide"), "N·m"
    rubs = (e.left.symbol for e in found.friction if isinstance(e.left, Var))
    if rub := next((one for one in rubs if one.startswith("F_{f")), ""):
        yield f"${rub}$", Words("滑动处的摩擦力", "force of friction"), "N"


def centres(study: Study) -> Iterator[Row]:
    """Instant centres, where any is drawn or asked for."""
    if any(key.startswith("P_") for key in study.solution.answers):
        told = Words("构件 $i$、$j$ 的（速度）瞬心", "instant centre of links $i$ and $j$")
        yield "$P_{ij}$", told, "—"
    extended = next((key for key in study.solution.answers if key.endswith("_extended")), "")
    if extended:
        at = f"φ_{{{extended[4:-9]}}}"
        told = Words("曲柄与连杆拉直、重叠共线时的曲柄位置角", "crank angles, crank and coupler extended, overlapped")
        yield f"${at}^{{′}}$、${at}^{{′′}}$", told, "°"


def curvatures(study: Study) -> Iterator[Row]:
    """What was found of the kinematic geometry of a link, and the poles of its centrodes."""
    found: dict[str, list[str]] = {}
    for key, answer in study.solution.answers.items():
        if isinstance(answer.rel, Named) and answer.rel.is_curved:
            found.setdefault(key.partition("_")[0], []).append(f"${answer.rel.symbol}$")
    for stem, words, unit in _CURVED:
        if stem in found:
            yield "、".join(found[stem]), words, unit
    if "L" in found:
        yield "$Q_i$、$Q′_i$", Words("定、动瞬心线上的瞬心", "poles of the fixed and of the moving centrode"), "—"


def scales(study: Study) -> Iterator[Row]:
    """Scales."""
    known = {view.mu.symbol: view.mu.listed for view in views()}
    found = dict.fromkeys((one.scale.symbol, one.scale.told.per_mm) for one in _figures(study) if one.scale.symbol)
    yield from ((f"${symbol}$", known[symbol], unit) for symbol, unit in found if symbol in known)


def letters(study: Study) -> Iterator[Row]:
    """Letters of the polygons."""
    views_drawn = sorted({figure.view for figure in _figures(study)})
    yield from ((*view.letters, "—") for view in views_drawn if view.letters is not None)


def components(study: Study) -> Iterator[Row]:
    """Of accelerations, those that stand in the vector equations of the drawing."""
    if not study.drawn:
        return
    terms = " ".join(symbol for step in study.solution.construction.steps for symbol in _terms(step))
    found = [
        (f"$a^{letter}$", words) for letter, words in _PARTS if f"a^{letter}" in terms or f"a^{{{letter}}}" in terms
    ]
    if found:
        names = Words("、".join(w.zh for _, w in found), ", ".join(w.en for _, w in found))
        yield "、".join(symbol for symbol, _ in found), names + Words("加速度", " acceleration"), "m/s²"


def _terms(step: Step) -> tuple[str, ...]:
    return step.equation.symbols if step.equation else ()


def _figures(study: Study) -> Sequence[Figure]:
    return study.solution.construction.figures if study.drawn else ()
