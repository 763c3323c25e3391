"""The claims about every problem of the library, made of members of the generators' families: what is said and drawn is
to be true of any problem."""
