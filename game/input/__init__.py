"""What keys, characters and the mouse mean."""
