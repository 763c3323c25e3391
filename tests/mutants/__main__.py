"""`python -m tests.mutants --count 200 --seed 1 [--room vecpoly/methods]`:
so many slips, and which of them no test noticed.

The first run needs the map of tests and functions: all tests once, about twice their usual time. `--map` makes it anew,
`--map tests/test_new.py`
adds what a new file calls; `--count 0` stops after that. `--tests tests/test_new.py` asks for no map: every mutant is
tried on all tests of these files,
which is how claims about one room are written.
"""

from __future__ import annotations

import argparse
import random
import re
import time
from collections import Counter, defaultdict
from collections.abc import Sequence
from pathlib import Path

from .alike import alike
from .slips import Mutant, compiles, mutants
from .touched import MAP, ROOT, listen, touched
from .trial import Fate, try_all

_READERS = (
    "tests/house/test_words_in_order.py::test_who_reads_chinese_is_given_chinese_and_who_reads_english_english",
)
_OF_SOURCES = {  # they call nothing, and read all
    "swapped languages": (
        "tests/house/test_words_in_order.py::test_chinese_stands_first_in_every_sentence_of_the_code",
    ),
    "swapped branches": _READERS,
    "turned comparison": _READERS,
}
_NUMBERS = "tests/house/test_words_in_order.py::test_every_number_is_worked_out_in_english_as_in_chinese"
_FILES = "tests/house/test_text_files.py::test_every_text_is_read_and_written_as_utf_8"
_TOLD = re.compile(r":[.\d]*[defg]\}")  # a number with so many digits in a sentence
_COUNTED = (Fate.KILLED, Fate.HUNG)


def main() -> None:
    """Read the command line, try the mutants, print the table."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="how many mutants")
    parser.add_argument("--seed", type=int, default=0, help="which mutants")
    parser.add_argument("--room", default="vecpoly", help="a folder or a file")
    parser.add_argument("--kind", default="", help="only slips whose kind contains this")
    parser.add_argument("--budget", type=float, default=20.0, help="seconds of tests chosen for a mutant")
    parser.add_argument(
        "--map",
        nargs="*",
        metavar="FILE",
        help="find out anew which test calls which function: in all tests, or in these files",
    )
    parser.add_argument(
        "--few", action="store_true", help="a map of a few parameters of each test: a tenth of the time"
    )
    parser.add_argument(
        "--tests",
        nargs="+",
        metavar="FILE",
        default=[],
        help="try every mutant on all tests of these files, whatever the map says",
    )
    given = parser.parse_args()
    if given.map is not None or not (MAP.exists() or given.tests):
        listen(*(given.map or ()), few=given.few)
    if given.count:
        _tried(_drawn(given.room, given.kind, given.count, given.seed), given.budget, given.tests)


def _drawn(room: str, kind: str, count: int, seed: int) -> list[Mutant]:
    """Mutants by lot: first a file, as often as it has lines, then a slip in it, so that many slips in a line have no
    more weight than one. A file's slips are listed when its lot is drawn."""
    start = ROOT / room
    paths = [start] if start.is_file() else sorted(start.rglob("*.py"))
    files = {path: len(path.read_bytes().splitlines()) for path in paths}
    rng, drawn, pools = random.Random(seed), list[Mutant](), dict[Path, list[Mutant]]()
    while len(drawn) < count and any(files.values()):
        [path] = rng.choices(list(files), list(files.values()))
        if path not in pools:
            pools[path] = [
                one
                for one in mutants(path.relative_to(ROOT), path.read_text(encoding="utf-8"))
                if kind in one.kind and one.function.strip()
            ]
        if not (pool := pools[path]):
            del files[path]
        elif compiles((one := pool.pop(rng.randrange(len(pool)))).text):
            drawn.append(one)
    return drawn


def _tried(drawn: Sequence[Mutant], budget: float, files: Sequence[str]) -> None:
    """Try the mutants one after the other, tell of each, and of all."""
    fates: dict[str, Counter[Fate]] = defaultdict(Counter)
    start = time.monotonic()

    def tell(mutant: Mutant, fate: Fate) -> None:
        fates[_room(mutant.path)][fate] += 1
        print(f"{fate.value:9s} {time.monotonic() - start:5.0f} s  {mutant}", flush=True)

    known = None if files else touched()
    try_all(
        drawn,
        None
        if known is None
        else (
            lambda mutant, tests: (
                *_of_sources(mutant),
                *(
                    known.chosen(str(mutant.path), mutant.function, budget, tests)
                    if known.knows(str(mutant.path))
                    else alike(str(mutant.path), tests)
                ),
            )
        ),
        files,
        budget,
        tell,
        None if known is None else known.seconds,
    )
    print(_table(fates))


def _of_sources(mutant: Mutant) -> tuple[str, ...]:
    """The claims about all sources that such a slip may break."""
    told = (_NUMBERS,) if _TOLD.search(mutant.text.splitlines()[mutant.line - 1]) else ()
    files = (_FILES,) if "encoding" in mutant.before and "encoding" not in mutant.after else ()
    return (*_OF_SOURCES.get(mutant.kind, ()), *told, *files)


def _room(path: Path) -> str:
    parts = path.parts[1:-1]
    return "/".join(parts[:2]) or path.name


def _table(fates: dict[str, Counter[Fate]]) -> str:
    whole = sum(fates.values(), Counter[Fate]())
    rows = [*sorted(fates.items()), ("all rooms", whole)]
    return "\n".join(
        f"{room:24s} {sum(count[fate] for fate in _COUNTED):4d} of {count.total():4d} noticed "
        f"({100 * sum(count[fate] for fate in _COUNTED) / count.total():3.0f} %)"
        for room, count in rows
    )


if __name__ == "__main__":
    main()
