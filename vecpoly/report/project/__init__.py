"""The report of a design project: task, scheme, a chapter or two for each part, summary, sheets."""
