"""Moodle XML of some variants: a category for each problem, so that a quiz draws one at random; never a question for
each student."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from html import escape
from xml.etree import ElementTree as xml

from ...algebra.quantity import number
from ...drawing.backends.svg import to_svg
from ...drawing.figure import draw_figure
from ...grading.key import Graded, Kind, is_count
from ...names import written_unit
from ...report.content import statement
from ...report.document import PICTURE
from ...report.picture import picture
from ...report.values import called
from ...solution import solve
from ...words import Lang, Words, bare
from ..register import Part, Register, Sheet
from .answers import Worth, asked_of, worded, worths
from .cloze import plain_number, row

VARIANTS = 20  # of each problem: Moodle warns of large banks of questions
_GIVEN, _FIND = Words("已知：", "Given: "), Words("求：", "Find: ")
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
_WITHIN = Words("（允许误差 {}）", " (tolerance {})")
_COLON, _BETWEEN = Words("：", ": "), Words("；", "; ")
_SENSE = {True: Words("逆时针", "counter-clockwise"), False: Words("顺时针", "clockwise")}
_WAY = Words("，逆时针为正", ", counter-clockwise positive")
_FROM = Words("（以 {} 为原点）", " from {}")


@dataclass(frozen=True, slots=True)
class _Asked:
    """A variant with what is said of it."""

    sheet: Sheet
    part: Part
    asked: tuple[Graded, ...]
    said: dict[str, str]
    svg: bytes
    worths: dict[str, tuple[Worth, ...]]
    solution: dict[str, str]

    @property
    def name(self) -> str:
        return f"{self.part.problem} {self.sheet.sheet}"


@dataclass(frozen=True)
class Quizzes:
    """Both sorts of questions, over the same variants."""

    register: Register

    @cached_property
    def variants(self) -> tuple[tuple[str, list[_Asked]], ...]:
        """The variants of each problem, solved once."""
        return tuple(_by_problem(self.register))

    def cloze(self) -> bytes:
        """A cloze question for each variant: all blanks of it, with units and senses."""
        root, lang = xml.Element("quiz"), _lang(self.register)
        for problem, variants in self.variants:
            _category(root, self.register, problem, "cloze", lang)
            for one in variants:
                question = _question(root, "cloze", one, one.name, _text(one, lang, blanks=True), lang)
                _tell(question, "hidden", "0")
        return _written(root)

    def numerical(self) -> bytes:
        """A numerical question for each asked quantity of each variant."""
        root, lang = xml.Element("quiz"), _lang(self.register)
        for problem, variants in self.variants:
            for key in dict.fromkeys(one.key for variant in variants for one in variant.asked):
                _category(root, self.register, f"{problem}/{key}", "numerical", lang)
                for variant in variants:
                    for one in variant.asked:
                        if one.key == key:
                            _alone(root, variant, one, lang)
        return _written(root)


def _lang(register: Register) -> Lang:
    return "zh" if register.lang == "zh" else "en"


def _by_problem(register: Register) -> Iterator[tuple[str, list[_Asked]]]:
    lang = _lang(register)
    for exercise in register.exercises:
        parts = [
            (sheet, part)
            for sheet in sorted(register.sheets, key=lambda one: one.sheet)
            for part in sheet.parts
            if part.problem == exercise.id
        ]
        if not exercise.data.get("vary"):
            parts = parts[:1]
        some = [(sheet, part) for sheet, part in parts[:VARIANTS] if asked_of(part.key)]
        if some:  # Moodle takes no question without a blank, and then nothing of the file
            yield exercise.id, [_asked(register, sheet, part, lang) for sheet, part in some]


def left_out(register: Register) -> tuple[str, ...]:
    """The problems of which Moodle can mark nothing by itself: all that is asked scatters too much on paper."""
    asked = {part.problem for sheet in register.sheets for part in sheet.parts if asked_of(part.key)}
    return tuple(one.id for one in register.exercises if register.sheets and one.id not in asked)


def _asked(register: Register, sheet: Sheet, part: Part, lang: Lang) -> _Asked:
    problem = register.variant(part)
    solution = solve(problem, precise=False)
    asked = asked_of(part.key)
    drawn = picture(problem, solution.construction.toned({}), *PICTURE)  # a question is in black
    svg = to_svg(draw_figure(drawn, lang=lang, caption=False)).encode() if drawn else b""
    right = {one.key: right_told(one, lang) for one in asked}
    return _Asked(sheet, part, asked, statement(solution, lang), svg, worths(problem, part.key), right)


def right_told(one: Graded, lang: Lang) -> str:
    """What is right, and within what."""
    name = label(one, lang)
    if said := worded(one, lang):
        return f"{name}{_COLON.of(lang)}{said[0]}"
    turns = one.kind is Kind.SIGNED and one.exact
    right = _measured(abs(one.exact) if turns else one.exact, 4, one)
    if turns:
        right += f" {_SENSE[one.exact > 0].of(lang)}"
    return (
        f"{name} = {right}"
        if is_count(one)
        else f"{name} = {right}{_WITHIN.of(lang).format(_measured(one.allowed, 2, one))}"
    )


def _measured(value: float, digits: int, one: Graded) -> str:
    text, unit = bare(number(value, digits)), written_unit(one.unit)
    return text + unit if unit == "°" else f"{text} {unit}".strip()


def _category(root: xml.Element, register: Register, name: str, sort: str, lang: Lang) -> None:
    question = xml.SubElement(root, "question", type="category")
    path = "/".join(("$course$", "top", bare(register.title.of(lang)).replace("/", "//"), sort, name))
    xml.SubElement(xml.SubElement(question, "category"), "text").text = path


def _question(
    root: xml.Element, sort: str, one: _Asked, name: str, text: str, lang: Lang, only: str | None = None
) -> xml.Element:
    """only: the quantity of which alone the feedback tells."""
    question = xml.SubElement(root, "question", type=sort)
    xml.SubElement(xml.SubElement(question, "name"), "text").text = name
    body = xml.SubElement(question, "questiontext", format="html")
    xml.SubElement(body, "text").text = text
    if one.svg:
        file = xml.SubElement(body, "file", name="figure.svg", path="/", encoding="base64")
        file.text = b64encode(one.svg).decode()
    feedback = xml.SubElement(question, "generalfeedback", format="html")
    told = one.solution.values() if only is None else (one.solution[only],)
    xml.SubElement(feedback, "text").text = f"<p>{escape(_BETWEEN.of(lang).join(told))}</p>"
    _tell(question, "penalty", "0.3333333")
    _tell(question, "idnumber", name.replace(" ", "-"))
    return question


def _text(one: _Asked, lang: Lang, *, blanks: bool) -> str:
    said = {key: escape(bare(value)) for key, value in one.said.items()}
    parts = [f"<p>{said['statement']}</p>" if said["statement"] else "", f"<p>{_GIVEN.of(lang)}{said['given']}</p>"]
    if one.svg:
        parts.append(f'<p><img src="@@PLUGINFILE@@/figure.svg" alt="{said["title"]}"></p>')
    if blanks:
        parts += [
            f"<p>{escape(label(asked, lang))} = {escape(row(asked, one.worths[asked.key], lang), quote=False)}</p>"
            for asked in one.asked
        ]
    return "".join(parts)


def label(one: Graded, lang: Lang) -> str:
    """What is asked: its symbol, and by which way it is found where that is told."""
    there = _FROM.of(lang).format(one.origin) if one.origin and one.kind is Kind.SCALAR else ""
    return bare(called(one.symbol, one.key, lang)).replace("^′", "′") + there


def _alone(root: xml.Element, variant: _Asked, one: Graded, lang: Lang) -> None:
    """A question of one quantity: a number within its bands, or a choice."""
    words = worded(one, lang)
    unit = "" if words or not one.unit else f" ({written_unit(one.unit)})"
    way = _WAY.of(lang) if one.kind is Kind.SIGNED else ""
    text = f"{_text(variant, lang, blanks=False)}<p>{_FIND.of(lang)}{escape(label(one, lang) + unit + way)}</p>"
    sort = "multichoice" if words else "numerical"
    question = _question(root, sort, variant, f"{variant.name} {one.key}", text, lang, only=one.key)
    _tell(question, "defaultgrade", "1")
    _tell(question, "hidden", "0")
    if words:
        _choices(question, words)
    else:
        _numbers(question, variant.worths[one.key], one, lang)


def _choices(question: xml.Element, words: tuple[str, ...]) -> None:
    for tag, said in (("single", "true"), ("shuffleanswers", "true"), ("answernumbering", "none")):
        _tell(question, tag, said)
    for n, said in enumerate(words):
        _answer(question, 0 if n else 100, escape(said), "html")


def _numbers(question: xml.Element, worths: tuple[Worth, ...], one: Graded, lang: Lang) -> None:
    for worth in worths:
        answer = _answer(question, worth.percent, plain_number(worth.value), "moodle_auto_format")
        _tell(answer, "tolerance", plain_number(worth.allowed))
        xml.SubElement(xml.SubElement(answer, "feedback", format="html"), "text").text = escape(worth.said.of(lang))
    unit = xml.SubElement(xml.SubElement(question, "units"), "unit")
    _tell(unit, "multiplier", "1")
    _tell(unit, "unit_name", written_unit(one.unit))
    for tag, said in (("unitgradingtype", "0"), ("unitpenalty", "0.1"), ("showunits", "3"), ("unitsleft", "0")):
        _tell(question, tag, said)


def _answer(question: xml.Element, percent: int, text: str, form: str) -> xml.Element:
    answer = xml.SubElement(question, "answer", fraction=str(percent), format=form)
    _tell(answer, "text", text)
    return answer


def _tell(parent: xml.Element, tag: str, text: str) -> None:
    xml.SubElement(parent, tag).text = text


def _written(root: xml.Element) -> bytes:
    xml.indent(root)
    return xml.tostring(root, encoding="unicode", xml_declaration=False).join((_HEAD, "\n")).encode()
