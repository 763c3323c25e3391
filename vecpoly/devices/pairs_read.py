"""How a kinematic pair is written in a structural problem, read."""

from __future__ import annotations

import cmath
import math
import re
from typing import Annotated

from pydantic import AfterValidator, WithJsonSchema

from ..errors import FaultError
from ..words import Words
from .structure_pairs import FRAME, Form, Written, unit_vector

FAR = 1e6  # mm: no sketch is larger
_SHAPE = re.compile(r"\s*([A-Z])\s*\((.*)\)\s*at\s*(\([^()]*\))\s*(?:along\s+(.+?))?\s*")
_MEMBER = re.compile(r"([\w/'′]+)(?:\s+(?:about\s+(\([^()]*\)|[A-Z]\w*['′]?)|(flat)))?")
_COMMA = re.compile(r",(?![^()]*\))")
_EXAMPLE = {
    Form.R: "R(1, 2) at (35, 92)",
    Form.P: "P(3, 0) at (110, 0) along (0, 1)",
    Form.H: "H(1 about (9, 14), 2 flat) at (9, 40)",
    Form.G: "G(1 about A, 2 about B) at (40, 0)",
}


def read_pair(text: object) -> Written:
    """A joint from its text; raises ValueError with what is wrong and how to write it."""
    if isinstance(text, Written):
        return text
    shape = _SHAPE.fullmatch(text) if isinstance(text, str) else None
    if shape is None or shape[1] not in Form.__members__:
        raise FaultError(
            Words(
                f"“{text}”不是运动副；如写 {', '.join(_EXAMPLE.values())}",
                f"'{text}' is no joint; write e.g. {', '.join(_EXAMPLE.values())}",
            ),
            code="spelling",
        )
    form = Form(shape[1])
    members = [_member(part.strip(), form) for part in _COMMA.split(shape[2])]
    links = tuple(link for link, _ in members)
    _check_links(form, links)
    if (form is Form.P) != bool(shape[4]):
        raise FaultError(
            Words(
                f"移动副（且只有移动副）要写导路方向；如写 {_EXAMPLE[Form.P]}",
                f"a slide needs the direction of its guide, and only a slide: write e.g. {_EXAMPLE[Form.P]}",
            ),
            code="spelling",
        )
    about = tuple(centre for _, centre in members) if not form.is_lower else ()
    _check_faces(form, about)
    return Written(form, links, _place(shape[3]), _direction(shape[4]) if shape[4] else 0j, about, str(text))


def _check_links(form: Form, links: tuple[str, ...]) -> None:
    if len(set(links)) != len(links):
        raise FaultError(
            Words(
                f"运动副联接不同的构件；这里写的是 {', '.join(links)}",
                f"a joint joins different links; here stands {', '.join(links)}",
            )
        )
    if len(links) < 2 or (len(links) > 2 and form is not Form.R):
        raise FaultError(
            Words(
                f"{form.value} 联接{'两个或两个以上' if form is Form.R else '两个'}构件，这里有 {len(links)} "
                f"个；如写 {_EXAMPLE[form]}",
                f"{form.value} joins {'two links or more' if form is Form.R else 'two links'}, here "
                f"{len(links)}; write e.g. {_EXAMPLE[form]}",
            ),
            code="spelling",
        )


def _check_faces(form: Form, about: tuple[complex | str | None, ...]) -> None:
    if about and None in about and (form is Form.G or about == (None, None)):
        raise FaultError(
            Words(
                f"{'齿轮要有中心' if form is Form.G else '两平面不成高副'}；如写 {_EXAMPLE[form]}",
                f"{'a gear has a centre' if form is Form.G else 'two flat faces do not make a higher pair'}; "
                f"write e.g. {_EXAMPLE[form]}",
            ),
            code="spelling",
        )


def _member(text: str, form: Form) -> tuple[str, complex | str | None]:
    member = _MEMBER.fullmatch(text)
    if member is None:
        raise FaultError(
            Words(
                f"“{text}”不是构件；如写 1{' about (9, 14)' if not form.is_lower else ''}",
                f"'{text}' is no link; write e.g. 1{' about (9, 14)' if not form.is_lower else ''}",
            ),
            code="spelling",
        )
    link = FRAME if member[1] == "frame" else member[1]
    if form.is_lower:
        if member[2] or member[3]:
            raise FaultError(
                Words(
                    f"“{text}”：只有高副的轮廓才有曲率中心；如写 {_EXAMPLE[form]}",
                    f"'{text}': only the profiles of a higher pair have centres; write e.g. {_EXAMPLE[form]}",
                ),
                code="spelling",
            )
        return link, None
    if not member[2] and not member[3]:
        raise FaultError(
            Words(
                f"“{text}”没有说明其轮廓；如写 {link} about (9, 14)、{link} about B 或 {link} flat",
                f"'{text}' does not say what its profile is; write e.g. {link} about (9, 14), {link} about B, "
                f"or {link} flat",
            ),
            code="spelling",
        )
    if member[3]:
        return link, None
    return link, _place(member[2]) if member[2].startswith("(") else member[2]


def _place(text: str) -> complex:
    """(x, y) in mm to m."""
    try:
        x, y = (float(part) for part in text.strip("()").split(","))
    except ValueError:
        raise FaultError(
            Words(
                f"“{text}”不是位置；请写以 mm 为单位的两个数，如 (35, 92)",
                f"'{text}' is no place; write two numbers in mm, e.g. (35, 92)",
            ),
            code="spelling",
        ) from None
    if not (abs(x) <= FAR and abs(y) <= FAR):
        raise FaultError(
            Words(
                f"“{text}”超出图纸范围；请写以 mm 为单位的两个数，如 (35, 92)",
                f"'{text}' is no place on paper; write two numbers in mm, e.g. (35, 92)",
            ),
            code="spelling",
        )
    return complex(x, y) / 1e3


def _direction(text: str) -> complex:
    """(dx, dy) or an angle in degrees to a unit vector."""
    if text.startswith("("):
        return unit_vector(_place(text))
    try:
        turn = math.radians(float(text.removesuffix("deg")))
    except ValueError:
        turn = math.nan
    if not math.isfinite(turn):
        raise FaultError(
            Words(f"“{text}”不是方向；如写 (0, 1) 或 90 deg", f"'{text}' is no direction; write e.g. (0, 1) or 90 deg"),
            code="spelling",
        )
    return cmath.rect(1.0, turn)


_LETTER = re.compile(r"[A-Z]\d?['′]?")


def _letter(text: str) -> str:
    if _LETTER.fullmatch(text) is None:
        raise FaultError(
            Words(
                f"“{text}”不能作运动副的名称：用一个大写字母，可带一位数字和撇号；如写 A、B1、D'",
                f"'{text}' is no name of a joint: it is one capital letter, with a digit and a prime where they are "
                "needed; write e.g. A, B1, D'",
            ),
            code="spelling",
        )
    return text


Letter = Annotated[str, AfterValidator(_letter), WithJsonSchema({"type": "string", "pattern": f"^{_LETTER.pattern}$"})]
