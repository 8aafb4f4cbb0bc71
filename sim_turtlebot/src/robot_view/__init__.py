"""A page in the browser that shows robots and drives them, all by their topics and services."""
