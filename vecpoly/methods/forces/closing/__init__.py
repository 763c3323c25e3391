"""The link that carries the balancing load: the last polygon, or a couple."""
