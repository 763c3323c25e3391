"""One claim about many cases as one test: every case is tried, and those that fail are named together."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Iterable, Iterator
from functools import cached_property, wraps
from typing import Concatenate, Generic, ParamSpec, TypeVar

Case = TypeVar("Case")
Given = ParamSpec("Given")
ALONE = "CASE"  # the environment variable that names the only case to be tried
FULL = 5  # so many failures are shown in full; all are named


class Later(Generic[Case]):
    """Cases that are looked for when the first of them is wanted: in drawings, which no file draws to be imported."""

    def __init__(self, find: Callable[[], Iterable[Case]]) -> None:
        self._find = find

    @cached_property
    def _found(self) -> tuple[Case, ...]:
        return tuple(self._find())

    def __iter__(self) -> Iterator[Case]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __contains__(self, case: object) -> bool:
        return case in self._found


def each(cases: Iterable[Case]) -> Callable[[Callable[Concatenate[Case, Given], None]], Callable[Given, None]]:
    """Make one test of a claim about each of these cases: `CASE=3-9 pytest ...` tries one of them alone.

    Thousands of tests of a millisecond take longer to collect and to report than to run. The test fails where a case
    fails, and where there is none.
    """

    def decorated(claim: Callable[Concatenate[Case, Given], None]) -> Callable[Given, None]:
        @wraps(claim)
        def of_all(*args: Given.args, **given: Given.kwargs) -> None:
            _tell([(case, _failure(claim, case, *args, **given)) for case in cases if _wanted(case)])

        _, *fixtures = inspect.signature(claim).parameters.values()
        of_all.__signature__ = inspect.Signature(fixtures)  # type: ignore[attr-defined]
        return of_all

    return decorated


def _wanted(case: object) -> bool:
    return os.environ.get(ALONE) in (None, str(case))


def _failure(
    claim: Callable[Concatenate[Case, Given], None], case: Case, *args: Given.args, **given: Given.kwargs
) -> Exception | None:
    try:
        claim(case, *args, **given)
    except Exception as failure:
        failure.add_note(f"case {case}; alone: {ALONE}={case} pytest ...")
        return failure
    return None


def _tell(tried: list[tuple[Case, Exception | None]]) -> None:
    failed = [(case, failure) for case, failure in tried if failure is not None]
    if not tried:
        raise AssertionError(f"there is no case {os.environ.get(ALONE, 'at all')}")
    if failed:
        named = f"{len(failed)} of {len(tried)} cases fail: {', '.join(str(case) for case, _ in failed)}"
        raise ExceptionGroup(named, [failure for _, failure in failed[:FULL]])
