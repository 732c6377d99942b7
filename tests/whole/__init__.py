"""What holds for the whole project: its shape, its documents, its benchmarks."""
