"""What is said of the inversion, of each sort of follower."""

from __future__ import annotations

from .....devices.cams.cam import Cam
from .....words import Words

_POLAR = Words(
    "廓线上各点的极坐标：到 $O$ 的距离 $r$ 和自起始点径线起按逆时针量的极角 $θ$",
    "the polar coordinates of these points of the profile: the distance $r$ from $O$ and the angle $θ$, "
    "counter-clockwise from the radius to the first of them",
)
_SIZES = Words(
    "并量法线与从动件运动方向所夹的压力角 $α$（只计大小）",
    "and the sizes of the pressure angles $α$ between the normal and the follower's motion",
)


def opening(cam: Cam) -> Words:
    """What is given is drawn."""
    if cam.arm and cam.follower.flat:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）和以 $OA$ 为半径的摆动中心圆；以 $OA$ 为直径的圆与以 $O$ 为圆心、$r_0$ − "
            "$d$ 为半径的圆的交点，"
            "给出起始时切于基圆的平底的垂线方向（$d$ 为平底到 $A$ 的距离），量得平底的初始角 $ψ_0$。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$ and the circle of the pivots through $A$ about "
            "$O$. The circle on $OA$ as diameter meets that of radius $r_0$ − $d$ about $O$ on the normal of the face, "
            "which touches the base circle at the start ($d$: distance of the face from $A$); $ψ_0$ is read there.",
        )
    if cam.arm:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）和以 $OA$ 为半径的摆动中心圆；以 $A$ 为圆心、$AB$ 为半径的弧交基圆于 "
            "$B_0$，量得摆杆的初始角 $ψ_0$。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$ and the circle of the pivots through $A$ about "
            "$O$; the arc of radius $AB$ about $A$ meets the base circle at $B_0$, and $ψ_0$ is read there.",
        )
    if cam.follower.flat:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）；从动件的导路过 $O$，平底与导路垂直，起始时与基圆相切。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$. The guide passes through $O$; the face, at "
            "right angles to it, touches the base circle at the start.",
        )
    if not cam.follower.e:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）；导路过 $O$，交基圆于 $B_0$，量得 $s_0$。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$. The guide passes through $O$ and meets the base "
            "circle at $B_0$; $s_0$ is read there.",
        )
    return Words(
        "按 $μ_l$ 作基圆（半径 $r_0$）和偏距圆（半径 $e$）；导路切偏距圆于 $C_0$，交基圆于 $B_0$，量得 $s_0$。",
        "To the scale $μ_l$ draw the base circle of radius $r_0$ and the offset circle of radius $e$. The guide "
        "touches the offset circle at $C_0$ and meets the base circle at $B_0$; $s_0$ is read there.",
    )


def turning(cam: Cam) -> Words:
    """Guide or arm go round against the cam."""
    against = Words("顺时针", "clockwise") if cam.sense > 0 else Words("逆时针", "counter-clockwise")
    opened = Words(
        f"给整个机构加上 $−ω$，凸轮不动，导路按{against.zh}反转（与凸轮转向相反），",
        f"Add $−ω$ to the whole mechanism: the cam stands still and the guide turns {against.en}, against the sense of "
        "the cam. ",
    )
    if cam.arm:
        opened = Words(
            f"给整个机构加上 $−ω$，凸轮不动，摆动中心 $A$ 按{against.zh}反转（与凸轮转向相反），",
            f"Add $−ω$ to the whole mechanism: the cam stands still and $A$ goes round {against.en}, against the "
            "sense of the cam. ",
        )
        if cam.follower.flat:
            return opened + Words(
                "在各分点按起始时的作法得切于基圆的平底，再绕 $A$ 转过位移线图上的 $ψ$，得平底的各位置。",
                "At each station the face that touches the base circle is found as at the start and turned about $A$ "
                "by "
                "the $ψ$ of the diagram: the face in its successive positions.",
            )
        return opened + Words(
            "在各分点以 $AB$ 为半径作弧交基圆，自该处转过位移线图上的 $ψ$ 得 $B_1$、$B_2$…"
            "（图上只在 $A$ 的各位置标出 1、2…），连成理论廓线。",
            "At each station the arc of radius $AB$ meets the base circle; from there the arm is turned by the $ψ$ "
            "of the diagram. The points $B_1$, $B_2$ ... (the figure has 1, 2 ... at the positions of $A$) give "
            "the pitch curve.",
        )
    if cam.follower.flat:
        return opened + Words(
            "在各分点的导路上自基圆向外量 $s$，作导路的垂线，即平底的各位置。",
            "On each guide lay off $s$ outwards from the base circle and draw the perpendicular: the face in its "
            "places.",
        )
    return opened + _along_guides(cam)


