"""Claims about the brackets of a content stream: marked content, text and graphics states nest, and all are closed."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from typing import Any

import pikepdf
import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import sym
from vecpoly.report.document import markup
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.formula import Formula
from vecpoly.report.flow.para import Para
from vecpoly.report.flow.xml import to_flowables
from vecpoly.words import Lang

CLOSES = {"EMC": "BMC", "ET": "BT", "Q": "q"}
META = Metadata(title="t", subject="t", keywords=(), lang="zh")
LETTERED = "3-4b"  # the image of the triangle BDC
NAMES = tuple(dict.fromkeys((LETTERED, *few(IDS, 48))))


def streams(data: bytes) -> Iterator[Any]:
    """The content of every page and of every form."""
    pdf = pikepdf.open(BytesIO(data))
    yield from pdf.pages
    for one in pdf.objects:
        if isinstance(one, pikepdf.Stream) and one.get("/Subtype") == "/Form":
            yield one


def unpaired(stream: Any) -> list[str]:
    """The operators that close what is not open innermost, and those that open what is not closed."""
    bad, stack = list[str](), list[str]()
    for one in pikepdf.parse_content_stream(stream):
        name = str(one.operator)
        if name in ("BDC", "BMC", "BT", "q"):
            stack.append("BMC" if name == "BDC" else name)
        elif name in CLOSES and (not stack or stack.pop() != CLOSES[name]):
            bad.append(name)
    return bad + stack


def faults(data: bytes) -> list[str]:
    return [fault for one in streams(data) for fault in unpaired(one)]


@each(NAMES)
def test_what_is_opened_in_a_content_stream_is_closed_in_it_and_in_order(name: str) -> None:
    lang: Lang = "zh" if len(name) % 2 else "en"
    document, objects = markup([drawn(name).solution], lang, "solution", {}, None, None)
    assert faults(ReportDoc(to_flowables(document, objects.named, lang), META).made()[0]) == []


@pytest.mark.parametrize("letters", ["BDC", "BMC", "EMC", "BT", "ET"])
def test_a_link_may_have_the_letters_of_an_operator(letters: str) -> None:
    story = [
        Formula(sym(f"l_{{{letters}}}")),
        Para(f"the length $l_{{{letters}}} = μ_l {letters}$ of a link", lang="en"),
    ]
    assert faults(ReportDoc(story, META).made()[0]) == []


def test_an_operator_that_closes_too_much_is_told() -> None:
    pdf = pikepdf.new()
    for content, told in ((b"BT EMC ET", ["EMC"]), (b"/P BMC q EMC Q", ["EMC", "Q"]), (b"/P BMC", ["BMC"])):
        assert unpaired(pdf.make_stream(content))[: len(told)] == told
