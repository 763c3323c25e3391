"""What the places of labels cost: by what they stand on, and beside each other."""
