"""The text of a problem file before it is YAML:
full-width signs made narrow, and what the YAML reader refuses, in words."""
