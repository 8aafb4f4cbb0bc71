"""Runs of nodes beside the simulated robot: start, follow, record and draw them."""
