"""What is no linkage, and machines in motion: wedges, screws, clamps, trains, structures, flywheels under any load."""

from __future__ import annotations

from . import statics as statics
from . import structures as structures
from . import trains as trains
