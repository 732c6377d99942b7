"""What is proven of the players."""
