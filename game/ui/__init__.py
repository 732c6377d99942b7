"""What the player sees and touches: every view draws from the game's state and changes none of it."""
