"""Run-up, run-down and braking: characteristics, the area under 1/ΔM, the speed over time."""
