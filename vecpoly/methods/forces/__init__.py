"""Graphical statics of mechanisms: groups from the far end, each free body,
force polygons to μ_F, friction circles and angles."""
