"""Set type drawn on a reportlab canvas: operators written directly, text in place, selectable."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .box import MM, Box, Glyphs, Rgb, Rule
from .fonts import MISSING, Face, load, missing_text

BLACK = (0.0, 0.0, 0.0)  # to which type returns after letters in an ink of their own


class Ink:
    """Collects operators for one canvas; all lengths in points. Nothing is drawn before `flush`."""

    __slots__ = (
        "_canvas", "_ends", "_font", "_inked", "_known", "_open", "_rgb", "_rules", "_spacing", "_tagged", "_text",
        "_under",
    )  # fmt: skip

    def __init__(self, canvas: Any) -> None:
        self._canvas = canvas
        self._known: dict[tuple[str, str], list[tuple[str, str]]] = canvas.__dict__.setdefault("_vecpoly_shown", {})
        self._under: Callable[[], tuple[str, ...]] | None = None
        self._open: Callable[[], tuple[str, ...]] | None = None
        self._ends: list[str] = []
        self._tagged = False
        self._text: list[str] = []
        self._rules: list[str] = []
        self._font: tuple[str, float] | None = None
        self._spacing = (0.0, 0.0)
        self._rgb: Rgb | None = None
        self._inked = False

    def under(self, begin: Callable[[], tuple[str, ...]] | None) -> None:
        """What text follows is marked content, which `begin` opens as soon as there is some; rules are artifacts."""
        self._under = begin
        self._tagged = True

    def rule(self, x: float, y: float, width: float, height: float) -> None:
        """A filled rectangle."""
        self._rules.append(f"{x:.4f} {y:.4f} {width:.4f} {height:.4f} re f")

    def text(self, run: Glyphs, x: float, y: float, chars: float = 0.0, blanks: float = 0.0) -> None:
        """A run at (x, y), its own place left out of account; chars, blanks: space added to each."""
        out = self._text
        if self._under is not self._open:
            self._turn(out)
        out.append(f"1 0 0 1 {x:.4f} {y:.4f} Tm")
        if run.rgb != self._rgb:
            out.append("{:.3g} {:.3g} {:.3g} rg".format(*(run.rgb or BLACK)))
            self._rgb, self._inked = run.rgb, True
        if (chars, blanks) != self._spacing:
            out.append(f"{chars:.4f} Tc {blanks:.4f} Tw")
            self._spacing = (chars, blanks)
        name, size, string = run.font, run.size, run.text
        if name == MISSING:
            lost(self._canvas).update(dict.fromkeys(string))
            name, size, string = Face.STIX.value, size / 2, "".join(map(missing_text, string))
        for inner, shown in self._shown(name, string):
            if (inner, size) != self._font:
                out.append(f"{inner} {size:.5g} Tf")
                self._font = (inner, size)
            out.append(shown)

    def _shown(self, name: str, string: str) -> list[tuple[str, str]]:
        """The string in the subsets of its face, each with the operator that shows it; found once for a canvas."""
        found = self._known.get((name, string))
        if found is None:
            font, document = load(Face(name)), self._canvas._doc
            found = self._known[name, string] = [
                (font.getSubsetInternalName(subset, document), f"({self._canvas._escape(codes)}) Tj")
                for subset, codes in font.splitString(string, document)
            ]
        return found

    def _turn(self, out: list[str]) -> None:
        """Close what marked content is open, and open what is wanted."""
        out.extend(self._ends)
        begun = self._under() if self._under is not None else ()
        out.extend(begun)
        self._ends = ["EMC"] * len(begun)
        self._open = self._under

    def box(self, box: Box, x: float, y: float) -> None:
        """A box with its origin at (x, y)."""
        for item in box.items:
            match item:
                case Glyphs():
                    self.text(item, x + item.x * MM, y + item.y * MM)
                case Rule():
                    self.rule(x + item.x * MM, y + item.y * MM, item.width * MM, item.height * MM)

    def flush(self) -> None:
        """Hand everything to the canvas, in its fill colour."""
        code = self._canvas._code
        if self._rules and self._tagged:
            self._rules = ["/Artifact BMC", *self._rules, "EMC"]
        code.extend(self._rules)
        if self._text:
            self._text.extend(self._ends)
            if self._spacing != (0.0, 0.0):
                self._text.append("0 Tc 0 Tw")
            text = f"BT {' '.join(self._text)} ET"
            code.append(f"q {text} Q" if self._inked else text)
        self.__init__(self._canvas)  # type: ignore[misc]


def draw(canvas: Any, box: Box, x_pt: float, y_pt: float) -> None:
    """Draw a box with its origin at (x, y) points, in the canvas's fill colour, as selectable text."""
    ink = Ink(canvas)
    ink.box(box, x_pt, y_pt)
    ink.flush()


def lost(canvas: Any) -> dict[str, None]:
    """The characters drawn on this canvas that no face has, in order; shown as their code points."""
    found: dict[str, None] = canvas.__dict__.setdefault("_vecpoly_lost", {})
    return found
