"""The command line: one small file per command; nothing heavy is imported before a command runs."""

from __future__ import annotations

from .app import app, main

__all__ = ["app", "main"]
