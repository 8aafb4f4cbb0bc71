"""When time goes on: once every process of the graph is idle."""
