"""The objects of a GeoGebra file, each after those that it depends on, with the house's lines and colours."""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as ET

from ...drawing.style import Dash, Hue, Pen
from .labels import Labels

_DASH = {Dash.FULL: "0", Dash.DASHED: "15", Dash.SHORT: "10", Dash.DASH_DOT: "30", Dash.TWO_DOTS: "20"}
UNSEEN = Pen(width=0.18)
DOTTED, RING = "0", "2"  # styles of points


class Page:
    """Objects are added one after the other; what is made of expressions is made anew whenever these change."""

    def __init__(self, title: str) -> None:
        self.root = ET.Element("construction", title=title, author="vecpoly", date="")
        self.labels = Labels()

    def slider(
        self, label: str, value: float, low: float, high: float, step: float, at: tuple[float, float], caption: str
    ) -> None:
        """A number that is changed by hand."""
        one = self._element("numeric", label, Pen(width=0.5), seen=True, caption=caption)
        ET.SubElement(
            one,
            "slider",
            min=repr(round(low, 9)),
            max=repr(round(high, 9)),
            absoluteScreenLocation="true",
            width="260",
            x=repr(at[0]),
            y=repr(at[1]),
            fixed="true",
            horizontal="true",
            showAlgebra="true",
        )
        one.insert(0, ET.Element("value", val=repr(value)))  # before it is shown, lest it be clipped to a default range
        ET.SubElement(one, "animation", step=repr(step), speed="1", type="1", playing="false")

    def number(self, label: str, text: str, *, auxiliary: bool = False, caption: str = "") -> None:
        """A number that follows from others."""
        ET.SubElement(self.root, "expression", label=label, exp=text)
        one = self._element("numeric", label, UNSEEN, caption=caption)
        if auxiliary:
            ET.SubElement(one, "auxiliary", val="true")

    def hidden(self, text: str) -> str:
        """A number that only serves others."""
        label = self.labels.new("t", str(len(self.root)))
        self.number(label, text, auxiliary=True)
        return label

    def free_point(self, label: str, at: complex, *, caption: str = "", seen: bool) -> ET.Element:
        """A point that may be dragged."""
        one = self._element("point", label, Pen(width=0.5), seen=seen, caption=caption)
        ET.SubElement(one, "coords", x=repr(at.real), y=repr(at.imag), z="1.0")
        return self._dotted(one, RING, "3")

    def point(self, label: str, text: str) -> ET.Element:
        """A point that follows from others, unseen until it is shown."""
        ET.SubElement(self.root, "expression", label=label, exp=text, type="point")
        return self._element("point", label, Pen(width=0.5))

    def stands(self, one: ET.Element, at: complex) -> None:
        """Where a point stands, or what a vector is, as the file is written."""
        z = "0.0" if one.get("type") == "vector" else "1.0"
        _set(one, "coords", x=repr(float(at.real)), y=repr(float(at.imag)), z=z)

    def show(self, point: ET.Element, style: str, size: str, caption: str, hue: Hue) -> None:
        """Let a point be seen, with its letter."""
        _set(point, "show", object="true", label="true")
        _set(point, "objColor", **_colour(hue))
        _set(point, "caption", val=caption)
        _set(point, "labelMode", val="3")
        self._dotted(point, style, size)

    def beside(self, point: ET.Element) -> None:
        """Write its letter on the other side."""
        _set(point, "labelOffset", x="-18", y="22")

    def line(self, command: str, kind: str, inputs: Iterable[str], pen: Pen, *, caption: str = "") -> ET.Element:
        """What a command draws through points: Segment, Vector, PolyLine, Circle, CircleArc."""
        label = self.labels.new("d", str(len(self.root)))
        self._command(command, inputs, label)
        return self._element(kind, label, pen, seen=True, caption=caption, lettered=bool(caption), quiet=True)

    def text(self, words: str, at: str) -> None:
        """Words that stand at a point."""
        label = self.labels.new("T", str(len(self.root)))
        ET.SubElement(self.root, "expression", label=label, exp='"' + words.replace('"', "") + '"')
        one = self._element("text", label, Pen(width=0.18), seen=True, quiet=True)
        ET.SubElement(one, "startPoint", exp=at)

    def _command(self, name: str, inputs: Iterable[str], label: str) -> None:
        command = ET.SubElement(self.root, "command", name=name)
        ET.SubElement(command, "input", {f"a{i}": text for i, text in enumerate(inputs)})
        ET.SubElement(command, "output", a0=label)

    def _element(
        self,
        kind: str,
        label: str,
        pen: Pen,
        *,
        seen: bool = False,
        caption: str = "",
        lettered: bool = False,
        quiet: bool = False,
    ) -> ET.Element:
        one = ET.SubElement(self.root, "element", type=kind, label=label)
        on = "true" if seen else "false"
        ET.SubElement(
            one, "show", object=on, label="true" if seen and (lettered or kind in ("numeric", "point")) else "false"
        )
        ET.SubElement(one, "objColor", _colour(pen.hue))
        if caption:
            ET.SubElement(one, "caption", val=caption)
            ET.SubElement(one, "labelMode", val="3" if kind != "numeric" else "9" if seen else "3")
        if quiet:
            ET.SubElement(one, "auxiliary", val="true")
        ET.SubElement(one, "lineStyle", thickness=str(max(1, round(10 * pen.width))), type=_DASH[pen.dash])
        return one

    def _dotted(self, one: ET.Element, style: str, size: str) -> ET.Element:
        _set(one, "pointSize", val=size)
        _set(one, "pointStyle", val=style)
        return one


def _colour(hue: Hue) -> dict[str, str]:
    red, green, blue = (str(round(255 * part)) for part in hue.value)
    return {"r": red, "g": green, "b": blue, "alpha": "0.0"}


def _set(one: ET.Element, tag: str, **values: str) -> None:
    found = one.find(tag)
    (ET.SubElement(one, tag) if found is None else found).attrib.update(values)
