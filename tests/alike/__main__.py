"""python -m tests.alike [--count 20] [--seed 0] [--family START] [--law NAME]: laws of printed pages, of random
problems."""

from __future__ import annotations

import argparse
from collections import Counter

import numpy as np
from ruamel.yaml.error import YAMLError

from tests.alike.laws import LAWS
from tests.alike.said import solved
from tests.generators.family import OnText, families, member
from tests.generators.library import Data, data_of
from vecpoly.errors import VecpolyError

SHOWN = 400


def main() -> None:
    """Read the command line, draw members that analyse a mechanism, tell them otherwise."""
    parser = argparse.ArgumentParser(prog="python -m tests.alike", description=__doc__)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--family", default="")
    parser.add_argument("--law", default="")
    given = parser.parse_args()
    rng = np.random.default_rng(given.seed)
    kinds = [one for one in families() if one.name.startswith(given.family) and not isinstance(one.also, OnText)]
    made: Counter[str] = Counter()
    failed: Counter[str] = Counter()
    for number in range(given.count):
        kind = kinds[int(rng.integers(len(kinds)))]
        name = f"{kind.name}.{given.seed}.{number}"
        try:
            data = data_of(member(kind, given.seed, number))
        except YAMLError:
            continue  # in the signs of a Chinese keyboard
        if "links" not in data or not _is_solved(data):
            continue
        for law in (one for one in LAWS if one.name.startswith(given.law)):
            try:
                told = law.broken(np.random.default_rng([given.seed, number]), data)
            except (VecpolyError, KeyError, TypeError, AttributeError, ValueError) as refused:
                told = f"{type(refused).__name__}: {refused}"
            made[law.name] += 1
            if told:
                failed[law.name] += 1
                print(f"{law.name}  {name}\n    {told[:SHOWN]}", flush=True)
    print({name: f"{failed[name]} of {count}" for name, count in made.items()})


def _is_solved(data: Data) -> bool:
    """Whether the problem itself is not refused."""
    try:
        solved(data)
    except VecpolyError:
        return False
    return True


if __name__ == "__main__":
    main()
