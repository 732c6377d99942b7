"""What is proven of the rules."""