def _along_guides(cam: Cam) -> Words:
    """How the points of the pitch curve are found on the guides."""
    way = (
        Words("都切于偏距圆", "touches the offset circle")
        if cam.follower.e
        else Words("都过 $O$", "passes through $O$")
    )
    return Words(
        f"各分点的导路{way.zh}；自基圆沿导路向外量位移线图上的 $s$，得 $B_1$、$B_2$…（图上标作 1、2…），连成理论廓线。",
        f"In the position of every station the guide {way.en}. Along the guide lay off the displacement $s$, taken "
        "from the diagram, outwards from the base circle; the points $B_1$, $B_2$ ... (1, 2 ... in the figure) are "
        "joined to the pitch curve.",
    )


def enveloped(cam: Cam) -> Words:
    """The profile, and where it is touched."""
    if cam.follower.flat:
        first = Words("平底各位置的包络线即凸轮廓线。", "The envelope of the face is the profile. ")
        last = Words(
            f"，与平底的交点即切点。量{_POLAR.zh}，与位移线图上读得的值一并列表：",
            f"; it meets the face at the point of contact. Measure {_POLAR.en}; the table has them beside the values "
            "read off the diagram:",
        )
    elif cam.follower.roller:
        first = Words(
            "以理论廓线上各点为圆心作滚子圆，其内包络线即实际廓线。",
            "Draw the circles of the roller about the points of the pitch curve; their inner envelope is the profile. ",
        )
        last = Words(
            f"，沿法线向内量 $r_r$ 得切点。量{_POLAR.zh}，{_SIZES.zh}，与位移线图上读得的值一并列表：",
            f". Lay off $r_r$ inwards along the normal to find the point of contact. Measure {_POLAR.en}, {_SIZES.en}; "
            "the table has them beside the values read off the diagram:",
        )
    else:
        first = Words("尖顶从动件的理论廓线就是实际廓线。", "Under a knife edge the pitch curve is the profile. ")
        last = Words(
            f"。量{_POLAR.zh}，{_SIZES.zh}，与位移线图上读得的值一并列表：",
            f". Measure {_POLAR.en}, {_SIZES.en}; the table has them beside the values read off the diagram:",
        )
    return first + _normal(cam) + last


def _normal(cam: Cam) -> Words:
    if cam.arm:
        return Words(
            "法线过凸轮与从动件的瞬心 $P$（在 $OA$ 上，按 $OP$∶$PA$ = d$ψ$/d$φ$∶1 分线段 $OA$）",
            "The normal passes through the instant centre $P$ of cam and follower, which divides $OA$ as $OP$ : $PA$ "
            "= d$ψ$/d$φ$ : 1",
        )
    return Words(
        "法线过凸轮与从动件的瞬心 $P$（过 $O$ 作导路的垂线，在其上量 $OP$ = d$s$/d$φ$，由位移线图的作图线得出）",
        "The normal passes through the instant centre $P$ of cam and follower, on the perpendicular to the guide "
        "through $O$ with $OP$ = d$s$/d$φ$ from the lines of the diagram",
    )
