"""Players: how well a level carries out a stroke, and an opponent that looks for one."""
