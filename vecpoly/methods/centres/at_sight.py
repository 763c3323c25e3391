"""The centres that need no construction: pins, slides, rolling contacts; and the normals of sliding contacts."""

from __future__ import annotations

from ...board.board import NO_LENGTH
from ...board.paper.marks import Dot, Point, Role
from ...mechanism.model import Contact, Prismatic, Rolling
from ...plane import cross, nominal
from ...words import Words
from .direct import Direct, of_kind, pins, spot
from .state import CentreFigure
from .theorem.polygon import join

NORMAL = 22.0  # mm of a common normal to either side of the contact


def draw_direct(fig: CentreFigure, found: tuple[Direct, ...]) -> None:
    """Letter them on the figure, and draw their lines of the polygon in full."""
    fig.board.step(_words(fig, found), fig.pane)
    for one in found:
        if one.centre is not None:
            fig.settle(one.pair, one.centre)
    for one in found:
        if one.centre is None:
            _normal(fig, one)
            continue
        join(fig.desk, fig.polygon, one.pair, sought=False)
        fig.letter(one.pair, Dot.POINT if isinstance(one.joint, Rolling) else Dot.NONE, _slide(fig, one))


def _slide(fig: CentreFigure, one: Direct) -> complex:
    """Where the arrow of a slide's centre starts: at the pin of its block."""
    return complex(nominal(fig.desk.at[one.where])) * fig.paper.factor if isinstance(one.joint, Prismatic) else 0j


def _normal(fig: CentreFigure, one: Direct) -> None:
    assert one.normal is not None
    at, along = spot(one), complex(nominal(one.normal.along))
    fig.board.join(fig.pane, at - along * NORMAL, at + along * NORMAL, role=Role.DIRECTION)
    for way in () if _named_already(fig, at, along) else (along, -along):
        fig.board.plot(fig.pane, at + way * NORMAL, "n", Dot.NONE)
    fig.board.plot(fig.pane, at, one.where, Dot.POINT)


def _named_already(fig: CentreFigure, at: complex, along: complex) -> bool:
    """Whether the figure has the normal with its letter, as that of a cam has."""
    letters = (m for m in fig.board.marks(fig.pane) if isinstance(m, Point) and m.label == "n")
    return any(abs(float(cross(m.at - at, along))) < NO_LENGTH for m in letters)


def _words(fig: CentreFigure, found: tuple[Direct, ...]) -> Words:
    parts = [
        part
        for part in (_pins(fig, found), _slides(fig, found), _rolling(fig, found), _contacts(fig, found))
        if part is not None
    ]
    full = _full(fig, found)
    return Words(
        "直接相连的构件，其瞬心由观察得到：" + "；".join(part.zh for part in parts) + full.zh,
        "The centres of links that are joined directly are found by inspection: "
        + "; ".join(part.en for part in parts)
        + full.en,
    )


def _full(fig: CentreFigure, found: tuple[Direct, ...]) -> Words:
    """Which are full lines of the polygon: those whose place is known, and not one of which a line only is."""
    known = tuple(one for one in found if one.centre is not None)
    if known == found:
        return Words("。在瞬心多边形上用实线表示。", ". In the circle diagram they are drawn as full lines.")
    names, one = _names(fig, known), len(known) == 1
    drawn = ", whose place is known, is drawn as a full line" if one else ", whose places are known, are full lines"
    return Words(
        f"。在瞬心多边形上，位置已知的 {names.zh} 用实线表示。" if known else "。",
        f". In the circle diagram {names.en}{drawn}." if known else ".",
    )


def _names(fig: CentreFigure, found: tuple[Direct, ...]) -> Words:
    names = [f"${fig.symbol(*one.pair)}$" for one in found]
    return Words("、".join(names), ", ".join(names))


def _pins(fig: CentreFigure, found: tuple[Direct, ...]) -> Words | None:
    by_letter: dict[str, list[Direct]] = {}
    for one in pins(found):
        by_letter.setdefault(one.where, []).append(one)
    parts = [(letter, _names(fig, tuple(there))) for letter, there in by_letter.items()]
    return (
        None
        if not parts
        else Words(
            "转动副中心 " + "，".join(f"${letter}$ 为 {names.zh}" for letter, names in parts),
            "at the pins " + ", ".join(f"${letter}$: {names.en}" for letter, names in parts),
        )
    )


def _slides(fig: CentreFigure, found: tuple[Direct, ...]) -> Words | None:
    there = tuple(one for one in of_kind(found, Prismatic) if one.centre is not None)
    names = _names(fig, there)
    return (
        None
        if not there
        else Words(
            f"移动副的瞬心 {names.zh} 在垂直于导路的无穷远处",
            f"of prismatic joints at infinity, perpendicular to the guide: {names.en}",
        )
    )


def _rolling(fig: CentreFigure, found: tuple[Direct, ...]) -> Words | None:
    there = of_kind(found, Rolling)
    names = _names(fig, there)
    return (
        None
        if not there
        else Words(f"纯滚动两构件的瞬心为其接触点：{names.zh}", f"of links that roll, where they touch: {names.en}")
    )


def _contacts(fig: CentreFigure, found: tuple[Direct, ...]) -> Words | None:
    there = tuple(one for one in found if one.centre is None)
    names = _names(fig, there)
    slots = all(isinstance(one.joint, Prismatic) for one in there)
    at, at_en = (
        ("滚滑副", "of links that slide on each other")
        if there and isinstance(there[0].joint, Contact) and not slots
        else ("销槽副", "of a pin in a slot")
    )
    return (
        None
        if not there
        else Words(
            f"{at}的瞬心 {names.zh} 在过接触点的公法线 $nn$ 上", f"{at_en}, on the common normal $nn$: {names.en}"
        )
    )
