"""Balance of rotors: static, at fixed places, in two planes, by couples (Dalby), within a grade."""
