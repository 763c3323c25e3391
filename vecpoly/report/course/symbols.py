"""The list of symbols: of what a textbook writes, those that this report uses."""

from __future__ import annotations

from collections.abc import Iterator

from ...board.construction import View
from ...figures import views
from ...findings.study.study import Study
from ...mechanism.asked.forces import load_symbol
from ...names import subscripted
from ...words import Words
from ..flow.table import DataTable
from .numbering import TINY, Press
from .spoken_symbols import COUNTED, Row, used

_HEADER = {"zh": ["符号", "含义", "单位"], "en": ["Symbol", "Meaning", "Unit"]}


def symbols(study: Study, press: Press, told: str = "") -> str:
    """A table without number, two symbols to a line; told: the words of the report, whose symbols it lists too."""
    own = [*_model(study), *_forces(study), *_drawn(study)]
    taken = {symbol for symbol, _, _ in own}
    beside = [row for row in (*COUNTED, *used(told)) if row[0] not in taken]  # a force may be F, a moment M_e
    listed = [*beside[: len(COUNTED)], *own, *beside[len(COUNTED) :]]
    rows_told = [
        (symbol.replace("、", "、" if press.lang == "zh" else ", "), words.of(press.lang), unit)
        for symbol, words, unit in listed
    ]
    half = (len(rows_told) + 1) // 2
    rows = [(*one, *two) for one, two in zip(rows_told[:half], [*rows_told[half:], ("", "", "")][:half], strict=True)]
    caption = Words("主要符号", "Symbols").of(press.lang)
    return press.objects.add(
        "tab", DataTable(_HEADER[press.lang] * 2, rows, None, "llc" * 2, lang=press.lang, caption=caption, style=TINY)
    )


def _model(study: Study) -> Iterator[Row]:
    """Lengths, angles, coordinates, rates, slides, auxiliary quantities of chapter 4; transmission angles."""
    constants = list(dict.fromkeys(c.symbol for group in study.model.groups for c in group.constants))
    length = next((c for c in constants if c.startswith("l_")), "")
    if length:
        one, two = length[3], length[4:-1]
        yield (
            f"${length}$",
            Words(f"${one}$、${two}$ 两点的距离，余类推", f"distance from ${one}$ to ${two}$, and so on"),
            "mm",
        )
    yield (
        "$φ_i$、$ω_i$、$α_i$",
        Words("构件 $i$ 的转角、角速度、角加速度", "angle, angular velocity and acceleration of link $i$"),
        "°, rad/s, rad/s²",
    )
    letter = next(iter(study.points), "")
    if letter:
        yield from _point(letter)
    slides = (c.key[2:] for c in study.whole.columns if c.key.startswith("s_"))
    used = {*constants, *study.env}
    if pair := next((pair for pair in slides if f"s_{{{pair}}}" in used), ""):
        yield (
            f"$s_{{{pair}}}$、$v_{{{pair}}}$、$a_{{{pair}}}$",
            Words(
                f"构件 {pair[:1]} 沿构件 {pair[1:]} 的滑移及其变化率",
                f"sliding of link {pair[:1]} along link {pair[1:]}, with its velocity and acceleration",
            ),
            "mm, m/s, m/s²",
        )
    beta = next((c for c in constants if c.startswith("β_")), "")
    if beta:
        end = subscripted(beta[3:-1])
        yield f"${beta}$", Words(f"由构件的轴线量至 ${end}$ 的角", f"angle from the link's axis to ${end}$"), "°"
    yield from ((f"${c}$", words, unit) for c, words, unit in _others(constants))
    yield from _auxiliary(study)
    if gamma := next(iter(study.facts.transmissions), None):
        symbol = study.whole.info(gamma.key).symbol
        yield f"${symbol}$", Words("杆组的传动角（锐角）", "transmission angle (acute)"), "°"


def _point(letter: str) -> Iterator[Row]:
    yield (
        f"$x_{{{letter}}}$、$y_{{{letter}}}$",
        Words(f"${subscripted(letter)}$ 点的坐标，余类推", f"coordinates of ${subscripted(letter)}$, and so on"),
        "mm",
    )
    yield (
        f"$v_{{{letter}x}}$、$a_{{{letter}x}}$",
        Words(
            f"${subscripted(letter)}$ 点速度、加速度的 $x$ 分量",
            f"$x$ components of the velocity and acceleration of ${subscripted(letter)}$",
        ),
        "m/s, m/s²",
    )


def _auxiliary(study: Study) -> Iterator[Row]:
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
    """Offsets, fixed angles, the sign of the assembly."""
    for stem, words, unit in (
        ("e_", Words("导路的偏距", "offset of a guide"), "mm"),
        ("ψ_", Words("导路的方向角", "direction of a guide"), "°"),
        ("δ_", Words("移动副两构件的固定夹角", "fixed angle between links of a sliding pair"), "°"),
        ("r_", Words("齿轮、滚子的半径", "radius of a gear or roller"), "mm"),
        ("σ", Words("装配模式系数，$σ$ = ±1", "sign that tells the assembly, $σ$ = ±1"), "—"),
    ):
        found = next((c for c in constants if c.startswith(stem)), "")
        if found:
            yield found, words, unit


def _forces(study: Study) -> Iterator[Row]:
    """The balancing load, reactions, efficiency, radii of friction circles."""
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


def _drawn(study: Study) -> Iterator[Row]:
    """Scales and polygons."""
    figures = study.solution.construction.figures if study.drawn else ()
    known = {view.mu.symbol: view.mu.listed for view in views()}
    for scale in dict.fromkeys((figure.scale.symbol, figure.scale.per_mm) for figure in figures if figure.scale.symbol):
        if scale[0] in known:
            yield f"${scale[0]}$", known[scale[0]], scale[1]
    drawn = sorted({figure.view for figure in figures})
    yield from ((*view.letters, "mm") for view in drawn if view.letters is not None)
    if View.ACCELERATION in drawn:
        yield (
            "$a^n$、$a^t$、$a^k$",
            Words("法向、切向、哥氏加速度", "normal, tangential, Coriolis acceleration"),
            "m/s²",
        )
