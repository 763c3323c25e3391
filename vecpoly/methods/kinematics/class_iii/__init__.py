"""Class III groups: a central link on three legs, located by trial, drawn over a special point (特殊点法)."""
