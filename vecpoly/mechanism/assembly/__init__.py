"""Which of several assemblies is meant, as the branch statements and the data say."""
