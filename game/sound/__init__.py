"""What is heard of a game."""
