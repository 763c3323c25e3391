"""The equations of equilibrium of a loaded mechanism, as expressions that print and compute."""
