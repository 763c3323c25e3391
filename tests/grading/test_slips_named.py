"""What a mistake was made with is called by the symbol that is printed, never by the key of a program."""

from __future__ import annotations

import re

import pytest

from tests.laws import few
from vecpoly import load, slips
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.grading.told.slip import said_of, symbol_of, told_of


@pytest.mark.parametrize(
    ("key", "symbol"),
    [
        ("gamma_min", "γ_{min}"),
        ("tan alpha", "tan α"),
        ("omega", "ω"),
        ("dW_max", "ΔW_{max}"),
        ("N_left", "N"),
        ("N_right", "N"),
        ("inversion", "−ω"),
        ("omega_3", "ω_{3}"),
        ("bc2", "bc2"),
        ("R_32", "R_{32}"),
        ("p_L", "p_{L}"),
        ("ak_C2C3", "a^k_{C2C3}"),
    ],
)
def test_a_key_is_printed_as_its_symbol(key: str, symbol: str) -> None:
    assert symbol_of(key) == symbol
    told = told_of(Slip(Mistake.REVERSED, f"force:{key}")).words
    assert f"${symbol}$" in told.zh and f"${symbol}$" in told.en


@pytest.mark.parametrize("name", few(["4-1", "5-5", "8-3b", "engine-three", "cam-rocker", "rotor-grade"], 2))
def test_no_mistake_with_a_device_is_told_with_a_word_in_its_chinese(name: str) -> None:
    told = [said_of(slip).zh for slip in slips(load(name))]
    words = {word for text in told for word in re.findall(r"[A-Za-z]{4,}", text)}
    assert told and words <= {"perI", "perII", "arctan", "arcsin", "arccos"}
