"""What a player has chosen, and the files in which it is kept."""
