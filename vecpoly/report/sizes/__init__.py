"""Letters of what is given, on the sketch beside a statement: dimension lines, radii, angles, by sorts of subject."""
