"""The header of a table: which quantity each column holds, in which unit, and which column is the drive's position."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from ...errors import FaultError, TableError, VecpolyError
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...oracle import Motion
from ...problem.schema.faults import meant
from ...units.names import unit_of
from ...words import Words
from .quantity_names import STEMS, is_drive, read_other, read_target
from .sheet import Sheet
from .target import Target

LEFT_OUT = "-"
_BRACKETS = re.compile(r"(.*?)\s*[\[(（]\s*([^\[（]+?)\s*[\])）]")
_SLASH = re.compile(r"([^/]+?)\s*/\s*\(?([^()]+|\([^()]+\)/[^()]+)\)?")
_SUFFIX = re.compile(r"(.+?)[_ ](deg|rad|°|(?:deg|rad|mm|cm|m)(?:[_/]s(?:\^?2|²)?)?|rpm|r_min|r/min)")
_SPELLING = str.maketrans({"²": "^2", "·": "*", "°": "deg", "−": "-", "⁻": "-", "¹": "1", "º": "deg"})
_PER_SECOND = re.compile(r"[*·. ]?s\^?(?:\{?(?:-|−|⁻)([12¹²])\}?)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Unit:
    """A unit as written, and its value in SI."""

    name: str
    factor: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Heading:
    """One column: its place, its quantity (None: the drive's position), its unit (None: not said)."""

    index: int
    text: str
    target: Target | None
    unit: Unit | None
    said: bool = False  # whether the user said what it is
    renumbered: str = ""  # symbol in the table, where it gives its link another number


@dataclass(frozen=True, slots=True, kw_only=True)
class Headings:
    """The columns of a table: the drive's position, what is compared, and what is left out."""

    drive: Heading
    columns: tuple[Heading, ...]
    left_out: tuple[str, ...]


def read_header(sheet: Sheet, mech: Mechanism, said: Mapping[str, str], loads: Loads | None = None) -> Headings:
    """Read the header, with what the user says about columns:
    header → quantity, unit, `quantity[unit]`, or - to leave it out.

    Raises TableError for a column that does not exist, for a misspelt quantity, for a unit of another kind, and where
    no column tells the drive's position or nothing is left to compare.
    """
    for header in said:
        if header not in sheet.header:
            raise TableError(
                Words(f"{sheet.name}：没有列“{header}”", f"{sheet.name}: there is no column '{header}'")
                + meant(header, sheet.header)
            )
    found, left_out = [], []
    for i, text in enumerate(sheet.header):
        heading = _heading(sheet, i, said.get(text, ""), mech, loads)
        if heading is None:
            left_out.append(text or f"{i + 1}")
        else:
            found.append(heading)
    drive = _of_drive(sheet, found, mech)
    columns = tuple(h for h in found if h.target is not None)
    if not columns:
        raise TableError(
            Words(
                f"{sheet.name}：没有可比较的量；请将列命名为 phi5、omega5、alpha5、xE、vE、aE，"
                "或用 --columns 列名=omega_5 指明",
                f"{sheet.name}: no column holds a quantity to compare; name them phi5, omega5, alpha5, xE, vE, "
                "aE, or say --columns NAME=omega_5",
            )
        )
    return Headings(drive=drive, columns=columns, left_out=tuple(left_out))


def _of_drive(sheet: Sheet, found: Sequence[Heading], mech: Mechanism) -> Heading:
    """The one column that tells the drive's position."""
    drive = [h for h in found if h.target is None]
    if not drive:
        raise TableError(
            Words(
                f"{sheet.name}：没有给出原动件位置的列；请将一列命名为 phi{mech.drive.link}，"
                f"或用 --columns 列名=phi{mech.drive.link} 指明（现有：{', '.join(sheet.header)}）",
                f"{sheet.name}: no column tells the position of the drive; name one phi{mech.drive.link}, or "
                f"say --columns NAME=phi{mech.drive.link} (there are: {', '.join(sheet.header)})",
            )
        )
    if len(drive) > 1:
        raise TableError(
            Words(
                f"{sheet.name}：“{drive[0].text}”与“{drive[1].text}”都是原动件位置；"
                f"请用 --columns {drive[1].text}=- 略去其一",
                f"{sheet.name}: '{drive[0].text}' and '{drive[1].text}' both tell the position of the drive; "
                f"leave one out with --columns {drive[1].text}=-",
            )
        )
    return drive[0]


def split(text: str) -> tuple[str, str]:
    """Name and unit of a header: `v_E [m/s]`, `φ5/rad`, `omega5_rad_s`."""
    for pattern in (_BRACKETS, _SUFFIX, _SLASH):
        if m := pattern.fullmatch(text.strip()):
            unit = m[2]
            return m[1].strip(" /"), re.sub(r"(?<=[a-z])_(?=s|min)", "/", unit) if pattern is _SUFFIX else unit
    return text.strip(), ""


def _heading(sheet: Sheet, i: int, said: str, mech: Mechanism, loads: Loads | None) -> Heading | None:
    text, where = sheet.header[i], sheet.at(sheet.head_line, i)
    if said == LEFT_OUT:
        return None
    name, unit = split(text)
    unit = unit or sheet.units[i]
    if said:
        told, told_unit = split(said)
        if told_unit or not _is_unit(said):
            name, unit = told, told_unit or unit
        else:
            unit = said
    if _means_drive(name, mech):
        return Heading(index=i, text=text, target=None, unit=_drive_unit(unit, mech, where))
    target = read_target(name)
    if target is None or (target.of_link and target.of_link not in mech.numbered):
        target = read_other(name, mech, loads) or target
    if target is None:
        if said or _nearly_a_stem(name):
            raise TableError(where + _no_quantity(name, text))
        return None
    return Heading(index=i, text=text, target=target, unit=_unit(unit, target.unit, where), said=bool(said))


def _means_drive(name: str, mech: Mechanism) -> bool:
    """Whether the position of this drive is meant: phi, 曲柄转角, phi1; s1 of a slider, s23 of a cylinder."""
    drive, short = mech.drive, name.replace("_", "")
    if is_drive(name) or (drive.slide and short == f"s{drive.link}"):
        return True
    if drive.between:
        return short == f"{'s' if drive.slide else 'phi'}{drive.link}{drive.on}"
    one = None if drive.slide else read_target(name)
    return one is not None and one.is_angle and one.link == drive.link


def _nearly_a_stem(name: str) -> bool:
    """Whether it looks like a misspelt quantity."""
    stems = [stem for stem in STEMS if len(stem) > 2]
    return bool(get_close_matches(re.sub(r"[_\d]", "", name).lower(), stems, n=1, cutoff=0.75))


def _no_quantity(name: str, text: str) -> Words:
    return Words(
        f"：“{name}”不是可识别的量；请写 phi5、omega5、alpha5、xE、vE、vxE、aE，或用 --columns {text}=- 略去此列",
        f": '{name}' is no quantity; write phi5, omega5, alpha5, xE, vE, vxE, aE, or leave the "
        f"column out with --columns {text}=-",
    )


def known(sheet: Sheet, heading: Heading, mech: Mechanism, motion: Motion) -> None:
    """TableError where the mechanism has no such link or point."""
    target, where = heading.target, sheet.at(sheet.head_line, heading.index)
    assert target is not None
    if target.of_link and target.of_link not in mech.numbered:
        raise TableError(
            where
            + Words(
                f"：没有构件 {target.of_link}；已有：{', '.join(mech.numbered)}；请指明是哪个构件，"
                f"如 --columns {heading.text}={target.on(mech.numbered[-1]).key}",
                f": there is no link {target.of_link}; known: {', '.join(mech.numbered)}; say which it is, e.g. "
                f"--columns {heading.text}={target.on(mech.numbered[-1]).key}",
            )
        )
    try:
        target.of(motion)
    except VecpolyError as error:
        raise TableError(where + Words("：", ": ") + error.words) from None


def _is_unit(text: str) -> bool:
    try:
        unit_of(_plain(text))
    except FaultError:
        return False
    return True


def _plain(text: str) -> str:
    text = (
        _PER_SECOND.sub(lambda m: "/s^2" if m[1] in "2²" else "/s", text).removeprefix("(").removesuffix(")")
        if "(" not in text[1:]
        else text
    )
    return re.sub(r"(?<=[a-z])2$", "^2", text.translate(_SPELLING))


def _unit(text: str, si: str, where: Words) -> Unit | None:
    """The unit, checked against the quantity's; None where none is written."""
    if not text:
        return None
    try:
        factor, dimension = unit_of(_plain(text))
    except FaultError as fault:
        raise TableError(where + Words("：", ": ") + fault.words) from None
    if dimension != unit_of(_plain(si))[1]:
        raise TableError(
            where
            + Words(
                f"：单位“{text}”不属于以 {si} 为单位的量", f": the unit '{text}' does not belong to a quantity in {si}"
            )
        )
    return Unit(name=re.sub(r"(?<=s)\^?2$", "^2", text.replace("²", "2")), factor=factor)


def _drive_unit(text: str, mech: Mechanism, where: Words) -> Unit | None:
    return _unit(text, "m" if mech.drive.slide else "rad", where)
