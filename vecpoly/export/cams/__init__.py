"""The profile of a cam for a workshop: points as CSV, splines as DXF, each with its tolerance."""
