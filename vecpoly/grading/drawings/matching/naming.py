"""Names and layers as people write them: v_C, pc, p–c, "p c", b2c2, 速度, 辅助线."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ....figures import View
from ....foundation.indices import DIGITS
from ..expected import Edge, Shape

_SIGNS = re.compile(r"[\s_\-–—→⃗{}^$.,:：，、]+")
_PRIMES = str.maketrans({"′": "'", "’": "'", "‘": "'", "´": "'", "`": "'", "″": "''"})
_SUBSCRIPTS = str.maketrans(DIGITS + "ⁿᵗᵏʳ", "0123456789ntkr")
_HELPING = re.compile(
    r"constr|direction|auxil|helper|help|guide ?line|hidden|cent(er|re)|dim|defpoints|text|label|sheet|frame|title|"
    r"border|hatch|tint|grid|axis|axes|^thin$|^joint$|^body$|辅助|作图线|方向线|构造|中心线|虚线|细实线|尺寸|标注|图框|文字|边框|标题",
    re.IGNORECASE,
)
_VIEWS = (
    (re.compile(r"accel|加速度|^a[ _-]?(poly|图)?$", re.IGNORECASE), "acceleration"),
    (re.compile(r"veloc|速度|^v[ _-]?(poly|图)?$", re.IGNORECASE), "velocity"),
    (re.compile(r"force|力|^f[ _-]?(poly|图)?$", re.IGNORECASE), "force"),
    (re.compile(r"mechan|linkage|kinematic|机构|运动简图|位置图", re.IGNORECASE), "mechanism"),
)


def plain(name: str) -> str:
    """A name without signs: v_{C2} → vC2, "p c′" → pc'."""
    return _SIGNS.sub("", name.translate(_PRIMES).translate(_SUBSCRIPTS))


def helping(layer: str) -> bool:
    """Whether what lies on this layer is no vector: helping lines, dimensions, lettering, the frame of the sheet."""
    return bool(_HELPING.search(layer.strip()))


def figure_of(layer: str) -> str:
    """The kind of figure that a layer is for; empty where it does not say."""
    return next((name for words, name in _VIEWS if words.search(layer.strip())), "")


def fits(layer: str, view: View) -> bool:
    """Whether lines of this layer may belong to such a figure."""
    return figure_of(layer) in ("", view.name)


def called(edge: Edge) -> frozenset[str]:
    """Every name of a vector: its quantity's, its letters' (either way); of acceleration also without primes."""
    symbols = {plain(key).casefold() for key in edge.keys}
    symbols |= {_swapped(one) for one in symbols}
    letters = {plain(a + b) for a in edge.tail for b in edge.tip} | {plain(b + a) for a in edge.tail for b in edge.tip}
    return frozenset({*symbols, *letters})


def _swapped(symbol: str) -> str:
    """anCB for a^n_CB is also written aCBn, R_12 as F_12."""
    found = re.match(r"^(a)([ntkr])(.+)$", symbol)
    if found:
        return found[1] + found[3] + found[2]
    return "f" + symbol[1:] if symbol.startswith("r") else symbol


def named(text: str, layer: str, shapes: Iterable[Shape]) -> tuple[str, str] | None:
    """The figure and the quantity that a name stands for; None where it stands for none, or for two."""
    name = plain(text)
    if not name:
        return None
    found = [
        (shape.name, edge.key)
        for shape in shapes
        if not shape.diagram and fits(layer, shape.view)
        for edge in shape.edges
        if edge.key and (name in (names := called(edge)) or (_symbolic(name) and name.casefold() in names))
    ]
    return found[0] if len(set(found)) == 1 else None


def _symbolic(name: str) -> bool:
    """Whether case does not tell names apart: VC2 is v_C2, but PC is no line pc."""
    return len(name) > 1 and name[0].casefold() in "varfgm"


def letters_in(text: str) -> tuple[str, ...]:
    """The letters that a label gives one place: p,c3 → p, c3."""
    return tuple(part for one in re.split(r"[,，、;(（) ）]+", text) if (part := plain(one)))
