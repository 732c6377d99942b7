"""What several tests use: players, referees, 50-digit numbers, records, pictures."""
