"""A problem about a device: ``device: screw-jack`` with its ``data:`` instead of frame, links, joints and input."""

from __future__ import annotations

from pathlib import Path

from ..devices.base import Device, kind_of, kinds
from ..errors import FaultError, UnknownNameError
from ..names import Named
from ..words import Words
from .asked.asks import AskNamed
from .asked.wanted import as_given, read_scales
from .gate import read_gate
from .problem import Datum, Given, Printed, Problem, Scales
from .read_ranges import read_ranges
from .schema.faults import Faults, meant
from .schema.models import DeviceSpec, ProblemSpec
from .schema.validate import validate
from .schema.warnings import warnings_of
from .text.source import Tree
from .values.written import written_of


def about_device(tree: Tree) -> bool:
    """Whether the file is about a device; raises ProblemFileError where it has `data` but names none."""
    if "data" in tree.data and "device" not in tree.data:
        faults = Faults(tree.name, tree.places)
        with faults.at("data"):
            raise FaultError(
                Words(
                    f"data 属于机械装置；请写出装置，如 device: {next(iter(kinds()))}（已有：{', '.join(kinds())}）",
                    f"'data' belongs to a device; write e.g. device: {next(iter(kinds()))} (known: "
                    f"{', '.join(kinds())})",
                ),
                code="spelling",
            )
        faults.settle()
    return "device" in tree.data


def build_device(tree: Tree, path: Path | None = None) -> Problem:
    """The problem about a device in this tree; raises ProblemFileError with everything that is wrong with it."""
    faults = Faults(tree.name, tree.places)
    _strange(tree, faults)
    spec = validate(DeviceSpec, {k: v for k, v in tree.data.items() if v is not None}, faults)
    device = _device(spec, faults)
    named = {one.key: one for one in device.quantities()}
    asks, printed, scales = _wanted(spec, named, faults)
    ranges, gate = read_ranges(spec.vary, tree.data, faults), read_gate(spec.gate, faults)
    faults.settle()
    return Problem(
        id=spec.id,
        title=spec.title,
        source=spec.source,
        statement=spec.statement,
        subject=device,
        asks=asks,
        scales=scales,
        printed=printed,
        errata=tuple(spec.errata),
        given=Given(loads=tuple(Datum(symbol=symbol, text=text) for symbol, text in device.given())),
        orientation=spec.sheet.orientation if spec.sheet else None,
        path=path,
        text=tree.text,
        read=tree.files,
        ranges=ranges,
        gate=gate,
        warnings=warnings_of(tree),
        written=written_of(tree),
    )


def _strange(tree: Tree, faults: Faults) -> None:
    """Keys that belong to a mechanism."""
    for key in tree.data:
        if key in ProblemSpec.model_fields and key not in DeviceSpec.model_fields:
            with faults.at(key):
                raise FaultError(
                    Words(
                        f"“{key}”属于机构；装置的已知量都写在 data 中",
                        f"'{key}' belongs to a mechanism; all that is given of a device stands in 'data'",
                    )
                )
    faults.settle()


def _device(spec: DeviceSpec, faults: Faults) -> Device:
    with faults.at("device"):
        try:
            kind = kind_of(spec.device)
        except UnknownNameError:
            raise FaultError(
                Words(f"没有装置“{spec.device}”", f"there is no device '{spec.device}'") + meant(spec.device, kinds()),
                code="unknown-name",
            ) from None
    faults.settle()
    return validate(kind, spec.data, faults, "data")


def _wanted(
    spec: DeviceSpec, named: dict[str, Named], faults: Faults
) -> tuple[tuple[AskNamed, ...], tuple[Printed, ...], Scales]:
    asks, printed, scales = [], [], Scales()
    for i, key in enumerate(spec.find or named):
        with faults.at("find", i):
            asks.append(AskNamed(rel=_known(key, named)))
    for i, entry in enumerate(spec.printed):
        with faults.at("printed", i):
            printed.append(as_given(entry, _known(entry.symbol, named)))
    with faults.at("scales"):
        scales = read_scales(spec.scales)
    return tuple(asks), tuple(printed), scales


def _known(key: str, named: dict[str, Named]) -> Named:
    if key not in named:
        raise FaultError(
            Words(f"“{key}”不是此装置可求的量", f"'{key}' is nothing that this device is asked for") + meant(key, named)
        )
    return named[key]
