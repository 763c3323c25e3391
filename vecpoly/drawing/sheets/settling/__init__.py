"""Of all ways in which the figures of a page may stand, the one that costs a reader least."""
