"""What marking writes: grade tables, feedback sheets, item analysis, the queue."""
