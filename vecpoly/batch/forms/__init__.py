"""Tables that people fill in or take elsewhere: the answers form, the key, columns of other platforms."""
