"""Billiards to play: the picture, the sound and the loop around the physics and the rules."""
