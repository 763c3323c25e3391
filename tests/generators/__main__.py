"""Soak: thousands of random problems judged.

python -m tests.generators                              # 200 of each family
python -m tests.generators --family rpp --count 10000 --seed 7 --jobs 2
python -m tests.generators --family rpp --seed 7 --only 118      # the text and the verdict of one
python -m tests.generators --family design --likely     # at likely scales: no sheets are filled, thrice as many an hour
"""

from __future__ import annotations

import argparse
import gc
import signal
from collections import Counter
from collections.abc import Iterator
from functools import partial
from multiprocessing import Pool

from rich.console import Console
from rich.progress import track

from .family import families, member
from .judge import Kind, Verdict, judge

Case = tuple[str, int, int]  # family, seed, number


def judged(case: Case, fitted: bool = True) -> tuple[Case, Verdict]:
    """One member made and judged."""
    name, seed, number = case
    one = next(each for each in families() if each.name == name)
    return case, judge(member(one, seed, number), one.also, fitted=fitted)


def _all(cases: list[Case], jobs: int, fitted: bool) -> Iterator[tuple[Case, Verdict]]:
    each = partial(judged, fitted=fitted)
    if jobs == 1:
        yield from map(each, cases)
        return
    with Pool(jobs, signal.signal, (signal.SIGTERM, signal.SIG_DFL)) as pool:  # workers end at once, and tell nothing
        yield from pool.imap_unordered(each, cases, chunksize=8)


def main() -> int:
    """Judge, count, show; exit code 1 where anything is wrong or broken."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.generators", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--family", action="append", help="a name, or the start of several; all where none is given")
    parser.add_argument("--count", type=int, default=200, help="members of each family")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", type=int, help="print this member and its verdict")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--likely", action="store_true", help="draw at likely scales, not at those that fill a sheet")
    asked = parser.parse_args()
    chosen = [one for one in families() if not asked.family or one.name.startswith(tuple(asked.family))]
    if asked.only is not None:
        for one in chosen:
            text = member(one, asked.seed, asked.only)
            print(text, judge(text, one.also, fitted=not asked.likely), sep="\n")
        return 0
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    cases = [(one.name, asked.seed, number) for number in range(asked.count) for one in chosen]
    found: list[tuple[Case, Verdict]] = []
    gc.freeze()  # what is loaded stays; to look through it again and again takes a fifth of the time
    try:
        for pair in track(_all(cases, asked.jobs, not asked.likely), total=len(cases), description="judging"):
            found.append(pair)
            _say_bad(*pair)
    except KeyboardInterrupt:  # or killed: what was judged is told all the same, of all families alike
        print(f"stopped after {len(found)} of {len(cases)}")
    return _told(found)


def _say_bad(case: Case, verdict: Verdict) -> None:
    """What is wrong is said at once: a soak takes hours, and may be stopped."""
    if verdict.kind in (Kind.WRONG, Kind.BROKEN):
        print(f"{case[0]} --seed {case[1]} --only {case[2]}: {verdict.kind}: {verdict.why}", flush=True)


def _told(found: list[tuple[Case, Verdict]]) -> int:
    console = Console(width=180)
    for name in dict.fromkeys(case[0] for case, _ in sorted(found, key=lambda pair: pair[0])):
        mine = [(case, verdict) for case, verdict in found if case[0] == name]
        counts = Counter(verdict.kind for _, verdict in mine)
        console.print(f"{name}: " + ", ".join(f"{counts[kind]} {kind}" for kind in Kind), markup=False)
        for reason, times in Counter(v.reason for _, v in mine if v.kind is Kind.REFUSED).most_common(12):
            console.print(f"    {times:5d} × {reason}", markup=False)
        for (_, seed, number), verdict in [pair for pair in mine if pair[1].kind in (Kind.WRONG, Kind.BROKEN)][:12]:
            console.print(f"    {verdict.kind} --seed {seed} --only {number}: {verdict.why}", markup=False)
    return int(any(verdict.kind in (Kind.WRONG, Kind.BROKEN) for _, verdict in found))


if __name__ == "__main__":
    raise SystemExit(main())
