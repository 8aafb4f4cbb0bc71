"""Judge a learner's node by what it makes the simulated robot do."""
