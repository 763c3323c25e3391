"""All solutions of each task of synthesis in closed form; a stranger to the drawings of `methods/synthesis`."""
