"""Where a method stands in a textbook, in one language each: a source has English words behind the name of the book."""

from __future__ import annotations

from ..words import Lang

_BOOKS = {"机械原理": "theory of machines", "机械振动": "mechanical vibrations"}
_ENGLISH = {
    "三心定理 (Kennedy, Aronhold)": "Kennedy's theorem (Kennedy, Aronhold)",
    "拐点圆与回归圆": "inflection circle and cuspidal circle",
    "机械的运转": "motion of machines",
    "极限位置": "limit positions",
    "瞬心法": "instant centres",
    "瞬心法求传动比": "velocity ratios by instant centres",
    "瞬心法求速度": "velocities by instant centres",
    "连杆曲线的曲率": "curvature of coupler curves",
    " (质量代换)": "",
}
_CHINESE = {
    "(Kennedy, Aronhold)": "（肯尼迪，阿龙霍尔德）",
    "Aronhold 1872": "阿龙霍尔德 1872",
    "Bobillier 1870": "博比利尔 1870",
    "Chebyshev, Hoecken, Roberts": "切比雪夫、霍肯、罗伯茨",
    "Euler 1765, Savary 1831": "欧拉 1765，萨瓦里 1831",
    "Hartmann 1893": "哈特曼 1893",
    "Grashof's condition": "曲柄存在条件（格拉斯霍夫）",
    "Zhukovsky's lever": "茹可夫斯基杠杆法",
    "balance of a slider-crank: two-mass rod, counterweight on the crank, hodograph of the force": (
        "曲柄滑块机构的平衡：连杆质量代换、曲柄配重、惯性力矢端图"
    ),
    "balance of multi-cylinder engines: polygons of first and second order": "多缸机的平衡：一阶、二阶惯性力多边形",
    "balance of rotors: mass–radius polygons, two planes, Dalby's couple polygon, ISO 21940-11": (
        "转子的平衡：质径积多边形、双面平衡、达尔比力偶多边形、ISO 21940-11"
    ),
    "cams: displacement diagrams, inversion, envelope, pressure angle, Hartmann's construction": (
        "凸轮：位移线图、反转法、包络线、压力角、哈特曼作图"
    ),
    "class III groups": "Ⅲ级杆组",
    "class III groups by special points (Assur points)": "Ⅲ级杆组的特殊点法（阿苏尔点）",
    "class III groups by special points (Assur points): forces": "Ⅲ级杆组的特殊点法（阿苏尔点）：力分析",
    "class III groups by trial": "Ⅲ级杆组的试凑法",
    "coincident points of two links": "两构件重合点间的运动关系",
    "coincident points of two links, Coriolis acceleration": "两构件重合点间的运动关系，哥氏加速度",
    "coincident points of two links; the relative velocity along the cylinder is given": (
        "两构件重合点间的运动关系；沿油缸的相对速度已知"
    ),
    "crank-shaper: the swing of the lever is the angle between the limit positions": "导杆机构：导杆摆角等于极位夹角",
    "eccentric clamp: friction circle and friction angle": "偏心夹具：摩擦圆与摩擦角",
    "efficiency of trains of machines": "机组的效率",
    "epicyclic trains: velocities of pitch points over the radius, Willis' equation as a check": (
        "周转轮系：节点速度沿半径的分布，用转化轮系公式校核"
    ),
    "equilibrium of a link under a couple": "受力偶构件的平衡",
    "equilibrium of the crank": "曲柄的平衡",
    "equilibrium of the driving link; the balancing load by virtual power": "原动件的平衡；平衡力（矩）用虚功率求",
    "equivalent link: its kinetic energy and its power are those of the whole machine": (
        "等效构件：动能、功率与整个机械系统相等"
    ),
    "field balancing: influence coefficient; four-run method without phase": "现场平衡：影响系数法、三圆法",
    "forces between the teeth of gears: along the line of action": "齿轮的啮合力沿啮合线",
    "forces in epicyclic gear trains: equilibrium of arm, planet and central gears": (
        "周转轮系的力分析：系杆、行星轮、中心轮的平衡"
    ),
    "friction circle; the two-force link": "摩擦圆；二力杆",
    "friction in higher pairs": "高副中的摩擦",
    "friction in sliding and turning pairs": "移动副与转动副中的摩擦",
    "friction in sliding pairs": "移动副中的摩擦",
    "friction in wedges: friction angle, force polygon, sine rule": "楔面的摩擦：摩擦角、力多边形、正弦定理",
    "friction of flat and V guides": "平面与槽面的摩擦",
    "friction of inclined faces: both ways, efficiency, self-locking": "斜面的摩擦：正反行程、效率、自锁",
    "friction on an inclined plane: total reaction, friction cone, self-locking": "斜面上的摩擦：总反力、摩擦锥、自锁",
    "gears: generation, line of action, undercut, shift of the rack": "齿轮：范成法、啮合线、根切、变位",
    "inversion: the crank taken as the frame, the figure of the first position laid over": "反转法：取曲柄为机架",
    "inversion: two pairs of positions of a double crank, the driven crank turning by 180°": (
        "反转法：双曲柄机构的两组位置，从动曲柄转过 180°"
    ),
    "kinematic analysis by the vector equation method": "矢量方程图解法",
    "kinematic diagrams": "机构运动简图",
    "kinematic diagrams by Assur groups": "按杆组作机构运动简图",
    "kinematic diagrams: the length of the cylinder is the input": "机构运动简图：以油缸长度为输入",
    "kinetostatic analysis of Assur groups": "杆组的动态静力分析",
    "limit positions: crank and coupler in one line": "极限位置：曲柄与连杆共线",
    "limit positions: crank and coupler in one line, transmission angle at the rocker": (
        "极限位置：曲柄与连杆共线，摇杆处的传动角"
    ),
    "limit positions: the crank is square to the guide bar": "极限位置：曲柄与导杆垂直",
    "mass balance of linkages: masses replaced at the hinges of a link (质量代换)": "机构的平衡：质量代换到铰链",
    "mass balance of linkages: the products about the pivot of a link add to nothing (Berkof–Lowen)": (
        "机构的平衡：构件绕其铰链的质径积之和为零（贝尔科夫—洛温）"
    ),
    "planetary gear trains": "行星轮系",
    "planetary gear trains; pure rolling: the pitch point is the relative instant centre": (
        "行星轮系；纯滚动：节点为相对瞬心"
    ),
    "pressure angle: the acute angle of the force on the driven link to the velocity of its point": (
        "压力角：从动件受力方向与受力点速度方向所夹的锐角"
    ),
    "principle of virtual power: the powers of all given forces, inertia included, sum to zero": (
        "虚功率原理：包括惯性力在内各力的功率之和为零"
    ),
    "pure rolling: the pitch point is the relative instant centre": "纯滚动：节点为相对瞬心",
    "pure rolling: the pitch point lies on the line of centres": "纯滚动：节点在连心线上",
    "pure rolling; relative motion of coincident points": "纯滚动；重合点间的相对运动",
    "relative motion of two points of one link": "同一构件上两点间的运动关系",
    "relative motion of two points of one link and of coincident points": "同一构件上两点间和重合点间的运动关系",
    "rotating guide bar: the stroke line through C cuts the crank circle in the ratio K": (
        "转动导杆：过 C 的行程线将曲柄圆分成 K 倍的两弧"
    ),
    "screw jack: square thread and ring-shaped collar": "螺旋千斤顶：矩形螺纹与环面轴端",
    "self-locking: by geometry of reactions, by force, by efficiency": "自锁：由总反力、由驱动力、由效率判断",
    "structure of mechanisms: F = 3n − 2p_L − p_H − F′ + p′, Assur groups": (
        "机构的结构：F = 3n − 2p_L − p_H − F′ + p′，杆组"
    ),
    "synthesis by inversion for three pairs of angles; Chebyshev's spacing; Freudenstein's equation": (
        "反转法设计三组对应角；切比雪夫插值结点；弗洛伊登斯坦方程"
    ),
    "synthesis by inversion: in the eyes of the link that is kept, the other pin goes round the sought one": (
        "反转法设计：在取作机架的构件上看，另一铰链绕待求铰链转动"
    ),
    "synthesis by the coefficient of travel speed variation: inscribed angle over the chord C1C2": (
        "按行程速比系数设计：弦 C1C2 所对的圆周角"
    ),
    "synthesis by the coefficient of travel speed variation: inscribed angle over the stroke C1C2": (
        "按行程速比系数设计：行程 C1C2 所对的圆周角"
    ),
    "theorem of Roberts and Chebyshev: three four-bars lead one point along one curve": (
        "罗伯茨—切比雪夫定理：三个四杆机构导出同一连杆曲线"
    ),
    "three forces through one point": "三力汇交",
    "areas between M_d and M_r, energy indicator bar, J_F = 900 ΔW / (π² n² δ)": (
        "M_d、M_r 之间的面积，能量指示图，J_F = 900 ΔW / (π² n² δ)"
    ),
    "characteristics, self-regulation, t = J ∫ dω/ΔM by the area under 1/ΔM": (
        "机械特性，自调性，t = J ∫ dω/ΔM 由 1/ΔM 下的面积求"
    ),
    "kinetic energy and power of the equivalent link": "等效构件的动能和功率",
    "symmetrical coupler curves with a straight part": "有直线段的对称连杆曲线",
}


