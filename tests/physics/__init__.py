"""What is proven of the physics."""
