"""Claims about the report's markup."""

from __future__ import annotations

import re
from pathlib import Path

import pdfplumber
import pytest

from vecpoly.algebra.formula import Row, Txt, Vec, sym
from vecpoly.board.construction import EquationTable
from vecpoly.report.flow import DataTable, Drawing, MarkupError, Metadata, ReportDoc, SheetPage, to_flowables
from vecpoly.words import Words

TABLE = EquationTable(
    symbols=("v_C", "v_B"), signs=("", "="), directions=(Words("⊥$CD$", "⊥$CD$"),) * 2, magnitudes=("?", "✓")
)
XML = """<doc title="作业" lang="zh">
<h1>报告</h1><titleblock><field label="班级" value="机械1班"/><field label="姓名"/></titleblock>
<h2>题目</h2><p>由 $v_B$ 得 **解** a &lt; b</p><note>注</note>
<equation ref="e"/><formula ref="f"/><table ref="t"/><figure ref="d"/>
<steps><step n="1">作图</step><step n="2">量取<formula ref="f"/></step></steps>
<callout kind="pass">合格</callout><pagebreak/><p>末</p><sheet ref="s"/></doc>"""


def objects() -> dict[str, object]:
    return {
        "e": TABLE,
        "f": Row((Vec(sym("v_C")), Txt(" = 3 m/s"))),
        "t": DataTable(("量",), [("1",)]),
        "d": Drawing(10, 10, lambda c, x, y: None),
        "s": SheetPage(lambda c, x, y: None),
    }


def test_markup_becomes_flowables(tmp_path: Path) -> None:
    story = to_flowables(XML.replace('量取<formula ref="f"/>', "量取"), objects())
    kinds = [type(item).__name__ for item in story]
    assert kinds == [
        "Heading", "TitleBlock", "Heading", "Para", "Para", "EquationFlow", "Formula", "DataTable", "Drawing",
        "Para", "Para", "Callout", "PageBreak", "Para", "SheetPage",
    ]  # fmt: skip
    written = ReportDoc(story, Metadata(title="作业")).write(tmp_path / "a.pdf")
    with pdfplumber.open(written.path) as pdf:
        found = [re.sub(r"\s", "", page.extract_text() or "") for page in pdf.pages]
    assert len(found) == written.pages == 3
    assert "a<b" in found[0]


def test_a_step_may_hold_its_formula() -> None:
    assert "Formula" in [type(item).__name__ for item in to_flowables(XML, objects())[10:13]]


@pytest.mark.parametrize(
    ("xml", "words"),
    [
        ("<doc>\n<blink>x</blink></doc>", ("line 2", "blink")),
        ("<doc>\n\n<formula ref='zz'/></doc>", ("line 3", "zz")),
        ("<doc><p>a", ("line 1",)),
        ("<doc>\n<callout kind='x'>a</callout></doc>", ("line 2", "kind")),
        ("<doc>\n<p>a<b>c</b></p></doc>", ("line 2", "<b>")),
        ("<doc>text</doc>", ("line 1", "text")),
        ("<!DOCTYPE doc><doc/>", ("line 1", "document type")),
        ("<book/>", ("line 1", "doc")),
    ],
)
def test_wrong_markup_is_refused_by_tag_and_line(xml: str, words: tuple[str, ...]) -> None:
    with pytest.raises(MarkupError) as caught:
        to_flowables(xml, {})
    for word in words:
        assert word in str(caught.value)
