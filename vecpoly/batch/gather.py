"""Shards put together: all are there, nobody stands in two, every file has the bytes that were written."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

from ..errors import VecpolyError
from ..words import Words
from .classwork import Made, Order, Told, make_class
from .register import Register
from .run.manifest import Line, Manifest, manifests, roster_digest, values_digest
from .run.runners import Runner
from .run.store import FOLDER, file_digest

SOME = 5  # names that a refusal lists


def gather(order: Order, folders: Sequence[Path], run: Runner, told: Told) -> Made:
    """Complete a class from the folders of its shards, which may be the folder of the class itself.

    Raises VecpolyError, with what to do, where a shard is missing or was made of another roster, by another program or
    of other problems; where a student is in two of them or in none; where a file is not the one that was written.
    """
    shards = _each_once([one for folder in folders for one in manifests(folder)], folders)
    _of_one_class(shards, order)
    _whole(shards, order)
    for shard in shards:
        _bring(shard, order.out)
    return make_class(order, run, told, pieces=shards[0].head.of, held=lambda made: _agree(made, shards))


def _each_once(found: Sequence[Manifest], folders: Sequence[Path]) -> list[Manifest]:
    """Every shard once, in order; one that was made twice must have been made alike."""
    if not found:
        names = ", ".join(map(str, folders))
        raise _refused(
            Words(
                f"{names}：没有分片；请先用 --shard 0/n … 生成各片", f"{names}: no shards; make them by --shard 0/n ..."
            )
        )
    first = found[0]
    known: dict[int, Manifest] = {}
    for one in found:
        if one.head.of != first.head.of:
            raise _refused(
                Words(
                    f"{first.folder} 分 {first.head.of} 片，而 {one.folder} 分 {one.head.of} 片；请只留一种分法",
                    f"{first.folder} has shards of {first.head.of}, {one.folder} of {one.head.of}; leave one of them",
                )
            )
        other = known.setdefault(one.head.shard, one)
        if other.lines != one.lines:
            raise _refused(_unlike(other, one))
    missing = [f"--shard {n}/{first.head.of}" for n in range(first.head.of) if n not in known]
    if missing:
        listed = _some(missing)
        raise _refused(Words(f"缺少分片：{listed}；请运行它们", f"shards are missing: {listed}; run them"))
    return [known[n] for n in range(first.head.of)]


def _unlike(one: Manifest, other: Manifest) -> Words:
    differing = next((a.number for a, b in zip(one.lines, other.lines, strict=False) if a != b), "")
    return Words(
        f"{one.folder} 与 {other.folder} 中的分片 {one.name} 不同（学号 {differing}）；请重做其一",
        f"shard {one.name} is not the same in {one.folder} and {other.folder} (student {differing}); make one anew",
    )


def _of_one_class(shards: Sequence[Manifest], order: Order) -> None:
    """Raise where a shard is of another class, program, language, roster, or of other problems than the first."""
    wanted = {
        "vecpoly": order.version, "assignment": order.assignment.id, "salt": order.assignment.salt, "lang": order.lang,
        "roster": roster_digest(order.students), "problems": shards[0].head.problems,
    }  # fmt: skip
    for shard in shards:
        for name, value in wanted.items():
            there = getattr(shard.head, name)
            if there != value:
                raise _refused(
                    Words(
                        f"分片 {shard.name} 的 {name} 为“{there}”，应为“{value}”；请重新运行 --shard {shard.name}",
                        f"shard {shard.name} has {name} '{there}', not '{value}'; run --shard {shard.name} again",
                    )
                )


def _whole(shards: Sequence[Manifest], order: Order) -> None:
    """Raise where a student is in two shards or in none, or where a file is not the one that was written."""
    where: dict[str, Manifest] = {}
    for shard in shards:
        for line in shard.lines:
            other = where.setdefault(line.number, shard)
            if other is not shard:
                raise _refused(
                    Words(
                        f"学号 {line.number} 在分片 {other.name} 和 {shard.name} 中都有；请重新运行二者",
                        f"student {line.number} is in shards {other.name} and {shard.name}; run both again",
                    )
                )
            _same_files(shard, line)
    none = _some([one.number for one in order.students if one.number not in where])
    if none:
        raise _refused(
            Words(f"没有一片含有学号 {none}；请重新运行各片", f"no shard has student {none}; run the shards again")
        )


def _same_files(shard: Manifest, line: Line) -> None:
    for name, written in line.files.items():
        file = shard.folder / name
        there = file_digest(file) if file.is_file() else "—"
        if there != written:
            raise _refused(
                Words(
                    f"{file}：SHA-256 为 {there[:12]}，而分片 {shard.name} 写的是 {written[:12]}；"
                    f"请重新运行 --shard {shard.name}",
                    f"{file}: SHA-256 is {there[:12]}, shard {shard.name} wrote {written[:12]}; "
                    f"run --shard {shard.name} again",
                )
            )


def _bring(shard: Manifest, out: Path) -> None:
    """Copy what a shard made, and what it keeps for going on, into the folder of the class."""
    if shard.folder.resolve() == out.resolve():
        return
    kept = (file.relative_to(shard.folder).as_posix() for file in (shard.folder / FOLDER).glob("*.json"))
    for name in (*(name for line in shard.lines for name in line.files), *kept):
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(shard.folder / name, out / name)


def _agree(made: Register, shards: Sequence[Manifest]) -> None:
    """Raise where the register has other values or pages than the shards."""
    lines = {line.number: line for shard in shards for line in shard.lines}
    for sheet in made.sheets:
        line = lines[sheet.student.number]
        if (line.values, line.layout) != (values_digest(sheet), sheet.layout_hash):
            raise _refused(
                Words(
                    f"学号 {line.number} 的数据与分片中的不同；名单或作业在分片之后改过，请重新运行各片",
                    f"student {line.number} has other values than in the shard; roster or assignment were changed "
                    "since, run the shards again",
                )
            )


def _some(names: Sequence[str]) -> str:
    return ", ".join(names[:SOME]) + (f" ... ({len(names)})" if len(names) > SOME else "")


def _refused(words: Words) -> VecpolyError:
    return VecpolyError(words, code="gather")
