"""The window's own things: what is drawn on, its clock, the clipboard, signals that close it."""
