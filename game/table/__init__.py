"""What is played on: tables to begin with, and where balls lie on them."""
