"""Designs checked: what was found is moved, what serves instead of data that do not is told."""
