"""What the player sees and touches: views draw from the game's state and change none of it."""
