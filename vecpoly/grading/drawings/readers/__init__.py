"""One file per format: each gives segments in mm, arrow heads and lettering, and refuses what it cannot read."""
