"""A game as a value to play: actions change it, time moves it, and it needs no window."""
