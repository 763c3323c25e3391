"""Groups of class III: a central link on three legs, by moments about special points."""
