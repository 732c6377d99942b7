"""Carom billiards to play: the picture, the rules and the loop around the physics."""
