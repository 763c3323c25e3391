"""Kinematic geometry of one moving link: inflection circle, centres of curvature of paths, centrodes."""
