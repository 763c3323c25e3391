"""The kinematic diagram: links, gears, cams and cylinders with the symbols of GB/T 4460."""
