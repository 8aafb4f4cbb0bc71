"""The arithmetic of the mover."""
