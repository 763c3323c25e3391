"""The text of what was found tells a value behind a symbol with an equals sign."""

from __future__ import annotations

from vecpoly.search.base import Measure
from vecpoly.search.run import _said
from vecpoly.words import Words


def test_a_value_stands_behind_its_symbol_with_an_equals_sign_and_behind_a_name_without() -> None:
    measures = [
        Measure(name=Words("行程速比系数 K", "time ratio K"), value=1.3, unit=""),
        Measure(name=Words("摆角", "swing"), value=30.0, unit="deg"),
    ]
    said = _said(measures, 20000)
    assert said.zh == "由 20000 个候选中搜索得到：行程速比系数 K = 1.3，摆角 30°。"
    assert said.en == "Found among 20000 candidates: time ratio K = 1.3, swing 30°."
