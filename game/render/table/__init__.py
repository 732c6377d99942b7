"""The table, true to scale: cloth, rails, balls, cue and lines."""
