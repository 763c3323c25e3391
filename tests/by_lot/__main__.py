"""python -m tests.by_lot [--count 40] [--seed 0] [--family NAME] [FILE ...]: claims about the library, of random
problems."""

from __future__ import annotations

import argparse

from tests.by_lot.members import drawn_by_lot
from tests.by_lot.taken import in_place_of_the_library


def main() -> None:
    """Read the command line, draw the members, make the claims of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.by_lot", description=__doc__)
    parser.add_argument("--count", type=int, default=40, help="how many members")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--family", default="", help="only families whose names begin so")
    parser.add_argument("--only", default="", help="only the member of this name")
    parser.add_argument("--text", action="store_true", help="print the members, and claim nothing")
    parser.add_argument("files", nargs="*", default=["tests"], help="of these tests")
    given = parser.parse_args()
    members = drawn_by_lot(given.family, given.count, given.seed)
    if given.only:
        members = {given.only: members[given.only]}
    if given.text:
        print("\n\n".join(f"# {name}\n{text}" for name, text in members.items()))
        return
    print(f"{len(members)} members: {', '.join(members)}", flush=True)
    tried = in_place_of_the_library(members, given.files)
    print(tried)
    raise SystemExit(1 if tried.failed else 0)


if __name__ == "__main__":
    main()
