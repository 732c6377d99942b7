"""The games: what a stroke is worth, how a match stands, and an opponent to play it with.

Everything for people is a key of the texts; the rules read nothing but the event log.
"""
