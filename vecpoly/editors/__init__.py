"""What editors know of every kind of file: problems, assignments, design projects, searches."""

from .schema import file_schema

__all__ = ["file_schema"]
