"""Claims about grading: keys, what students write, comparison, follow-through, marks."""
