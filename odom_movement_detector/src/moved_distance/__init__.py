"""The arithmetic of the detector."""
