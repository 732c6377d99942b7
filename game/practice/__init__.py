"""Practice: drills with a goal, what is reached in them, and the best that is kept."""
