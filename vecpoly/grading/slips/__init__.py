"""Which slip explains a wrong value: the solutions of those who make one mistake, slips with units and signs."""
