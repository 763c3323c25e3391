"""Claims about the text of a problem file: full-width signs, and what is said where it is no YAML."""

from __future__ import annotations

import pytest

from vecpoly.errors import ProblemFileError
from vecpoly.problem.load import loads
from vecpoly.problem.text.narrow import narrowed
from vecpoly.problem.text.source import parse
from vecpoly.problem.values.written import text_of

CHINESE = """id：wide
title：｛zh：曲柄滑块，机构：一，en：Slider-crank｝
statement：已知：AB = 30 mm，求 v_C（m/s）。
frame：｛A：［0 mm，0 mm］，D：[120　mm， 0 mm]｝
links：
  １：｛AB：40 mm｝
  2：{BC：100 mm，E：{along：BC，at：60 mm，left：40 mm}}
  3: ｛CD：80 mm｝
input：｛link：1，phi：６０°，omega：10 rad/s　逆时针｝
branch: 【C 在 AD 上方】
scales: {mu_v: 0.02 （m/s）/mm}
find：［v_E，a_E、omega_3］
"""


def test_a_file_typed_on_a_chinese_keyboard_is_the_same_problem() -> None:
    problem = loads(CHINESE)
    assert [ask.rel.key for ask in problem.asks] == ["v_E", "a_E", "omega_3"]
    assert problem.title.zh == "曲柄滑块，机构：一" and problem.statement.zh == "已知：AB = 30 mm，求 v_C（m/s）。"
    assert problem.mechanism.frame == {"A": 0j, "D": 0.12 + 0j} and problem.scales.given["mu_v"] == pytest.approx(0.02)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("tables: [表（1）.csv，b.csv]", "tables: [表（1）.csv,b.csv]"),
        ("loads: {M_1: {size: “?”}}", 'loads: {M_1: {size: "?"}}'),
        ("title: 【例 3-1】“四杆”机构", "title: 【例 3-1】“四杆”机构"),
        ("errata: [第一，二版误，第三版改]", "errata: [第一，二版误，第三版改]"),
        ("find: [v_E] # 注：求，速度", "find: [v_E] # 注：求，速度"),
        (
            '{\n "title": {"zh": "甲；乙。", "en"："b"},\n "find": ["v_E"，"a_E"]}',
            '{\n "title": {"zh": "甲；乙。", "en": "b"},\n "find": ["v_E","a_E"]}',
        ),
        (
            "loads：\n  M＿q０：｛on：1｝\nfriction： {3－4：{phi： 8 deg}}",
            "loads:\n  M_q0: {on: 1}\nfriction: {3-4: {phi: 8 deg}}",
        ),
        ("title: '甲：乙'\nbranch: ［C above AD］", "title: '甲：乙'\nbranch: [C above AD]"),
        ("title_block：｛课程：机械原理，班级：机械 21｝", "title_block: {课程: 机械原理,班级: 机械 21}"),
        ("statement:\n  zh：已知：a，b\n   续：c，d\n  en: x", "statement:\n  zh: 已知：a，b\n   续：c，d\n  en: x"),
    ],
)
def test_signs_are_narrowed_where_they_are_punctuation_and_nowhere_else(text: str, plain: str) -> None:
    assert narrowed(text, "x").text == plain


@pytest.mark.parametrize(
    ("text", "line", "column", "sign"),
    [
        ("id: a\nfind: [v_E；a_E]", 2, 11, "；"),
        ("input:\n  phi: 60 deg。", 2, 14, "。"),
        ("loads: {M: {size: ？}}", 1, 19, "？"),
        ("links：｛1：{AB：100！mm}｝", 1, 17, "！"),
        ("find: 《v_E》", 1, 7, "《"),
    ],
)
def test_a_sign_in_doubt_is_named_with_its_line_and_column(text: str, line: int, column: int, sign: str) -> None:
    with pytest.raises(ProblemFileError) as caught:
        narrowed(text, "x.yaml")
    fault = caught.value.faults[0]
    assert fault.place is not None and (fault.place.line, fault.place.column) == (line, column)
    assert fault.code == "full-width" and fault.numbers == {"sign": sign} and f"“{sign}”" in fault.words.zh


