"""Run a tutorial or a launch file many times; a package called sweep would hide behind sweep.py."""
