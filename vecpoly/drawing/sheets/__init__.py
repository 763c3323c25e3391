"""A4 sheets: figures placed true to scale, pages shared, frame and title strip."""
