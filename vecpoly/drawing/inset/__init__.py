"""The small figure beside a vector equation: the polygon that this equation draws, as the sheet has it, and nothing
else."""
