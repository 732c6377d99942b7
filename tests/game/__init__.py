"""What is proven of the game in its window."""
