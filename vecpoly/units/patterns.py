"""How a quantity of a kind may be written, as a pattern for editors: 30 mm, 10 rad/s ccw, 0.006 (m/s)/mm."""

from __future__ import annotations

from .reading import Dim

NUMBER = r"[-+−]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?"
SENSE = r"([cC][wW]|[aAcC]?[cC][wW]|([cC]ounter-?|[aA]nti-?)?[cC]lockwise|(逆时针|顺时针)(方向)?)"
_LENGTH = r"(mm|cm|dm|m|km|um|µm|μm|mil|in|inch|metre|meter|毫米|厘米|分米|米|千米|微米|英寸)"
_ANGLE = r"(deg|degree|°|度|rad|radian|弧度|r|rev|turn|转)"
_TIME = r"(s|min|h|second|minute|hour|秒|分|分钟|小时)"
_MASS = r"(kg|g|千克|克)"
_FORCE = r"(N|kN|牛|千牛)"
_TIMES, _SQUARE, _CUBE = r" ?[*·⋅×]? ?", r"(\^2|\*\*2|²)", r"(\^3|\*\*3|³)"
_WORK = rf"(J|kJ|焦|千焦|{_FORCE}{_TIMES}{_LENGTH})"


def pattern(dim: Dim) -> str:
    """A pattern (of ECMA and of Python) that a written quantity of this kind matches; zero needs no unit."""
    sense = rf"( ?{SENSE})?" if dim in (Dim.ANGLE, Dim.OMEGA, Dim.ALPHA, Dim.MOMENT) else ""
    return rf"^ *({NUMBER} *{_unit(dim)}{sense}|[-+−]?0*\.?0*) *$"


def _unit(dim: Dim) -> str:
    speed, rate = rf"{_LENGTH} ?/ ?{_TIME}", rf"{_LENGTH} ?/ ?{_TIME}{_SQUARE}"
    match dim:
        case Dim.LENGTH:
            return _LENGTH
        case Dim.ANGLE:
            return _ANGLE
        case Dim.OMEGA:
            return rf"({_ANGLE} ?/ ?{_TIME}|rpm)"
        case Dim.ALPHA:
            return rf"{_ANGLE} ?/ ?{_TIME}{_SQUARE}"
        case Dim.SPEED:
            return speed
        case Dim.ACCEL:
            return rate
        case Dim.MU_L:
            return rf"{_LENGTH} ?/ ?{_LENGTH}"
        case Dim.MU_V:
            return rf"[(（]?{speed}[)）]? ?/ ?{_LENGTH}"
        case Dim.MU_A:
            return rf"[(（]?{rate}[)）]? ?/ ?{_LENGTH}"
        case Dim.MU_F:
            return rf"{_FORCE} ?/ ?{_LENGTH}"
        case _:
            return _of_forces(dim)


def _of_forces(dim: Dim) -> str:
    match dim:
        case Dim.FORCE:
            return _FORCE
        case Dim.AREA:
            return rf"{_LENGTH}{_SQUARE}"
        case Dim.TIME:
            return _TIME
        case Dim.MOMENT:
            return rf"{_FORCE}{_TIMES}{_LENGTH}"
        case Dim.MASS:
            return _MASS
        case Dim.PRODUCT:
            return rf"{_MASS}{_TIMES}{_LENGTH}"
        case Dim.INERTIA:
            return rf"{_MASS}{_TIMES}{_LENGTH}{_SQUARE}"
        case Dim.DENSITY:
            return rf"{_MASS} ?/ ?{_LENGTH}{_CUBE}"
        case Dim.POWER:
            return r"(W|kW|瓦|千瓦)"
        case Dim.WORK:
            return _WORK
        case Dim.DRAG:
            return rf"{_FORCE}{_TIMES}{_LENGTH}{_TIMES}{_TIME}"
        case Dim.MU_WORK:
            return rf"{_WORK} ?/ ?{_LENGTH}{_SQUARE}"
        case _:
            return _of_springs(dim)


def _of_springs(dim: Dim) -> str:
    per = rf"[(（]?{_FORCE}{_TIMES}{_LENGTH}[)）]?"
    match dim:
        case Dim.PRESSURE:
            return rf"(Pa|kPa|MPa|bar|帕|千帕|兆帕|巴|{_FORCE} ?/ ?{_LENGTH}{_SQUARE})"
        case Dim.STIFFNESS:
            return rf"{_FORCE} ?/ ?{_LENGTH}"
        case Dim.TWIST:
            return rf"{per} ?/ ?{_ANGLE}"
        case Dim.DAMPING:
            return rf"[(（]?{_FORCE}{_TIMES}{_TIME}[)）]? ?/ ?{_LENGTH}"
        case _:
            raise ValueError(f"{dim} has a pattern of its own")
