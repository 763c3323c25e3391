"""A construction in the hands of other programs: CAD drawings (DXF), and constructions that move (GeoGebra)."""
