"""What the tests share: bounded waits, recorded topics, processes of their own."""
