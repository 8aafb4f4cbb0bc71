"""What the tests share: waits with a timeout, recorded topics, processes."""
