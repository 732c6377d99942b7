"""The next shot: its five numbers, ways to change them, and what they would do."""
