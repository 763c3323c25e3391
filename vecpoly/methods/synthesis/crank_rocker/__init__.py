"""A crank-rocker from the coefficient K of its quick return: the circle that sees C₁C₂ under θ, or a ray under θ."""
