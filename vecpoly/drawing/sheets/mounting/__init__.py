"""Figures of a page that is cut into pieces, where they look even: spread over it, from its frame, about one middle."""
