"""The formulas of the groups: RRR, RRP, RPR, crossing slides, rolling gears, and loops without a closed form."""
