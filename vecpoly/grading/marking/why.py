"""What is known of the causes of a sheet's mistakes."""

from __future__ import annotations

from dataclasses import dataclass, field

from ...board.otherwise.slip import Slip
from ..told.message import Message


@dataclass(slots=True, kw_only=True)
class Causes:
    """said: root → why; slips: root → the mistake of the catalogue; source: what follows from a root → that root."""

    said: dict[str, Message] = field(default_factory=dict)
    slips: dict[str, Slip] = field(default_factory=dict)
    source: dict[str, str] = field(default_factory=dict)
