"""How a key follows from the acts of a construction, its scatter by repeated hands, and the oracle's answers."""
