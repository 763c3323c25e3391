"""Where a mechanism can be assembled, which of two assemblies is meant, and the change points at which they meet."""
