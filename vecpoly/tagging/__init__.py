"""The PDF as a document: its structure tree, links, metadata and spoken formulas, written in few bytes (PDF/UA-1)."""