_GROUPS = {
    "Kennedy": "三心定理",
    "aronhold": "阿龙霍尔德",
    "bobillier": "博比利尔",
    "class III": "Ⅲ级杆组",
    "contact": "高副接触",
    "counterweight": "配重",
    "crank": "曲柄",
    "crank, balanced": "曲柄，已平衡",
    "crank, balancing force": "曲柄，平衡力",
    "crank, balancing moment": "曲柄，平衡力矩",
    "cylinder RP": "油缸 RP",
    "cylinder RR": "油缸 RR",
    "euler-savary": "欧拉—萨瓦里",
    "gear": "齿轮",
    "gear train": "轮系",
    "guide": "导路",
    "hartmann": "哈特曼",
    "lever": "杠杆法",
    "limit positions": "极限位置",
    "link between hinges": "两铰链间的构件",
    "link under a couple": "受力偶的构件",
    "rack": "齿条",
    "ratio": "角速度比",
    "rod": "连杆",
    "slide": "滑块",
    "slide, balanced": "滑块，已平衡",
    "slide, balancing force": "滑块，平衡力",
    "slider": "滑块",
    "sliding link": "平动构件",
    "slowest point": "速度最小的点",
    "trial": "试作法",
    "turning link": "转动构件",
    "two-force block R-P": "二力滑块 R-P",
    "two-force link R-R": "二力杆 R-R",
    "velocity": "速度",
    "virtual power": "虚功率",
}


def group_told(group: str, lang: Lang) -> str:
    """What a method is for; letters such as RRP stay."""
    return _GROUPS.get(group, group) if lang == "zh" else group


def source_told(source: str, lang: Lang) -> str:
    """A source in one language: the book, and what of it."""
    pairs = _CHINESE if lang == "zh" else {**_ENGLISH, **_BOOKS}
    for words in sorted(pairs, key=len, reverse=True):  # a longer one may hold a shorter one
        source = source.replace(words, pairs[words])
    return source.replace(", ", "，").replace("; ", "；").replace(": ", "：") if lang == "zh" else source
