"""The subject of a course report: the problem, its drawing, its exact cycle and its model, computed once."""
