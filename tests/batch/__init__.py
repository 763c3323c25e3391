"""A class: rosters, sheets, registers, forms."""
