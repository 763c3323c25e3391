"""What is no linkage, and machines in motion: wedges, screws, clamps, trains, structures, flywheels under any load."""

from __future__ import annotations

from . import rotors_all as rotors_all
from . import statics as statics
from . import structures as structures
from . import trains as trains
from . import wheels_all as wheels_all
