"""reportlab writes the same bytes whether its small functions are those in C or those in Python."""

from __future__ import annotations

import importlib.util
import sys
from types import ModuleType

import pytest
import reportlab.lib.rl_accel as used
from hypothesis import given
from hypothesis import strategies as st


@pytest.fixture(scope="module")
def in_python() -> ModuleType:
    """The module as it is where nothing is compiled."""
    spec = importlib.util.spec_from_file_location("rl_accel_in_python", used.__file__)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "_rl_accel", None)
        patch.setitem(sys.modules, "reportlab.lib._rl_accel", None)
        spec.loader.exec_module(module)
    assert module.fp_str is not used.fp_str
    return module


@given(numbers=st.lists(st.floats(-1e5, 1e5) | st.integers(-9999, 9999), min_size=1, max_size=6))
def test_numbers_are_written_alike(in_python: ModuleType, numbers: list[float]) -> None:
    assert used.fp_str(*numbers) == in_python.fp_str(*numbers)


@given(text=st.binary(max_size=40))
def test_strings_are_escaped_alike(in_python: ModuleType, text: bytes) -> None:
    assert used.escapePDF(text) == in_python.escapePDF(text)


@given(data=st.binary(max_size=64))
def test_tables_of_fonts_have_the_same_sums(in_python: ModuleType, data: bytes) -> None:
    assert used.calcChecksum(data) == in_python.calcChecksum(data)
