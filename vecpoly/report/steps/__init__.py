"""The numbered steps of a solution as a report sets them: sentences, equations, formulas, tables."""
