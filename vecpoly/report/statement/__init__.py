"""What a problem says of itself: its structure, what is asked, many quantities by kinds."""
