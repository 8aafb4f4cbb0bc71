"""Advance simulated time only when every process of the graph is idle."""
