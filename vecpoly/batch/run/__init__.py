"""The work shared out and kept: processes, clusters, what was done already."""
