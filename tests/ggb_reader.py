"""A second reader of GeoGebra files: evaluates their objects for any value of the slider; knows not the exporter."""

from __future__ import annotations

import ast
import io
import math
import operator
import re
import zipfile
from typing import Any
from xml.etree import ElementTree as ET

_LABEL = re.compile(r"[^\W\d]\w*_\{\w+\}|[A-Za-z]\w*")
_KNOWN: dict[str, Any] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan2": math.atan2,
    "exp": math.exp,
    "abs": abs,
    "sgn": lambda v: float((v > 0) - (v < 0)),
    "x": lambda p: p.real,
    "y": lambda p: p.imag,
}
_OPERATIONS: dict[type, Any] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
}
COMMANDS = {"Segment", "Vector", "PolyLine", "Circle", "CircleArc"}


def construction(data: bytes) -> ET.Element:
    """The construction of a file."""
    with zipfile.ZipFile(io.BytesIO(data)) as folder:
        assert folder.namelist() == ["geogebra.xml"]
        found = ET.fromstring(folder.read("geogebra.xml")).find("construction")
    assert found is not None
    return found


def evaluated(data: bytes, slider: float | None = None) -> dict[str, Any]:
    """The value of every object: numbers, points as x + iy, of lines and vectors those of what they were made of."""
    known: dict[str, Any] = {}
    for one in construction(data):
        label = one.get("label", "")
        if one.tag == "element" and label not in known:  # free: given by its own value
            known[label] = _free(one, slider)
        elif one.tag == "expression":
            text = one.get("exp", "")
            assert label not in known
            known[label] = text if text.startswith('"') else value(text, known)
        elif one.tag == "command":
            made, given = one.find("output"), one.find("input")
            assert one.get("name") in COMMANDS and made is not None and given is not None
            known[made.get("a0", "")] = [value(text, known) for text in given.attrib.values()]
    return known


def _free(one: ET.Element, slider: float | None) -> Any:
    place, number = one.find("coords"), one.find("value")
    if place is not None:
        return complex(float(place.get("x", "")), float(place.get("y", "")))
    assert number is not None and one.find("slider") is not None
    return float(number.get("val", "")) if slider is None else slider


def value(text: str, known: dict[str, Any]) -> Any:
    """The value of an expression."""
    names: dict[str, str] = {}

    def plain(found: re.Match[str]) -> str:
        if re.match(r"[0-9.]E?$", found.string[max(found.start() - 1, 0) : found.start()]) and found.group().startswith(
            "E"
        ):
            return found.group()  # the exponent of a number
        return names.setdefault(found.group(), f"n{len(names)}")

    source = _LABEL.sub(plain, text).replace("[", "(").replace("]", ")").replace("^", "**")
    return _of(ast.parse(source.strip(), mode="eval").body, {short: name for name, short in names.items()}, known)


def _of(node: ast.expr, names: dict[str, str], known: dict[str, Any]) -> Any:
    match node:
        case ast.Constant(value=number):
            return number
        case ast.Name(id=short):
            return known[names[short]]
        case ast.Tuple(elts=[x, y]):
            return complex(_of(x, names, known), _of(y, names, known))
        case ast.BinOp(left=left, op=op, right=right):
            return _OPERATIONS[type(op)](_of(left, names, known), _of(right, names, known))
        case ast.UnaryOp(op=op, operand=operand):
            return _OPERATIONS[type(op)](_of(operand, names, known))
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return _OPERATIONS[type(op)](_of(left, names, known), _of(right, names, known))
        case ast.Call(func=ast.Name(id=short), args=args):
            name = names[short]
            if name == "If":
                return _of(args[1] if _of(args[0], names, known) else args[2], names, known)
            return _KNOWN[name](*(_of(arg, names, known) for arg in args))
    raise AssertionError(ast.dump(node))
