"""Machines as they run: flywheels under every sort of load, the constant moment, equivalents of every link."""

from __future__ import annotations

from . import equivalents as equivalents
from . import flywheels as flywheels
from . import questions as questions
