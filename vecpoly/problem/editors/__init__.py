"""What editors know of a problem file:
its JSON Schema, with patterns for values and a description of every key in both languages."""

from .schema import ID, json_schema

__all__ = ["ID", "json_schema"]
