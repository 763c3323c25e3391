"""Chapter 4, the forces: the equilibrium of every link, what friction adds, and how the equations are solved."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, sin, tan

from ....algebra.quantity import number
from ....analytic.equations import GroupModel, Part, Stage
from ....analytic.forces.balance import ForceModel, LinkBalance, force_model
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_symbol
from ....mechanism.loads import GRAVITY, Loads
from ....mechanism.model import Mechanism
from ....words import Words
from ...statement.structure import carried_pins


def forces_group(study: Study) -> GroupModel | None:
    """The model of the forces as a section of the chapter; None without loads, and where gears roll."""
    loads = study.problem.loads
    found = force_model(study.mech, loads, study.model, study.turned) if loads else None
    if loads is None or found is None:
        return None
    return GroupModel(
        title=Words("力分析", "Forces"),
        opening=_opening(study, loads, found),
        links=(),
        stages=tuple(_stages(study, loads, found)),
    )


def _directed(angles: list[str]) -> str:
    """That these are the angles at which forces act."""
    if len(angles) == 1:
        return f"The angle {angles[0]} gives the direction of the force. "
    return f"The angles {', '.join(angles[:-1])} and {angles[-1]} give the directions of the forces. "


def _opening(study: Study, loads: Loads, found: ForceModel) -> Words:
    slides = any(touch.unknowns[-1].startswith("T") for touch in found.touches)
    high = any(touch.before for touch in found.touches)
    told = (
        _CUT_FREE
        + (_of_slides(rubs=bool(found.friction)) if slides else Words("", ""))
        + (_of_higher_pairs(rubs=bool(found.friction)) if high else Words("", ""))
    )
    fixed = [load for load in loads.forces if load.along is None]
    if tilted := [load for load in fixed if abs(sin(2 * load.direction)) > 1e-9]:
        angles = [f"$θ_{{{load.name.replace('_', '')}}}$" for load in tilted]
        told += Words(f"{'、'.join(angles)} 为力的方向角。", _directed(angles))
    if lawful := [f"${load_symbol(load.name)}$" for load in loads.all if load.law is not None]:
        told += Words(
            f"{'、'.join(lawful)} 随位置（速度）变化，按题给规律取值。",
            f"{', '.join(lawful)} follow{'s' if len(lawful) == 1 else ''} the given law at every position. ",
        )
    pins, free = carried_pins(study.mech), f"${load_symbol(loads.unknown.name)}$"
    told += Words(pins.zh, f"{pins.en.strip()} " if pins.en else "")
    if given := _given(loads, found):
        told += Words(f"已知 {'，'.join(given)}；", f"Given are {', '.join(given).replace('，', ', ')}; ")
    return told + Words(f"{free} 为待求的平衡载荷。", f"{free} is the balancing load that is sought. ")


_CUT_FREE = Words(
    "取各构件为分离体列平衡方程。$R_{ij}$ 为构件 $i$ 对构件 $j$ 的反力，$R_{ji}$ = −$R_{ij}$，下标 $x$、"
    "$y$ 表示投影；力矩以逆时针为正。",
    "Each link is isolated. $R_{ij}$ is the force of link $i$ on link $j$, $R_{ji}$ = −$R_{ij}$, with "
    "components $x$ and $y$; moments are positive counter-clockwise. ",
)


def _of_slides(*, rubs: bool) -> Words:
    """What a sliding pair transmits, and how it counts; of friction where there is any."""
    own = Words(
        "移动副的反力简化为垂直于导路的 $N$（导路正向左侧为正）和对滑块铰链中心的力偶矩 $T$",
        "The reaction of a prismatic joint is a force $N$ normal to the guide (positive to the left of its "
        "direction) and a couple $T$ about the block's pin",
    )
    friction = Words(
        "，沿导路的速度 $v$ 和摩擦力 $F_f$ 以导路正向为正",
        "; $v$ and friction $F_f$ along the guide are positive in its direction",
    )
    return own + (friction if rubs else Words("", "")) + Words("。", ". ")


def _of_higher_pairs(*, rubs: bool) -> Words:
    """What a higher pair transmits; of friction where there is any."""
    own = Words(
        "高副的反力为沿公法线的 $N$，指向圆盘中心为正",
        "The reaction of a higher pair is $N$ along the common normal, positive towards the disc's centre",
    )
    friction = Words(
        "，摩擦力 $F_f$ 和滑动速度 $v$ 以公法线逆时针转 90° 的方向为正",
        "; friction $F_f$ and sliding $v$ are positive along the normal turned by +90°",
    )
    return own + (friction if rubs else Words("", "")) + Words("。", ". ")


def _given(loads: Loads, found: ForceModel) -> list[str]:
    """The given loads, masses and weights."""
    given = [f"${one.symbol}$ = {number(one.size, 6)} {one.unit}" for one in found.loads]
    given += [
        f"$m_{{{mass.link}}}$ = {number(mass.mass, 4)} kg"
        + (f"，${mass.inertia_symbol}$ = {number(mass.inertia, 4)} kg·m²" if mass.inertia else "")
        for mass in loads.masses
    ]
    weights = [f"$G_{{{mass.link}}}$ = {number(GRAVITY * mass.mass, 4)} N" for mass in loads.masses if loads.weight]
    return given + weights


def _stages(study: Study, loads: Loads, found: ForceModel) -> Iterator[Stage]:
    if found.inertia:
        said = Words(
            "由运动分析的质心加速度和角加速度，按达朗贝尔原理加惯性力和惯性力偶矩",
            "By d'Alembert's principle, from the accelerations of the centres of mass and the angular accelerations,",
        )
        yield Stage(Words("惯性力", "Inertia forces"), (Part(said, found.inertia),))
    if found.springs:
        said = Words(
            "弹簧（阻尼器）的长度 $l$、伸长的速度 $v$ 和拉力（扭簧为力矩）",
            "Lengths $l$ of springs and dampers, how fast they grow, $v$, and the pull (of a coil the moment)",
        )
        yield Stage(Words("弹簧", "Springs"), (Part(said, found.springs),))
    if found.normals:
        yield Stage(
            Words("接触点和公法线", "Point of contact and common normal"),
            (
                Part(
                    Words(
                        "接触点的坐标和指向圆盘中心的单位法向量为",
                        "The unit normal towards the disc's centre and the point of contact are",
                    ),
                    found.normals,
                ),
            ),
        )
    yield Stage(Words("平衡方程", "Equilibrium"), tuple(_balance(one, i == 0) for i, one in enumerate(found.links)))
    if found.friction:
        yield Stage(Words("摩擦", "Friction"), (Part(_friction_words(study, loads, found), found.friction),))
    yield Stage(
        Words("求解", "Solution"),
        (Part(_solution(loads, found)), Part(_efficiency(loads)))
        if found.friction
        else (Part(_solution(loads, found)),),
    )


def _balance(one: LinkBalance, first: bool) -> Part:
    about = f"对 ${one.about}$ 点取矩" if first else f"对 ${one.about}$ 点"
    return Part(
        Words(
            f"构件 {one.link}（$ΣF_x$ = 0，$ΣF_y$ = 0，{about}）：",
            f"Link {one.link} ($ΣF_x$ = 0, $ΣF_y$ = 0, moments about ${one.about}$):",
        ),
        one.equations,
    )


def _shared_pin(mech: Mechanism, found: ForceModel) -> Iterator[Words]:
    """That at a multiple joint there are several such moments, told apart by their links, where there are."""
    for touch in found.shared_pins[:1]:
        symbol, at, one, two = touch.rub, touch.letter, mech.number(touch.a), mech.number(touch.b)
        yield Words(
            f"复合铰链处有几个摩擦力矩，以两构件的号区别，如 ${symbol}$ 为 ${at}$ 处构件 {one} 对构件 {two} 的摩擦力矩",
            f"at a multiple joint there are several such moments, told apart by the numbers of the two links: "
            f"${symbol}$ is that of link {one} on link {two} at ${at}$",
        )


def _friction_words(study: Study, loads: Loads, found: ForceModel) -> Words:
    """What the friction circle and the angle of friction mean in the equations."""
    rules, friction = [], loads.friction
    if any(friction.pins.values()):
        rules.append(
            Words(
                "转动副的总反力切于半径为 $ρ$ 的摩擦圆，对铰链中心之矩 $M_f$ = $ρ R$，与相对角速度反向",
                "the reaction of a pin joint is tangent to the friction circle of radius $ρ$: its moment "
                "about the centre is $M_f$ = $ρ R$, against the relative rotation",
            )
        )
    rules += _shared_pin(study.mech, found)
    angles = {study.mech.number(a) + study.mech.number(b): angle for (a, b), angle in friction.slides.items()} | dict(
        friction.contacts
    )
    if told := {sub: angle for sub, angle in angles.items() if angle}:
        values = "，".join(
            f"$f_{{{sub}}}$ = tan {number(degrees(angle), 4)}° = {number(tan(angle), 4)}" for sub, angle in told.items()
        )
        rules.append(
            Words(
                f"滑动处的总反力自法线偏转摩擦角 $φ$，即摩擦力 $F_f$ = $f N$（{values}），与相对滑动速度反向",
                "where there is sliding the reaction is inclined to the normal at the angle of "
                "friction, that is $F_f$ = $f N$ (" + values.replace("，", ", ") + ") against the sliding",
            )
        )
    en = "; ".join(w.en for w in rules)
    return Words(
        "；".join(w.zh for w in rules) + "。指向由运动分析的相对速度确定：",
        f"{en[0].upper()}{en[1:]}. The relative velocities of the motion tell the senses:",
    )


def _solution(loads: Loads, found: ForceModel) -> Words:
    """How the oracle solves it."""
    count = sum(len(one.equations) for one in found.links)
    names, links = [f"${symbol}$" for symbol in found.unknowns], len(found.links)
    zh, en = f"{links} 个构件共 {count} 个平衡方程，", f"The {count} equations of the {links} links hold "
    if found.friction:
        zh, en = f"{zh}不计摩擦（$M_f$ = $F_f$ = 0）时", f"{en}without friction ($M_f$ = $F_f$ = 0) "
    zh += f"恰含 {len(names)} 个未知量 {'、'.join(names)}，为线性方程组，各位置直接消元求解。"
    en += f"the {len(names)} unknowns {', '.join(names)}: a linear system, solved by elimination at every position. "
    if not found.friction:
        return Words(zh, en)
    return Words(
        zh + "计摩擦时，各反力是有摩擦各副压力大小 $u_k$ 的线性函数，$u_k = |p_k + Σ g_{kj} u_j|$（$p_k$ 为不计摩擦"
        "的压力，$g_{kj}$ 为第 $j$ 副单位摩擦引起的压力），用牛顿法迭代，以不计摩擦的解为初值；"
        "不能断定解唯一或不收敛时，令摩擦由 0 逐渐增至全值，沿解曲线跟踪。若未到全值解已消失，"
        "或平衡载荷须反向，则机构在该位置自锁。",
        en + "With friction every reaction is linear in the pressing forces $u_k$ of the rubbing "
        "pairs, $u_k = |p_k + Σ g_{kj} u_j|$ ($p_k$: without friction; $g_{kj}$: by unit friction "
        "in pair $j$): Newton's method from the frictionless solution; where the solution is not "
        "surely the only one, or is not reached, friction is increased from 0 step by step and "
        "the solution followed. If it is lost on the way, or the balancing load would have to "
        "turn round, the mechanism is self-locking there. ",
    )


def _efficiency(loads: Loads) -> Words:
    """The quotient by which η is computed, for two loads and for more."""
    symbol = load_symbol(loads.unknown.name)
    stem, _, sub = symbol.partition("_")
    zero = f"{stem}_{{{sub.strip('{}')}0}}"
    if len(loads.all) == 2 and not loads.dynamic and not (loads.weight and loads.masses):
        return Words(
            f"机械效率：${symbol}$ 为阻力时 $η = {symbol}/{zero}$，为驱动力时 $η = {zero}/{symbol}$，"
            f"${zero}$ 为不计摩擦的平衡载荷；两式都等于输出功率与输入功率之比。",
            f"Efficiency: $η = {symbol}/{zero}$ where ${symbol}$ resists, $η = {zero}/{symbol}$ "
            f"where it drives, ${zero}$ being the load without friction: both are the power put "
            "out over the power put in. ",
        )
    return Words(
        "机械效率为各载荷中作负功者与作正功者的功率之比，$η = P_{out}/P_{in}$。",
        "The efficiency is the sum of the powers that resist over the sum of those that drive, $η = P_{out}/P_{in}$. ",
    )
