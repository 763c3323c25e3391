"""Pages: sheets that float in the text, parts that share a page, parts that are set more tightly."""
