"""The mechanism as a machine: its equivalent link by the velocity polygon."""
