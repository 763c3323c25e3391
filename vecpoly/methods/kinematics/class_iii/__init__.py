"""Class III groups: a central link on three legs, located by trial, drawn over a special point (特殊点法)."""

from ....plugins import load_modules

load_modules(__name__)
