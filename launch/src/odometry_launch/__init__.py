"""The demo: run a tutorial with a simulated robot, and follow it by its topics."""
