"""What the steps of a cam's construction say."""
