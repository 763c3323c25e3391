"""What the other families keep apart, in one file: loads by laws in every form of joint, masses in every form of words,
questions of several kinds at once, two drives at any linkage."""

from __future__ import annotations

from . import asked as asked
from . import lawful as lawful
from . import two_drives as two_drives
