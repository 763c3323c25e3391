"""A crank-rocker from its time ratio K: the circle that sees C₁C₂ under θ, or a ray under θ."""
