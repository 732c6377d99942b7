"""Games written down and played again: records and scripts."""
