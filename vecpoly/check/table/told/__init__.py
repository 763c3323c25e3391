"""The verdict in words: on a column, its wrong rows, the whole table."""
