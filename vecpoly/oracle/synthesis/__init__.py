"""Closed forms of the synthesis of linkages; a stranger to everything drawn."""
