"""Forces in every form in which the manual lets them be written:
friction, masses, pins that a link carries, cams, thrusts."""

from __future__ import annotations

from . import burdened as burdened
from . import cams as cams
from . import helped as helped
from . import laws as laws
from . import locking as locking
from . import thrusts as thrusts
from . import written as written
