"""The structure of a mechanism: freedom counted, redundant constraints, Assur groups taken apart."""
