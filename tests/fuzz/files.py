"""Damaged files on disk, one after another at the same place."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import numpy as np

from tests.generators.family import families, member
from vecpoly.cycle import csv_bytes, cycle, table, xlsx_bytes
from vecpoly.foundation.data import data_dir
from vecpoly.problem.load import load

from .mutants import mutant


def good_files(rng: np.random.Generator, each: int) -> list[str]:
    """The problem files of the library,
    and so many members of each random family that is made without solving others."""
    made = [
        member(one, int(rng.integers(10**6)), n)
        for one in families()
        if not one.name.startswith(("retold", "asked", "library", "near-locking", "used"))
        for n in range(each)
    ]
    return [file.read_text(encoding="utf-8") for file in sorted(data_dir("problems").rglob("*.yaml"))] + made


def damaged_files(rng: np.random.Generator, count: int, path: Path) -> Iterator[str]:
    """Damaged problem files."""
    texts = good_files(rng, 3)
    for _ in range(count):
        path.write_bytes(mutant(rng, texts).encode("utf-8", "surrogatepass"))
        yield str(path)


def damaged_tables(rng: np.random.Generator, count: int, folder: Path) -> Iterator[str]:
    """Damaged tables of the cycle of A-27: texts as the problem files are, workbooks byte by byte."""
    made = table(cycle(load("A-27"), 25), ("omega_5", "alpha_5", "p_F"))
    text, book = csv_bytes(made).decode(), xlsx_bytes(made, "A-27", "en")
    for n in range(count):
        if n % 3:
            path, data = (
                folder / "t.csv",
                mutant(rng, [text, text.replace(",", ";"), text.replace(",", "\t")]).encode("utf-8", "surrogatepass"),
            )
        else:
            path, data = folder / "t.xlsx", damaged_bytes(rng, book)
        path.write_bytes(data)
        yield str(path)


def damaged_bytes(rng: np.random.Generator, data: bytes) -> bytes:
    """Some bytes are others, or the end is missing; of a file that is packed, now and then a text inside is damaged."""
    if data.startswith(b"PK") and rng.integers(2):
        return _repacked(rng, data)
    damaged = bytearray(data)
    for at in rng.integers(len(damaged), size=int(rng.integers(1, 12))):
        damaged[int(at)] = int(rng.integers(256))
    return bytes(damaged[: int(rng.integers(len(damaged)))] if rng.integers(4) == 0 else damaged)


def _repacked(rng: np.random.Generator, data: bytes) -> bytes:
    """One of the texts that are packed is damaged, all else is as it was."""
    out = BytesIO()
    with ZipFile(BytesIO(data)) as old, ZipFile(out, "w") as new:
        names = old.namelist()
        chosen = names[int(rng.integers(len(names)))]
        for name in names:
            inside = old.read(name)
            if name == chosen:
                inside = mutant(rng, [inside.decode("utf-8", "replace")]).encode("utf-8", "replace")
            new.writestr(name, inside)
    return out.getvalue()
