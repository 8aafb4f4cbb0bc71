"""A browser page that shows and drives robots through their topics and services."""
