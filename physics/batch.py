"""Many shots of one scene: arrays in, arrays out."""
