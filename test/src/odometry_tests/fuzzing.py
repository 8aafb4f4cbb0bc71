"""Values and numbers of sequences for tests with random sequences of events."""

from hypothesis import settings
from hypothesis import strategies as st

from odometry_tests.messages import STRANGE

SEQUENCES, NIGHTLY_SEQUENCES = 300, 10000
PHYSICS_SHARE = 10  # a sequence in the physics takes as long as hundreds of pieces of arithmetic

any_number = st.one_of(st.sampled_from([*STRANGE, 1.7e308, -5e-324]), st.floats())


def sequence_count(share=1):
    """Return how many sequences to try; by day only one in `share` of them."""
    nightly = settings.default.max_examples == NIGHTLY_SEQUENCES
    return NIGHTLY_SEQUENCES if nightly else SEQUENCES // share
