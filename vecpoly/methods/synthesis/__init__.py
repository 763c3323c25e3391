"""How linkages are found on paper: one task of synthesis, one file, or a folder where it has several ways."""
