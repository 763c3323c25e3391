"""Answer files: workbooks and tables as the answers form has them, long tables, YAML and JSON."""
