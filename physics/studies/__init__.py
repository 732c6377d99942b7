"""What can be learnt from a shot: paths, energy, how much it depends on, how it was struck."""
