"""Worlds and shots as plain data, and the JSON files that hold them."""
