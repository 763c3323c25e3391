"""The legend of a sheet: what its lines, arrows and small symbols stand for, each by a sample."""
