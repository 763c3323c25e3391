"""What Moodle's importer makes of a file of questions, and what it refuses: an own reading of how `qformat_xml`,
`qtype_numerical` and `qtype_multianswer` behave (Moodle 5), with "stop on error" and grades that must match."""

from __future__ import annotations

import re
import xml.etree.ElementTree as xml
from base64 import b64decode
from collections.abc import Iterator
from dataclasses import dataclass
from html import unescape

FRACTIONS = (
    100, 90, 83.33333, 80, 75, 70, 66.66667, 60, 50, 40, 33.33333, 30, 25, 20, 16.66667, 14.28571, 12.5, 11.11111, 10,
    5, 0,
)  # fmt: skip
FORMATS = ("html", "moodle_auto_format", "plain_text", "markdown")
LONGEST = {"name": 255, "idnumber": 100, "category": 255}  # characters that its tables hold
_NUMBER = r"-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?"
_SIMPLE = re.compile(rf"({_NUMBER})(?::({_NUMBER}))?")
_ONE = r"(?:=|%-?[0-9]+(?:[.,][0-9]*)?%)?.+?(?<!\\|&)(?<!&amp;)(?=[~#}]|$)(?:#.*?(?<!\\)(?=[~}]|$))?"
_PARTS = re.compile(
    r"~?(=|%(-?[0-9]+(?:[.,][0-9]*)?)%)?(.+?(?<!\\|&)(?<!&amp;)(?=[~#}]|$))(#(.*?(?<!\\)(?=[~}]|$)))?", re.S
)
_SORTS = "NUMERICAL|NM|MULTICHOICE_S|MCS|MULTICHOICE|MC|SHORTANSWER|SA"
_BLANK = re.compile(rf"\{{([0-9]*):({_SORTS}):({_ONE}(?:~{_ONE})*)\}}", re.S)
_IMAGE = re.compile(r'src="@@PLUGINFILE@@/([^"]+)"')


class RefusedError(Exception):
    """Moodle does not take it."""


@dataclass(frozen=True, slots=True)
class Answer:
    """One answer: text, share of the mark (per cent), tolerance of a number, what is said."""

    text: str
    percent: float
    tolerance: float = 0.0
    said: str = ""


@dataclass(frozen=True, slots=True)
class Asked:
    """A question, or a blank of one: what sort, what it weighs, its answers in the order in which they are tried."""

    sort: str
    weight: float
    answers: tuple[Answer, ...]

    def mark(self, typed: str) -> float:
        """Per cent of its mark for what is typed, the first answer that fits."""
        if self.sort == "multichoice":
            return next((one.percent for one in self.answers if one.text == typed), 0.0)
        value = float(typed)
        return next((one.percent for one in self.answers if abs(value - float(one.text)) <= one.tolerance), 0.0)


@dataclass(frozen=True, slots=True)
class Question:
    """name, idnumber, category; text: with {#1} for each blank; parts: the question itself, or its blanks."""

    name: str
    idnumber: str
    category: str
    text: str
    parts: tuple[Asked, ...]
    files: tuple[str, ...]


def imported(data: bytes) -> tuple[Question, ...]:
    """The questions of a file. Raises RefusedError where Moodle would not take it, or would silently change it."""
    root = xml.fromstring(data.decode("utf-8"))
    _must(root.tag == "quiz" and not data.startswith(b"\xef\xbb\xbf"), "no quiz")
    found, category, known = list[Question](), "", set[tuple[str, str]]()
    for element in root:
        _must(element.tag == "question", f"<{element.tag}>")
        if element.get("type") == "category":
            category = _category(element)
            continue
        one = _question(element, category)
        _must(
            (category, one.idnumber) not in known, f"idnumber {one.idnumber} twice in {category}: it would be dropped"
        )
        known.add((category, one.idnumber))
        found.append(one)
    return tuple(found)


def _must(held: bool, why: str) -> None:
    if not held:
        raise RefusedError(why)


def _text(parent: xml.Element | None, path: str) -> str:
    """A text node, trimmed; nothing may stand in it but text."""
    node = None if parent is None else parent.find(path)
    if node is None:
        return ""
    _must(len(node) == 0, f"elements inside {path}")
    return (node.text or "").strip()


def _category(element: xml.Element) -> str:
    path = _text(element, "category/text")
    names = re.split(r"(?<!/)/(?!/)", path)
    _must(names[:2] == ["$course$", "top"] and len(names) > 2, f"category {path}")
    _must(all(0 < len(name.strip()) <= LONGEST["category"] for name in names), f"category {path}")
    return path


