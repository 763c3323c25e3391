"""The small XML in which report templates are written, read into flowables."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import inf
from typing import Any, NoReturn
from xml.parsers import expat

from reportlab.platypus.flowables import PageBreak

from ...board.construction import EquationTable
from ...errors import VecpolyError
from ...tagging.tag import Role, Tag
from ...words import Lang, Words
from .base import Block
from .blocks import KINDS, Callout, Divider, Drawing, Heading, Plate, SheetPage, Subheading
from .contents import Contents
from .cover import Cover, TitleBlock
from .equation import EquationFlow
from .formula import Formula, in_columns
from .para import Para, numbered
from .results.illustrated import illustrated
from .style import CAPTION, NOTE
from .table import DataTable


class MarkupError(VecpolyError, ValueError):
    """Report markup that cannot be read: line, tag, cause."""


@dataclass(slots=True)
class Element:
    """One element of the markup."""

    tag: str
    attributes: dict[str, str]
    line: int
    text: str = ""
    children: list[Element] = field(default_factory=list)


def parse(xml: str) -> Element:
    """The root element; positions are kept for messages."""
    parser = expat.ParserCreate()
    stack: list[Element] = [Element("", {}, 0)]

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, parser.CurrentLineNumber)
        stack[-1].children.append(element)
        stack.append(element)

    def text(data: str) -> None:
        stack[-1].text += data

    def doctype(*_: object) -> None:
        raise MarkupError(
            Words(
                f"第 {parser.CurrentLineNumber} 行：不允许文档类型声明",
                f"line {parser.CurrentLineNumber}: a document type declaration is not allowed",
            )
        )

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: stack.pop()
    parser.CharacterDataHandler = text
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(xml, True)
    except expat.ExpatError as error:
        raise MarkupError(
            Words(
                f"第 {error.lineno} 行：XML 语法错误（{expat.ErrorString(error.code)}）",
                f"line {error.lineno}: {expat.ErrorString(error.code)}",
            )
        ) from None
    return stack[0].children[0]


def to_flowables(xml: str, objects: Mapping[str, object], lang: Lang | None = None) -> list[Any]:
    """The flowables of a ``<doc>``; ``ref`` attributes name things in `objects`."""
    root = parse(xml)
    if root.tag != "doc":
        _fail(root, Words("最外层元素应为 <doc>", "the outermost element must be <doc>"))
    return _Reader(objects, lang or _lang(root)).read(root)


def _lang(root: Element) -> Lang:
    return "en" if root.attributes.get("lang") == "en" else "zh"


def _fail(element: Element, cause: Words) -> NoReturn:
    raise MarkupError(
        Words(f"第 {element.line} 行：<{element.tag}>：", f"line {element.line}: <{element.tag}>: ") + cause
    )


class _Reader:
    """Reads elements in one language."""

    def __init__(self, objects: Mapping[str, object], lang: Lang) -> None:
        self._objects, self._lang = objects, lang
        self._list: Tag | None = None  # the list that goes on where steps follow steps
        self._readers: dict[str, Callable[[Element], list[Any]]] = {
            "h1": self._heading, "h2": self._heading, "h3": self._heading,
            "h4": lambda e: [Subheading(_text(e), lang)],
            "p": self._paragraph,
            "note": lambda e: [Para(_text(e), NOTE, lang)],
            "caption": lambda e: [Para(_text(e), CAPTION, lang)],
            "formula": self._formula, "equation": self._equation,
            "figure": self._block, "table": self._block, "answer": self._block, "sheet": self._sheet,
            "titleblock": self._titleblock, "steps": self._steps, "callout": self._callout,
            "cover": self._cover, "contents": lambda e: [Contents(lang)],
            "pagebreak": lambda e: [PageBreak()], "rule": lambda e: [Divider()],
        }  # fmt: skip

    def read(self, parent: Element) -> list[Any]:
        """The flowables of all children."""
        out: list[Any] = []
        if parent.text.strip():
            _fail(
                parent,
                Words(
                    "文字应写在 <p>、标题、<note>、<callout> 或 <step> 中",
                    "text must stand in <p>, a heading, <note>, <callout> or <step>",
                ),
            )
        for child in parent.children:
            self._list = self._list if child.tag == "steps" else None
            reader = self._readers.get(child.tag)
            if reader is None:
                _fail(
                    child,
                    Words(
                        f"未知元素；已有 {', '.join(sorted(self._readers))}",
                        f"unknown; known are {', '.join(sorted(self._readers))}",
                    ),
                )
            if child.tag == "answer" and isinstance(out[-1] if out else None, Block) and out[-1].tag.within is not None:
                out[-1].keepWithNext = 1  # the box of answers stands with the last step
            out.extend(reader(child))
        in_columns(out)
        return illustrated(out)

    def _paragraph(self, element: Element) -> list[Any]:
        para = Para(_text(element), None, self._lang)
        para.keepWithNext = int(element.attributes.get("keep") == "yes")
        return [para]

    def _heading(self, element: Element) -> list[Any]:
        return [Heading(_text(element), int(element.tag[1]), self._lang)]

    def _lookup(self, element: Element, kind: type | tuple[type, ...], what: str) -> Any:
        ref = element.attributes.get("ref")
        if ref is None:
            _fail(element, Words("缺少 ref", "needs a ref"))
        if ref not in self._objects:
            _fail(element, Words(f"没有名为“{ref}”的对象", f"nothing is named '{ref}'"))
        found = self._objects[ref]
        if not isinstance(found, kind):
            _fail(
                element,
                Words(
                    f"“{ref}”是 {type(found).__name__}，不是 {what}", f"'{ref}' is a {type(found).__name__}, not {what}"
                ),
            )
        return found

    def _formula(self, element: Element) -> list[Any]:
        found = self._lookup(element, object, "a formula")
        number = element.attributes.get("number", "")
        return [found if isinstance(found, Block) else Formula(found, number)]

    def _equation(self, element: Element) -> list[Any]:
        found = self._lookup(element, (EquationTable, Block), "an equation table")
        return [found if isinstance(found, Block) else EquationFlow(found, self._lang)]

    def _block(self, element: Element) -> list[Any]:
        found = self._lookup(element, Block, "a flowable")
        if isinstance(found, DataTable):
            found.whole = element.attributes.get("whole") in ("yes", "page")
            found.undivided = inf if element.attributes.get("whole") == "page" else found.undivided
        return [found]

    def _sheet(self, element: Element) -> list[Any]:
        return [self._lookup(element, (SheetPage, Plate), "a sheet page")]

    def _titleblock(self, element: Element) -> list[Any]:
        for child in element.children:
            if child.tag != "field" or "label" not in child.attributes:
                _fail(
                    child, Words("标题栏由 <field label= value=/> 组成", "a title block holds <field label= value=/>")
                )
        fields = [(c.attributes["label"], c.attributes.get("value", "")) for c in element.children]
        return [TitleBlock(fields)]

    def _cover(self, element: Element) -> list[Any]:
        fields = [
            (c.attributes["label"], c.attributes.get("value", ""))
            for c in element.children
            if c.tag == "field" and "label" in c.attributes
        ]
        figure = self._lookup(element, Drawing, "a figure") if element.attributes.get("ref") else None
        get = element.attributes.get
        return [Cover(get("kind", ""), get("title", ""), get("subtitle", ""), fields, figure)]

    def _steps(self, element: Element) -> list[Any]:
        out: list[Any] = []
        steps = self._list or Tag(Role.LIST, attributes="/A<</O/List/ListNumbering/Decimal>>")
        for i, child in enumerate(element.children, 1):
            if child.tag != "step":
                _fail(child, Words("<steps> 由 <step n=> 组成", "steps hold <step n=>"))
            number = child.attributes.get("n", str(i))
            sentence = numbered(f"{number}.", _plain(child), self._lang)
            sentence.keepWithNext = int(bool(child.children))
            body = Tag(Role.BODY, item := Tag(Role.ITEM, steps))
            sentence.put_in_list(item, body)
            out.append(sentence)
            for block in self.read(Element("step", {}, child.line, "", child.children)):
                block.put_within(body)
                block.keepWithNext = 1
                out.append(block)
            out[-1].keepWithNext = 0
        self._list = steps
        return out

    def _callout(self, element: Element) -> list[Any]:
        kind = element.attributes.get("kind", "note")
        if kind not in KINDS:
            _fail(
                element,
                Words(f"kind“{kind}”不在 {', '.join(KINDS)} 之中", f"kind '{kind}' is none of {', '.join(KINDS)}"),
            )
        return [Callout(_text(element), kind, self._lang)]


def _text(element: Element) -> str:
    if element.children:
        _fail(
            element.children[0],
            Words(f"<{element.tag}> 之内不能再有元素", f"no element may stand inside <{element.tag}>"),
        )
    return _plain(element)


def _plain(element: Element) -> str:
    """The text with its blanks folded; an ideographic space is kept."""
    return re.sub(r"[ \t\r\n]+", " ", element.text).strip(" ")
