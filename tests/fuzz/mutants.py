"""Damaged copies of good texts: characters, tokens, lines, units, numbers, structure, pieces of one file in another."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import numpy as np

Rng = np.random.Generator
Mutation = Callable[[Rng, str, Sequence[str]], str]

_ODD = (
    "\0",
    "\x1b",
    "\u202e",
    "\u200b",
    "，",
    "：",
    "【",
    "\t",
    "'",
    '"',
    "{",
    "}",
    "[",
    "]",
    "#",
    "&",
    "*",
    "!",
    "|",
    ">",
    "%",
    "@",
    "\\",
    "\n",
    "\r",
    "-",
    "?",
    "℃",
    "𝜔",
    "é",
)
_VALUES = (
    "",
    "null",
    "~",
    "[]",
    "{}",
    "0",
    "-1",
    "1e308",
    "1e-308",
    "nan",
    "inf",
    "?",
    "1 mm",
    "0 mm",
    "-5 mm",
    "1e19 m",
    "1e-19 m",
    "75 rad",
    "360 deg",
    "1e5 rad/s",
    "true",
    "yes",
    "BB",
    "A",
    "Z",
    "AB",
    "centres",
    "auto",
    "'",
    "[1, 2, 3]",
    "{a: b}",
    "2024-01-01",
    "0x10",
    "1_000",
    "100 %",
    "x" * 150,
    "m*" * 60 + "m",
    "80 m^999",
    "5 m^-9",
)
_UNITS = (
    "mm",
    "m",
    "km",
    "deg",
    "rad",
    "rad/s",
    "r/min",
    "m/s",
    "m/s^2",
    "N",
    "N*m",
    "kg",
    "s",
    "",
    "m^9",
    "(m/s)/mm",
    "°",
    "毫米",
    "parsec",
    "mm/mm",
)
_TOKEN = re.compile(r"[A-Za-z_]+\d*|\d+\.?\d*(?:e[-+]?\d+)?|[^\w\s]")
_QUANTITY = re.compile(r"(-?\d+\.?\d*)\s*(mm|cm|m|deg|rad/s\^?2?|r/min|m/s\^?2?|N\*m|N|kg|kW|rpm)\b")


def pick(rng: Rng, items: Sequence[str]) -> str:
    """One of them."""
    return items[int(rng.integers(len(items)))]


def character(rng: Rng, text: str, _: Sequence[str]) -> str:
    """A character is lost, doubled or becomes another."""
    at = int(rng.integers(len(text)))
    return text[:at] + pick(rng, ("", text[at] * 2, *_ODD)) + text[at + 1 :]


def token(rng: Rng, text: str, _: Sequence[str]) -> str:
    """Two words change places, or one is lost or becomes the other."""
    found = list(_TOKEN.finditer(text))
    one, other = (found[int(i)] for i in rng.integers(len(found), size=2))
    new = pick(rng, ("", other[0], one[0] + other[0], one[0] * 3))
    return text[: one.start()] + new + text[one.end() :]


def line(rng: Rng, text: str, _: Sequence[str]) -> str:
    """A line is lost, doubled, moved or indented otherwise."""
    lines = text.splitlines(keepends=True)
    at, to = (int(i) for i in rng.integers(len(lines), size=2))
    kept = [*lines[:at], *lines[at + 1 :]]
    match int(rng.integers(4)):
        case 0:
            return "".join(kept)
        case 1:
            return "".join([*lines[:to], lines[at], *lines[to:]])
        case 2:
            return "".join([*kept[:to], lines[at], *kept[to:]])
        case _:
            return "".join([*lines[:at], pick(rng, (" ", "  ", "\t", "- ")) + lines[at], *lines[at + 1 :]])


def value(rng: Rng, text: str, _: Sequence[str]) -> str:
    """What stands behind a colon becomes something else."""
    found = list(re.finditer(r":[ ]*([^,{}\[\]\n]+)", text))
    if not found:
        return character(rng, text, ())
    one = found[int(rng.integers(len(found)))]
    return text[: one.start(1)] + pick(rng, _VALUES) + text[one.end(1) :]


def quantity(rng: Rng, text: str, _: Sequence[str]) -> str:
    """A number or a unit becomes another."""
    found = list(_QUANTITY.finditer(text))
    if not found:
        return value(rng, text, ())
    one = found[int(rng.integers(len(found)))]
    number = pick(
        rng, (one[1], "0", f"{-float(one[1]):g}", f"{float(one[1]) * 10.0 ** int(rng.integers(-15, 16)):g}", one[1] * 3)
    )
    return text[: one.start()] + f"{number} {pick(rng, (one[2], *_UNITS))}" + text[one.end() :]


def letter(rng: Rng, text: str, _: Sequence[str]) -> str:
    """A point's letter becomes that of another, everywhere or once."""
    letters = sorted(set(re.findall(r"\b[A-Z]\b|(?<=[_\s{])[A-Z](?=[A-Z]\b)", text)))
    if len(letters) < 2:
        return token(rng, text, ())
    return re.sub(pick(rng, letters), pick(rng, letters), text, count=int(rng.integers(0, 3)))


def splice(rng: Rng, text: str, others: Sequence[str]) -> str:
    """Top-level entries of another file are laid in."""
    entries = re.split(r"(?m)^(?=\w+:)", pick(rng, others))
    mine = re.split(r"(?m)^(?=\w+:)", text)
    new = pick(rng, entries)
    key = new.partition(":")[0]
    kept = [entry for entry in mine if entry.partition(":")[0] != key]
    return "".join([*kept, new if new.endswith("\n") else new + "\n"])


MUTATIONS: tuple[Mutation, ...] = (character, token, line, value, quantity, letter, splice)


def mutant(rng: Rng, texts: Sequence[str]) -> str:
    """One text, damaged one to three times."""
    text = pick(rng, texts)
    for _ in range(int(rng.integers(1, 4))):
        if text.strip():
            text = MUTATIONS[int(rng.integers(len(MUTATIONS)))](rng, text, texts)
    return text
