"""Cams: their follower, its motion, and what may be asked of them."""
