"""How much the tests guard: one small slip at a time is put into the program, and the tests must notice it."""