def _question(element: xml.Element, category: str) -> Question:
    sort = element.get("type", "")
    name, number = _text(element, "name/text"), _text(element, "idnumber")
    _must(0 < len(name) <= LONGEST["name"] and not re.search(r"<[A-Za-z/]", name), f"name {name}")
    _must(0 < len(number) <= LONGEST["idnumber"], f"idnumber {number}")
    _must(bool(category), f"{name} stands in no category")
    body = element.find("questiontext")
    for each in element.iter():
        _must(each.get("format", "html") in FORMATS, f"format {each.get('format')}")
    text, files = _text(body, "text"), tuple(_files(body))
    _must(bool(text), f"{name} asks nothing")
    _must(set(_IMAGE.findall(text)) == set(files), f"pictures of {name}: {_IMAGE.findall(text)}, {files}")
    _must(re.fullmatch(r"0(\.\d+)?|1(\.0+)?", _text(element, "penalty") or "0") is not None, "penalty")
    if sort == "cloze":
        text, parts = cloze(text)
    else:
        parts = (_alone(element, sort),)
    return Question(name, number, category, text, parts, files)


def _files(body: xml.Element | None) -> Iterator[str]:
    for file in body.findall("file") if body is not None else ():
        _must(file.get("encoding") == "base64" and file.get("path", "/").endswith("/"), "file")
        data = b64decode(file.text or "", validate=True)
        _must(xml.fromstring(data).tag.endswith("svg"), "the picture is none")
        yield file.get("name", "")


# -- numerical, multichoice ---------------------------------------------------------------------------------------


def _alone(element: xml.Element, sort: str) -> Asked:
    _must(sort in ("numerical", "multichoice"), f"type {sort}")
    answers = tuple(_answer(one, sort) for one in element.findall("answer"))
    _must(any(one.percent == 100 for one in answers), "no answer is worth all")
    _must(sort == "numerical" or len(answers) > 1, "a choice of one")
    _must(sort == "numerical" or _text(element, "single") == "true", "single")
    if sort == "numerical":
        names = [_text(unit, "unit_name") for unit in element.iterfind("units/unit")]
        _must(len(set(names)) == len(names), "a unit twice")
        _must(not any(re.search(r"^[\d.,eE+-]", name) for name in names), f"a unit that begins as a number: {names}")
        for tag, allowed in (("unitgradingtype", "012"), ("showunits", "0123"), ("unitsleft", "01")):
            _must(_text(element, tag) in tuple(allowed), tag)
    return Asked(sort, float(_text(element, "defaultgrade") or 1), answers)


def _answer(one: xml.Element, sort: str) -> Answer:
    percent = float(one.get("fraction", "0"))
    _must(any(abs(abs(percent) - known) < 1e-3 for known in FRACTIONS), f"fraction {percent}")
    text, said = _text(one, "text"), _text(one, "feedback/text")
    if sort == "multichoice":
        return Answer(unescape(text), percent, said=said)
    tolerance = _text(one, "tolerance")
    _must(re.fullmatch(_NUMBER, text) is not None, f"no number: {text}")
    _must(re.fullmatch(_NUMBER, tolerance) is not None and float(tolerance) >= 0, f"tolerance {tolerance}")
    return Answer(text, percent, float(tolerance), said)


# -- cloze ---------------------------------------------------------------------------------------------------------


def cloze(text: str) -> tuple[str, tuple[Asked, ...]]:
    """The text with a mark for each blank, and the blanks."""
    parts: list[Asked] = []
    while (found := _BLANK.search(text)) is not None:
        parts.append(_blank(found))
        text = f"{text[: found.start()]}{{#{len(parts)}}}{text[found.end() :]}"
    _must(bool(parts), "no blank")
    rest = re.sub(r"\{#\d+\}", "", text)
    _must(
        re.search(r"\{[^{}]*:|[A-Z]{2,}:[=%]|\}\s*\}", rest) is None,
        f"what looks like a blank stays as text: {rest[:300]}",
    )
    return text, tuple(parts)


def _blank(found: re.Match[str]) -> Asked:
    sort = "numerical" if found[2] in ("NUMERICAL", "NM") else "multichoice"
    answers, left = list[Answer](), found[3]
    while left:
        one = _PARTS.match(left)
        _must(one is not None and bool(one[0]), f"not taken apart: {left[:100]}")
        assert one is not None
        answers.append(_option(one, sort))
        left = left[one.end() :]
    _must(any(one.percent == 100 for one in answers), "no answer of a blank is worth all")
    _must(sort == "numerical" or len(answers) > 1, "a choice of one")
    return Asked(sort, float(found[1] or 1), tuple(answers))


def _option(one: re.Match[str], sort: str) -> Answer:
    percent = 100.0 if one[1] == "=" else float((one[2] or "0").replace(",", "."))
    _must(any(abs(abs(percent) - known) < 1e-3 for known in FRACTIONS), f"fraction {percent}")
    said = unescape(one[5] or "").replace("\\}", "}").replace("\\#", "#")
    if sort == "multichoice":
        return Answer(unescape(one[3]).replace("\\}", "}").replace("\\#", "#"), percent, said=said)
    number = _SIMPLE.fullmatch(one[3])
    _must(number is not None, f"no number in a blank: {one[3]}")
    assert number is not None
    return Answer(number[1], percent, float(number[2] or 0), said)
