"""What is seen and touched on the table."""
