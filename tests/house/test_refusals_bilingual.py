"""Claims about what a refusal says: two languages at every place that raises one,
data before text, no foreign sentence."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

import vecpoly.errors
from tests.sources import HOUSE, nodes, sources, text
from vecpoly.errors import Fault, FaultError, Place, ProblemFileError, VecpolyError
from vecpoly.problem.load import loads
from vecpoly.words import Words

OURS = {
    name
    for name, thing in vars(vecpoly.errors).items()
    if isinstance(thing, type) and issubclass(thing, VecpolyError | FaultError)
} | {"MarkupError"}
SENTENCE = re.compile(r"\b[a-z]{3,} [a-z]{2,} [a-z]{2,} [a-z]{2,}\b")
WRITTEN = (
    "left of",
    "right of",
    "slides",
    "passes through",
    "runs in",
    "rolls",
    "turned",
    "touches",
    "on circle about",
    "deg from",
    "write",
)


def calls() -> Iterator[tuple[str, ast.Call]]:
    """Every call of one of our errors, with its file."""
    for path in sources():
        for node in nodes(text(path)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in OURS and node.args:
                yield str(path.relative_to(HOUSE)), node


def texts() -> Iterator[tuple[str, int, str, str]]:
    """The two faces of every Words(...) inside such a call: file, line, Chinese source, English source."""
    for file, call in calls():
        for node in ast.walk(call):
            if (
                isinstance(node, ast.Call)
                and isinstance(node.func, ast.Name)
                and node.func.id == "Words"
                and len(node.args) == 2
            ):
                yield file, node.lineno, ast.unparse(node.args[0]), ast.unparse(node.args[1])


def test_no_refusal_is_raised_in_one_language() -> None:
    found = list(calls())
    plain = [f"{file}:{call.lineno}" for file, call in found if isinstance(call.args[0], ast.JoinedStr | ast.Constant)]
    assert len(found) > 350 and not plain, plain


def test_the_chinese_of_a_refusal_is_chinese_and_its_english_is_not() -> None:
    found = list(texts())
    assert len(found) > 300
    for file, line, zh, en in found:
        assert not re.search(r"[\u4e00-\u9fff]", en.replace("C 在 AD 上方", "")), f"{file}:{line}: {en}"
        bare = re.sub(r"\{[^{}]*\}", "", zh)
        foreign = [part for part in SENTENCE.findall(bare) if not any(word in bare for word in WRITTEN)]
        assert not foreign, f"{file}:{line}: {foreign}"


def test_a_fault_is_data_before_it_is_text() -> None:
    text = (
        "id: a\ntitle: t\nframe: {A: [0 mm, 0 mm], D: [9 mm, 0 mm]}\nlinks:\n  1: {AB: 280}\n  2: {BC: 9 mm}\n"
        "  3: {CD: 9 mm}\ninput: {link: 1, phi: 9 deg, omega: 1 rad/s ccw}\n"
    )
    with pytest.raises(ProblemFileError) as caught:
        loads(text, "a.yaml")
    (fault,) = caught.value.faults
    assert fault.place == Place("a.yaml", 5, 7) and fault.path == ("links", "1", "AB") and fault.code == "no-unit"
    assert fault.numbers == {"written": "280"}
    assert fault.words == Words(
        "a.yaml 第 5 行第 7 列：links.1.AB：“280”没有单位，此处应为长度；如写 280 mm",
        "a.yaml, line 5, column 7: links.1.AB: '280' has no unit; a length is needed: write e.g. 280 mm",
    )
    assert fault.remedy.zh == "如写 280 mm" and str(caught.value) == fault.words.en
    assert fault.as_json()["line"] == 5 and fault.as_json()["path"] == "links.1.AB"


def test_a_refusal_led_by_the_name_of_a_problem_keeps_its_code_and_numbers() -> None:
    error = VecpolyError(Words("不行", "no"), code="some", numbers={"F": 2.0}).led_by(Words("3-9：", "3-9: "))
    assert (error.words.zh, str(error), error.code, error.numbers) == ("3-9：不行", "3-9: no", "some", {"F": 2.0})
    assert VecpolyError.of(Fault(said=Words("甲", "a")), Fault(said=Words("乙", "b"))).words == Words("甲\n乙", "a\nb")


def test_an_error_without_a_code_is_called_after_its_class() -> None:
    assert vecpoly.errors.DeadPointError(Words("死点", "dead")).code == "dead-point"
    assert vecpoly.errors.NoSlipSenseError(Words("无", "none")).code == "no-slip-sense"


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("AB: 40 mm", "AB: 40", "no-unit"),
        ("AB: 40 mm", "AB: 40 kg", "wrong-unit"),
        ("AB: 40 mm", "AB: 40 mmm", "unknown-unit"),
        ("AB: 40 mm", "AB: -40 mm", "out-of-range"),
        ("frame:", "fram:", "unknown-key"),
        ("title: t\n", "", "missing"),
        ("[v_C]", "[v_X]", "unknown-name"),
        ("[v_C]", "[ω²]", "unknown-symbol"),
        ("title: t\n", "title: t\ntitle: u\n", "duplicate-key"),
        ("[v_C]", "[v_C", "yaml"),
        ("[v_C]", "[v_C；a_C]", "full-width"),
        ("C above AD", "C upon AD", "spelling"),
        ("omega: 1 rad/s ccw", "omega: 1 rad/s ccw, s: 3 mm", "contradiction"),
        ("3: {CD: 80 mm}", "3: {CD: 80 mm}\n  4: {AD: 120 mm}", "frame-as-link"),
    ],
)
def test_each_kind_of_fault_has_its_code(old: str, new: str, code: str) -> None:
    text = (
        "id: a\ntitle: t\nframe: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}\nlinks:\n  1: {AB: 40 mm}\n"
        "  2: {BC: 100 mm}\n  3: {CD: 80 mm}\ninput: {link: 1, phi: 60 deg, omega: 1 rad/s ccw}\n"
        "branch: [C above AD]\nfind: [v_C]\n"
    )
    assert old in text and loads(text).id == "a"
    with pytest.raises(ProblemFileError) as caught:
        loads(text.replace(old, new))
    assert caught.value.code == code and code in {fault.code for fault in caught.value.faults}
