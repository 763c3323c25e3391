"""Which claims are dear: tests are run one after the other, and the functions that take long are added to the list.

Of those that share a drawing the first one run takes long, in other turns another: run it until nothing is added.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Generator
from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage

import pytest

from . import LIST, function_of, listed

DEAR = 0.5  # seconds of a processor
ALWAYS = "tests/generated/"  # random problems are what finds most: they are tried every time
HEAD = "# functions of tests that took more than {dear} s of a processor, the list grows by `python -m tests.dear`\n"


class Clock:
    """Measures what each function of tests takes, in this process and in those that it starts."""

    def __init__(self) -> None:
        self.taken: defaultdict[str, float] = defaultdict(float)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        """From the first fixture to the last."""
        before = _seconds()
        result = yield
        self.taken[function_of(item.nodeid)] += _seconds() - before
        return result


def _seconds() -> float:
    return sum(one.ru_utime + one.ru_stime for one in map(getrusage, (RUSAGE_SELF, RUSAGE_CHILDREN)))


def main() -> int:
    """The exit code of the tests; the list is written where they pass."""
    clock = Clock()
    code = pytest.main(["-q", "-n0"], plugins=[clock])
    if code == pytest.ExitCode.OK:
        found = {name: f"{taken:.1f}" for name, taken in clock.taken.items() if taken > DEAR and ALWAYS not in name}
        LIST.write_text(HEAD.format(dear=DEAR) + _lines(found | listed()), encoding="utf-8")
    return int(code)


def _lines(found: dict[str, str]) -> str:
    return "".join(f"{name} {taken}\n" for name, taken in sorted(found.items()))


if __name__ == "__main__":
    raise SystemExit(main())
