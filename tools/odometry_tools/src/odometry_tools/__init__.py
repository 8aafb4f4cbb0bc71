"""The demo, the judge and the sweep, which run nodes beside the simulated robot."""
