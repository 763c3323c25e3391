"""A cam by inversion: displacement diagram, pitch curve, profile, pressure angle, curvature, least base circle."""
