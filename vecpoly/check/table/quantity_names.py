"""Which quantity the header of a column names: phi5, θ5, vxE, D点加速度, 曲柄转角."""

from __future__ import annotations

import re

from ...cycle.columns import column_of
from ...errors import UnknownNameError, VecpolyError
from ...foundation.indices import LETTER
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, Kind, Rel, parse_rel
from .target import Other, Part, Target

_GREEK = str.maketrans({"φ": "phi", "ϕ": "phi", "θ": "theta", "ψ": "psi", "ω": "omega", "α": "alpha", "ε": "eps",
                        "$": "", "{": "", "}": "", "^": "", "₀": "0", "₁": "1", "₂": "2", "₃": "3", "₄": "4", "₅": "5",
                        "₆": "6", "₇": "7", "₈": "8", "₉": "9", " ": ""})  # fmt: skip
_LINK = r"_?(\d+[a-z']?)"
_LETTER = rf"_?({LETTER}\d*)"
_ANGLE = re.compile(rf"(?:phi|theta|psi|angle|th|fi|f){_LINK}", re.I)
_OMEGA = re.compile(rf"(?:omega|om|w){_LINK}", re.I)
_ALPHA = re.compile(rf"(?:alpha|alfa|eps|epsilon|e|a){_LINK}", re.I)
_COMPONENT = re.compile(rf"([vas]?)_?([xy]){_LETTER}|([vas])?_?({LETTER}\d*)_?([xy])")
_SIZE = re.compile(rf"([va]){_LETTER}")
_REACTION = re.compile(r"[RF]_?(\d\d)[._]?(x|y)?")
_LENGTH = re.compile(r"[ls]_?([A-Z])([A-Z])")
_DRIVE = {"phi", "theta", "angle", "crankangle", "crank_angle", "position", "s"} | {
    *("转角", "角度", "位置", "曲柄角", "曲柄转角", "曲柄角度", "主动件转角", "原动件转角")
}
_KINDS = {"v": Kind.V, "a": Kind.A, "s": Kind.P, "": Kind.P}
STEMS = ("phi", "theta", "omega", "alpha", "gamma", "x", "y", "vx", "vy", "ax", "ay", "v", "a")


_WORDS = (
    (r"(?:构件|杆|link)?(\d+)的?(角位移|转角|角度|方位角|angle)", r"phi\1"),
    (r"(?:构件|杆|link)?(\d+)的?(角速度)", r"omega\1"),
    (r"(?:构件|杆|link)?(\d+)的?(角加速度)", r"alpha\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])(?:坐标|位移)", r"\2\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])?(?:方向|向)?的?(?:分)?速度", r"v\2\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])?(?:方向|向)?的?(?:分)?加速度", r"a\2\1"),
    (r"(?:曲柄|原动件|主动件)?(?:转角|角位移|角度)([φθϕ]_?\d+)", r"\1"),
    (r"(?:角速度|角加速度|转角|角位移|速度|加速度|坐标)([a-zA-Zφθϕωαε]_?\w+)", r"\1"),
)


def plain_name(name: str) -> str:
    """The symbol that a header in words stands for: 构件5的角速度 → omega5, D点加速度 → aD, \\omega_5 → omega_5."""
    text = re.sub(r"\\(?:var)?([a-z]+)", r"\1", name.strip().replace(" ", "")) if "\\" in name else name.strip()
    for pattern, symbol in _WORDS:
        if m := re.fullmatch(pattern, text):
            return m.expand(symbol).replace("X", "x").replace("Y", "y")
    return text


def is_drive(name: str) -> bool:
    """Whether a name without a link means the position of the drive: phi, s, 曲柄转角."""
    return plain_name(name).translate(_GREEK).lower() in _DRIVE


def read_other(name: str, mech: Mechanism, loads: Loads | None) -> Target | None:
    """A key of the cycle's own columns: s_45, v_45, a_45, gamma_23, M_1,
    R_12.x, R12x, R12 (its magnitude); None where it is none."""
    text = name.translate(_GREEK)
    if m := _REACTION.fullmatch(text):
        text = f"R_{m[1]}.{m[2] or 'abs'}"
    for key in (text, re.sub(r"^([A-Za-z]+?)_?(\d+)$", r"\1_\2", text)):
        try:
            column = column_of(mech, loads, key)
        except VecpolyError:
            continue
        if (
            not column.is_vector
            and re.match(r"(s|v|a|gamma|d|M|F|R|eta|h|Q)(_|$)", key)
            and (column.symbol[0] not in "ωα")
        ):
            return Target(other=Other(column=column, loads=loads))
    return None


def read_target(name: str) -> Target | None:
    """phi5, θ5, omega_5, w5, α5, a5, xE, vxE, v_Ex, vE, a_E, l_AB, or a key such as ak_B3B2;
    None where it is no quantity."""
    text = re.sub(
        r"^(p|v|a)_(.+)\.([xy])$", lambda m: f"{m[1].replace('p', '')}{m[3]}_{m[2]}", plain_name(name).translate(_GREEK)
    )
    if text.endswith(".abs"):
        text = text.removesuffix(".abs")
    if m := _OMEGA.fullmatch(text):
        return Target(rel=Rel(Kind.OMEGA, At("", m[1])))
    if m := _ALPHA.fullmatch(text):
        return Target(rel=Rel(Kind.ALPHA, At("", m[1])))
    if m := _ANGLE.fullmatch(text):
        return Target(link=m[1])
    if m := _COMPONENT.fullmatch(text):
        kind, axis, letter = (m[1], m[2], m[3]) if m[3] else (m[4] or "", m[6], m[5])
        return Target(rel=Rel(_KINDS[kind], At(letter)), part=Part(axis))
    if m := _SIZE.fullmatch(text):
        return Target(rel=Rel(_KINDS[m[1]], At(m[2])), part=Part.SIZE)
    if m := _LENGTH.fullmatch(text):
        return Target(rel=Rel(Kind.P, At(m[2]), At(m[1])), part=Part.SIZE)
    try:
        return Target(rel=parse_rel(text), part=Part.SIZE)
    except UnknownNameError:
        return None
