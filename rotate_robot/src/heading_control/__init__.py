"""The arithmetic of rotate.py."""
