"""The balancing load by power: virtual power, the Zhukovsky lever, efficiency."""
