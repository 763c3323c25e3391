"""What is known of each sort of problem from elsewhere than its drawing: one file a sort."""
