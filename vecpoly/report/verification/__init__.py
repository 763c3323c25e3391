"""What each solution of a synthesis does, as it is moved with the lengths read: a table, its heads, a sentence."""
