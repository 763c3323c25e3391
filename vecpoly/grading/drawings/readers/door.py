"""The one way in: a file by its ending and its first bytes."""

from __future__ import annotations

from pathlib import Path

from ....errors import Fault, FaultError, Place, ProblemFileError, VecpolyError
from ....foundation.running.system import of_system
from ....limits import DRAWING_BYTES
from ....words import Words
from ..segment import Drawing
from .dxf import read_dxf
from .ggb import read_ggb
from .pdf import read_pdf
from .svg import read_svg

READERS = {".dxf": read_dxf, ".svg": read_svg, ".pdf": read_pdf, ".ggb": read_ggb}


def read_drawing(file: Path | str) -> Drawing:
    """The segments (mm), arrow heads and lettering of a DXF, SVG, vector PDF or GeoGebra file.

    Raises ProblemFileError, one sentence with the file, for what is none of these, too large, damaged, or empty.
    """
    path = Path(file)
    try:
        return parsed(path.name, _bytes(path))
    except FaultError as error:
        fault = Fault(said=error.words, code=error.code, place=Place(str(file)), numbers=error.numbers)
        raise ProblemFileError.of(fault) from None


def parsed(name: str, data: bytes) -> Drawing:
    """The drawing in these bytes of a file of this name; raises FaultError."""
    read = READERS.get(Path(name).suffix.lower())
    if read is None:
        raise FaultError(
            Words(
                f"不是 {'、'.join(READERS)} 文件；DWG 请另存为 DXF",
                f"is none of {', '.join(READERS)}; save a DWG as DXF",
            ),
            code="format",
        )
    return read(name, data)


def _bytes(path: Path) -> bytes:
    try:
        size = path.stat().st_size if path.is_file() else 0
        if size > DRAWING_BYTES:
            most = DRAWING_BYTES // 1_000_000
            raise FaultError(
                Words(
                    f"{size / 1e6:.1f} MB 大于 {most} MB；请只保留作图本身",
                    f"{size / 1e6:.1f} MB is more than {most} MB; keep only the drawing itself",
                ),
                code="too-large",
                numbers={"bytes": size, "most": DRAWING_BYTES},
            )
        return path.read_bytes()
    except OSError as error:
        raise VecpolyError(Words(f"{path}：", f"{path}: ") + of_system(error), code="file") from None
