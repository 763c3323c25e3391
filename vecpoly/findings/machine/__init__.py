"""The machine in motion: its flywheel tried out, what it does to its frame, and why either cannot be told."""
