"""What is claimed about speed, accuracy and stability, as commands that anyone can rerun."""
