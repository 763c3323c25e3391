"""Which claims are dear: all tests are run, one after the other, and the functions that take long are written down."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Generator
from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage

import pytest

from . import LIST, function_of

DEAR = 0.5  # seconds of a processor
ALWAYS = "tests/generated/"  # random problems are what finds most: they are tried every time
HEAD = "# functions of tests that take more than {dear} s of a processor, as `python -m tests.dear` measured it\n"


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
    os.environ["TURNS"] = "1"
    clock = Clock()
    code = pytest.main(["-q", "-n0"], plugins=[clock])
    if code == pytest.ExitCode.OK:
        dear = ((name, taken) for name, taken in sorted(clock.taken.items()) if taken > DEAR)
        lines = (f"{name} {taken:.1f}\n" for name, taken in dear if not name.startswith(ALWAYS))
        LIST.write_text(HEAD.format(dear=DEAR) + "".join(lines), encoding="utf-8")
    return int(code)


if __name__ == "__main__":
    raise SystemExit(main())
