"""What one shard of a class made: a line for each sheet, with its seeds, the digests of its values and files."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from ...errors import VecpolyError
from ...foundation.files import write_whole
from ...words import Words
from ..register import Register, Sheet
from ..student import Student
from .store import FOLDER, digest, file_digest
from .tasks import question_file, solution_file

SHARDS = f"{FOLDER}/shards"


@dataclass(frozen=True, slots=True, kw_only=True)
class Head:
    """Of which class, by which program, for which roster; which shard of how many."""

    vecpoly: str
    assignment: str
    salt: str
    lang: str
    roster: str
    problems: str
    shard: int
    of: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Line:
    """One student: seeds by problem, digests of the values and of each file; or what went wrong."""

    number: str
    sheet: str
    seeds: Mapping[str, str]
    values: str
    layout: str
    files: Mapping[str, str]
    error: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Manifest:
    """A shard that was read back; folder: where its files lie."""

    folder: Path
    head: Head
    lines: tuple[Line, ...]

    @property
    def name(self) -> str:
        """3/8."""
        return f"{self.head.shard}/{self.head.of}"


def roster_digest(students: Sequence[Student]) -> str:
    """Of whoever is on the roster, in whatever order."""
    return digest([asdict(one) for one in sorted(students, key=lambda one: one.number)])


def write_manifest(
    out: Path, register: Register, roster: str, shard: tuple[int, int], failed: Mapping[str, VecpolyError]
) -> Path:
    """Write .work/shards/3-of-8.jsonl; the register holds the sheets of the shard, with their layouts."""
    problems = digest([[one.id, one.fingerprint] for one in register.exercises])
    head = Head(
        vecpoly=register.vecpoly, assignment=register.assignment, salt=register.salt, lang=register.lang,
        roster=roster, problems=problems, shard=shard[0], of=shard[1],
    )  # fmt: skip
    rows = [asdict(head), *(asdict(_line(out, register, sheet)) for sheet in register.sheets)]
    rows += [asdict(_failed(number, error)) for number, error in sorted(failed.items())]
    text = "".join(json.dumps(row, ensure_ascii=False, sort_keys=True) + "\n" for row in rows)
    return write_whole(out / SHARDS / f"{shard[0]}-of-{shard[1]}.jsonl", text.encode())


def values_digest(sheet: Sheet) -> str:
    """Of all that was drawn for a student."""
    return digest([[one.problem, one.attempt, dict(one.values), dict(one.scales)] for one in sheet.parts])


def _line(out: Path, register: Register, sheet: Sheet) -> Line:
    seeds = {
        part.problem: "|".join(
            (register.assignment, part.problem, sheet.student.number, register.salt, str(part.attempt))
        )
        for part in sheet.parts
    }
    names = question_file(sheet.student), solution_file(sheet.student)
    return Line(
        number=sheet.student.number, sheet=sheet.sheet, seeds=seeds, values=values_digest(sheet),
        layout=sheet.layout_hash, files={name: file_digest(out / name) for name in names},
    )  # fmt: skip


def _failed(number: str, error: VecpolyError) -> Line:
    return Line(number=number, sheet="", seeds={}, values="", layout="", files={}, error=error.words.en)


def manifests(folder: Path) -> Iterator[Manifest]:
    """The shards that were written into a folder. Raises VecpolyError for a file that is no manifest."""
    for file in sorted((folder / SHARDS).glob("*.jsonl")):
        try:
            rows: list[Any] = [json.loads(row) for row in file.read_text("utf-8").splitlines()]
            yield Manifest(
                folder=folder,
                head=TypeAdapter(Head).validate_python(rows[0]),
                lines=tuple(TypeAdapter(list[Line]).validate_python(rows[1:])),
            )
        except (ValueError, IndexError, ValidationError):
            raise VecpolyError(
                Words(
                    f"{file}：不是分片清单；请重新运行这一片（--shard）",
                    f"{file}: no manifest of a shard; run that --shard again",
                ),
                code="no-manifest",
            ) from None