def test_columns_are_those_of_the_text_as_written() -> None:
    with pytest.raises(ProblemFileError) as caught:
        loads(CHINESE.replace("left：40 mm", "left：40"))
    (fault,) = caught.value.faults
    written = CHINESE.split("\n")[6]
    assert fault.place is not None and (fault.place.line, fault.place.column) == (7, written.index("E") + 1)


YAML = {
    "an open brace": ("frame: {A: [0 mm, 0 mm]\nlinks:\n  1: {AB: 4 mm}", 1, 8, "not closed", "没有用“}”闭合"),
    "an open bracket": ("find: [v_C, a_C\nlinks: {1: {AB: 3 mm}}", 1, 7, "not closed", "没有用“]”闭合"),
    "an inner bracket": ("frame: {A: [0 mm, 0 mm, D: [1 mm, 0 mm]}\nid: a", 1, 40, "']' is missing", "缺少“]”"),
    "one bracket too many": ("id: a\nfind: [v_B]]", 2, 12, "one too many", "多余的“]”"),
    "too deep": ("links:\n  1: {AB: 4 mm}\n   2: {BC: 1 mm}", 3, 4, "indented by 3 spaces", "缩进 3 个空格"),
    "too shallow": ("links:\n  1: {AB: 4 mm}\n 2: {BC: 1 mm}\n  3: {}", 3, 2, "indented by 1 space,", "缩进 1 个空格"),
    "a tab": ("links:\n\t1: {AB: 4 mm}", 2, 1, "a tab", "制表符"),
    "a bare question mark": ("loads: {M_1: {on: 1, size: ?}}", 1, 28, 'size: "?"', "问号要加引号"),
    "a bare question mark at the end of a line": (
        "loads:\n  M_1:\n    size: ?\n  F: 3",
        3,
        11,
        'size: "?"',
        "问号要加引号",
    ),
    "an open quote": ('id: a\ntitle: "abc\nfind: [v_C]', 2, 8, "not closed", "没有闭合"),
    "no colon": ("id: a\nlinks\n  1: {AB: 4 mm}", 2, 1, "': ' is missing", "缺少“: ”"),
    "no space": ("id: a\ntitle:b\nfind: [v_C]", 2, 6, "title: b", "冒号后缺少空格"),
    "no space in the first line": ("id:a\ntitle: b", 1, 3, "id: a", "冒号后缺少空格"),
    "a second colon": ("title: b: c", 1, 9, "second ':'", "第二个冒号"),
    "a missing comma": ("frame: {A: [0 mm, 0 mm] D: [1 mm, 0 mm]}", 1, 25, "a comma is missing", "缺少逗号"),
    "a sign that YAML keeps for itself": ("title: @b", 1, 8, "between quotes", "要加引号"),
    "two documents": ("id: a\n---\nid: b", 2, 1, "one problem", "只写一道题"),
}


@pytest.mark.parametrize("case", YAML)
def test_what_is_no_yaml_is_told_in_words_where_the_mistake_is(case: str) -> None:
    text, line, column, en, zh = YAML[case]
    with pytest.raises(ProblemFileError) as caught:
        parse(text, "x.yaml")
    (fault,) = caught.value.faults
    assert fault.place is not None and (fault.place.line, fault.place.column) == (line, column), str(caught.value)
    assert en in str(caught.value) and zh in caught.value.words.zh
    assert not any(word in str(caught.value) for word in ("mapping values", "block end", "flow", "scalar", "token"))


def test_a_problem_is_written_with_a_line_for_every_key_and_one_for_every_link_and_load() -> None:
    title, links = {"zh": "题", "en": "a problem"}, {"1": {"AB": "40 mm"}, "2": {"BC": "100 mm"}}
    written = text_of({"id": "t", "title": title, "links": links, "find": ["v_C"]}).splitlines()
    assert [line.partition(":")[0] for line in written] == ["id", "title", "links", "  1", "  2", "find"]


def test_keys_of_which_nothing_is_said_are_written_as_they_stand() -> None:
    for key in ("links", "loads", "masses", "friction"):
        assert text_of({"id": "t", key: None}).splitlines()[1] == f"{key}: null"
