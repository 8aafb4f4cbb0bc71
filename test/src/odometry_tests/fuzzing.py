"""Values and numbers of sequences for tests with random sequences of events."""

import math

from hypothesis import settings
from hypothesis import strategies as st

SEQUENCES, NIGHTLY_SEQUENCES = 300, 10000
PHYSICS_SHARE = 10  # a sequence in the physics takes as long as hundreds of pieces of arithmetic

STRANGE = [math.nan, math.inf, -math.inf, 1e308, -1e308, 1.7e308, 5e-324, -5e-324, -0.0]

any_number = st.one_of(st.sampled_from(STRANGE), st.floats())


def sequence_count(share=1):
    """Return how many sequences to try; by day only one in `share` of them."""
    nightly = settings.default.max_examples == NIGHTLY_SEQUENCES
    return NIGHTLY_SEQUENCES if nightly else SEQUENCES // share
