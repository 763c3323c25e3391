"""CAD drawings (DXF): figures in mm on layers by what a line is for."""
