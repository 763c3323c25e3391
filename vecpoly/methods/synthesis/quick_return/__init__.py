"""Crank and guide bar by K: the shaper, whose bar swings, and Whitworth's quick return, whose bar turns round."""
