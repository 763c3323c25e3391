"""All sheets together: merged PDFs with an outline, and an archive; the same bytes for the same class."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from zipfile import ZIP_STORED, ZipFile, ZipInfo

from pypdf import PdfReader, PdfWriter

from ..words import bare
from .register import Register
from .run.tasks import question_file, solution_file

_FIRST = (1980, 1, 1, 0, 0, 0)


def merged(register: Register, out: Path, *, solutions: bool = False) -> bytes:
    """All questions, or all solutions, in one PDF: each student an entry of the outline."""
    writer, target = PdfWriter(), BytesIO()
    for sheet in register.sheets:
        file = out / (solution_file if solutions else question_file)(sheet.student)
        name = f"{sheet.student.number} {sheet.student.name} ({sheet.sheet})"
        writer.append(PdfReader(file), outline_item=name, import_outline=False)
    writer.metadata = {
        "/Title": bare(register.title.of("zh" if register.lang == "zh" else "en")),
        "/Producer": "vecpoly",
    }
    writer.write(target)
    return target.getvalue()


def zipped(files: Sequence[Path], out: Path) -> bytes:
    """An archive of these files, with neither dates nor owners."""
    target = BytesIO()
    with ZipFile(target, "w", ZIP_STORED) as archive:
        for file in sorted(files):
            entry = ZipInfo(file.relative_to(out).as_posix(), _FIRST)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, file.read_bytes())
    return target.getvalue()
