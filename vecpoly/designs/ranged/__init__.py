"""The numbers of a task of which it is told where they had to lie, and how such a range is told."""
