"""The browser window: robots seen by their topics, drawn with viser."""
