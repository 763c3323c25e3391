"""A problem all of whose givens stand in ``data:``, instead of frame, links, joints and input.

``device: screw-jack`` names a machine, ``synthesis: crank-rocker`` a task in which the mechanism is to be found.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from ..designs import base as designs
from ..devices import base as devices
from ..errors import FaultError, UnknownNameError
from ..foundation.stock import ANY_A4, paper_of
from ..names import Named
from ..words import Words
from .asked.asks import AskNamed
from .asked.drawn_to import read_scales
from .asked.printed import as_given
from .gate import read_gate
from .problem import Datum, Given, Printed, Problem, Scales
from .read_ranges import read_ranges
from .schema.faults import Faults, meant
from .schema.models import DataSpec, DesignSpec, DeviceSpec, ProblemSpec
from .schema.validate import validate
from .schema.warnings import warnings_of
from .text.source import Tree
from .values.given import GivenTable, by_table
from .values.written import written_of

_AT_PLACE = re.compile(r"([a-zA-Z]+)_(\d+(?:\.\d+)?)")
_BAR = re.compile(r"^([A-Z])([A-Z])((?:_\d+)?)$")  # by its ends
_STATIONS = 6  # names with one stem, at least, that are places

Subject = devices.Device | designs.Design


@dataclass(frozen=True, slots=True, kw_only=True)
class Sort:
    """A sort of such problems: the key that names it, what the file may hold, the classes of its data, by name."""

    key: str
    called: Words
    spec: type[DataSpec]
    kinds: Callable[[], Mapping[str, type[Subject]]]
    kind_of: Callable[[str], type[Subject]]


SORTS = (
    Sort(key="device", called=Words("装置", "device"), spec=DeviceSpec, kinds=devices.kinds, kind_of=devices.kind_of),
    Sort(
        key="synthesis",
        called=Words("综合题型", "synthesis"),
        spec=DesignSpec,
        kinds=designs.kinds,
        kind_of=designs.kind_of,
    ),
)


def sort_of(tree: Tree) -> Sort | None:
    """Of which sort the problem is; None of a mechanism. Raises ProblemFileError where it has `data` but names none."""
    found = next((sort for sort in SORTS if sort.key in tree.data), None)
    if found is None and "data" in tree.data:
        faults = Faults(tree.name, tree.places)
        key, why = _misnamed(tree) or ("data", _nameless())
        with faults.at(key):
            raise FaultError(why, code="spelling")
        faults.settle()
    return found


def _misnamed(tree: Tree) -> tuple[str, Words] | None:
    """The key under which a device or a task of synthesis stands by its name, and under which it should: design: ..."""
    for key, value in tree.data.items():
        for sort in SORTS:
            if isinstance(value, str) and value in sort.kinds():
                right = f"{sort.key}: {value}"
                return key, Words(
                    f"没有键 '{key}'；{value} 是{sort.called.zh}，请写 {right}",
                    f"'{key}' is no key of a problem; write {right}",
                )
    return None


def _nameless() -> Words:
    """That a problem with data must say of what."""
    known, device, task = ", ".join(devices.kinds()), next(iter(devices.kinds())), next(iter(designs.kinds()))
    return Words(
        f"data 属于机械装置；请写出装置，如 device: {device}（已有：{known}），或综合题型，如 synthesis: {task}",
        f"'data' belongs to a device; write e.g. device: {device} (known: {known}), or to a task of synthesis: "
        f"synthesis: {task}",
    )


def build_by_data(tree: Tree, sort: Sort, path: Path | None = None) -> Problem:
    """The problem in this tree; raises ProblemFileError with everything that is wrong with it."""
    faults = Faults(tree.name, tree.places)
    _strange(tree, sort, faults)
    spec = validate(sort.spec, {k: v for k, v in tree.data.items() if v is not None}, faults)
    subject = _subject(spec, sort, faults)
    asks, printed, scales = _wanted(spec, subject, sort, faults)
    ranges, gate = read_ranges(spec.vary, tree.data, faults), read_gate(spec.gate, faults)
    faults.settle()
    return Problem(
        id=spec.id,
        title=spec.title,
        source=spec.source,
        statement=spec.statement,
        explain=tuple(spec.explain),
        subject=subject,
        asks=asks,
        scales=scales,
        printed=printed,
        errata=tuple(spec.errata),
        given=Given(loads=(*(Datum(words=words) for words in subject.told()), *_told_of(subject))),
        paper=paper_of(spec.sheet.format, spec.sheet.orientation) if spec.sheet else ANY_A4,
        path=path,
        text=tree.text,
        read=tree.files,
        ranges=ranges,
        gate=gate,
        warnings=(*warnings_of(tree), *subject.noted(spec.find)),
        written=written_of(tree),
    )


def _told_of(subject: Subject) -> Iterator[Datum]:
    """Each datum as it is written, or by a table."""
    tabled = subject.tabled() if isinstance(subject, devices.Device) else {}
    for symbol, text in subject.given():
        if (table := tabled.get(symbol)) is None:
            yield Datum(symbol=symbol, text=text)
        else:
            yield Datum(
                symbol=symbol,
                words=by_table(f"${symbol}$", f"${symbol}$", f"${table.over}$"),
                table=GivenTable(
                    head=(f"${table.over}$ /{table.unit}", f"${symbol}$ /(N·m)"),
                    rows=tuple((at.replace("-", "−"), size.replace("-", "−")) for at, size in table.rows),
                ),
            )


def _strange(tree: Tree, sort: Sort, faults: Faults) -> None:
    """Keys that belong to a mechanism."""
    for key in tree.data:
        if key in ProblemSpec.model_fields and key not in sort.spec.model_fields:
            with faults.at(key):
                raise FaultError(
                    Words(
                        f"“{key}”属于机构；{sort.called.zh}的已知量都写在 data 中",
                        f"'{key}' belongs to a mechanism; all that is given of a {sort.called.en} stands in 'data'",
                    )
                )
    faults.settle()


def _subject(spec: DataSpec, sort: Sort, faults: Faults) -> Subject:
    name = str(getattr(spec, sort.key))
    with faults.at(sort.key):
        try:
            kind = sort.kind_of(name)
        except UnknownNameError:
            raise FaultError(
                Words(f"没有{sort.called.zh}“{name}”", f"there is no {sort.called.en} '{name}'")
                + meant(name, sort.kinds()),
                code="unknown-name",
            ) from None
    faults.settle()
    return validate(kind, spec.data, faults, "data")


def _wanted(
    spec: DataSpec, subject: Subject, sort: Sort, faults: Faults
) -> tuple[tuple[AskNamed, ...], tuple[Printed, ...], Scales]:
    asks, printed, scales = [], [], Scales()
    usual = {one.key: one for one in subject.quantities()}
    named = {one.key: one for one in subject.askable()} if isinstance(subject, designs.Design) else usual
    for i, key in enumerate(spec.find or _sought(subject)):
        with faults.at("find", i):
            asks.append(AskNamed(rel=_known(key, named, sort)))
    for i, entry in enumerate(spec.printed):
        with faults.at("printed", i):
            printed.append(as_given(entry, _known(entry.symbol, named, sort)))
    with faults.at("scales"):
        scales = read_scales(spec.scales)
    return tuple(dict.fromkeys(asks)), tuple(printed), scales


def _sought(subject: Subject) -> list[str]:
    """What is asked where nothing is said."""
    usual = subject.usual() if isinstance(subject, devices.Device) else subject.quantities()
    return [one.key for one in usual]


def _known(key: str, named: dict[str, Named], sort: Sort) -> Named:
    """What is asked by this key; DC where the bar is called CD, and DC_2."""
    if key not in named:
        key = turned if (turned := _BAR.sub(r"\2\1\3", key)) in named else key
    if key not in named:
        raise FaultError(
            Words(
                f"“{key}”不是此{sort.called.zh}可求的量", f"'{key}' is nothing that this {sort.called.en} is asked for"
            )
            + (_beside(key, named) or meant(key, named))
        )
    return named[key]


def _beside(key: str, named: Mapping[str, Named]) -> Words | None:
    """Of a place at which nothing is worked out (psi_200): the two nearest at which it is."""
    if (wanted := _AT_PLACE.fullmatch(key)) is None:
        return None
    places = [(float(at[2]), one) for one in named if (at := _AT_PLACE.fullmatch(one)) and at[1] == wanted[1]]
    if len(places) < _STATIONS:
        return None
    near = [one for _, one in sorted(places, key=lambda place: abs(place[0] - float(wanted[2])))[:2]]
    return Words(
        f"：{wanted[2]} 处没有分点，最近的是 {'、'.join(near)}",
        f": there is no station at {wanted[2]}, the nearest are {' and '.join(near)}",
    )
