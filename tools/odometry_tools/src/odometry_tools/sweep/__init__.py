"""Run a tutorial or a launch file many times."""
