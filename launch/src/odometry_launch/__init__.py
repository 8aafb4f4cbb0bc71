"""The demo: a tutorial with a simulated robot, watched from its topics."""
