"""Problem files: their schema, their loader, and the library."""
