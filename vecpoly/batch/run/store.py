"""What was done already, by the digest of what it was done from: a run that was killed goes on where it was."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

from ...foundation.files import write_whole

FOLDER = ".work"


def digest(data: object) -> str:
    """The digest of plain data."""
    return sha256(json.dumps(data, ensure_ascii=False, sort_keys=True, default=str).encode()).hexdigest()[:24]


def bytes_digest(data: bytes) -> str:
    """SHA-256 of the bytes of a file."""
    return sha256(data).hexdigest()


def file_digest(file: Path) -> str:
    """SHA-256 of a file's bytes."""
    return bytes_digest(file.read_bytes())


@dataclass(frozen=True, slots=True)
class Store:
    """The folder of results beside the finished files."""

    out: Path

    def get(self, address: str) -> Any:
        """The result under this address, where it is whole and the files that it tells of are there; else None."""
        try:
            found = json.loads(self._file(address).read_bytes())
        except (OSError, ValueError):
            return None
        return found["result"] if all(self._same(*each) for each in found["files"].items()) else None

    def put(self, address: str, result: object, files: Mapping[str, str]) -> None:
        """Keep a result, and the names of the files that were written with it, each with the digest of its bytes."""
        data = json.dumps({"result": result, "files": dict(files)}, ensure_ascii=False)
        write_whole(self._file(address), data.encode())

    def _file(self, address: str) -> Path:
        return self.out / FOLDER / f"{address}.json"

    def _same(self, name: str, known: str) -> bool:
        """Whether a file is there, and has the bytes that were written."""
        file = self.out / name
        return file.is_file() and file_digest(file) == known
