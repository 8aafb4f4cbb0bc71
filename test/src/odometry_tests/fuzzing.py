"""Values and numbers of sequences for tests with random sequences of events."""

import math

from hypothesis import settings
from hypothesis import strategies as st

NIGHTLY_SEQUENCES = 10000
PHYSICS_SHARE = 10  # a sequence in the physics takes as long as some ten pieces of arithmetic

STRANGE = [math.nan, math.inf, -math.inf, 1e308, -1e308, 1.7e308, 5e-324, -5e-324, -0.0]

any_number = st.one_of(st.sampled_from(STRANGE), st.floats())


def physics_settings():
    """Return settings with fewer sequences than the profile has, but for a nightly run."""
    count = settings.default.max_examples
    if count < NIGHTLY_SEQUENCES:
        count //= PHYSICS_SHARE
    return settings(max_examples=count, deadline=None)
