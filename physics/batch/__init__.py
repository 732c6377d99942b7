"""Many shots of one scene: arrays in and out, the compiled kernel, and the command for ranges."""
