"""Random sequences of events: values, how many, and the settings of hypothesis.

The profile ci always tries the same examples, so that only a change makes a test fail; nightly tries
new ones.
"""

import os

from hypothesis import settings
from hypothesis import strategies as st

from odometry_tests.messages import STRANGE

SEQUENCES, NIGHTLY_SEQUENCES = 300, 10000
PHYSICS_SHARE = 10  # a sequence in the physics takes as long as hundreds of pieces of arithmetic

any_number = st.one_of(st.sampled_from([*STRANGE, 1.7e308, -5e-324]), st.floats())


def load_profile():
    """Use the settings that HYPOTHESIS_PROFILE names: ci or nightly."""
    settings.register_profile('ci', derandomize=True, deadline=None)
    settings.register_profile('nightly', derandomize=False, max_examples=NIGHTLY_SEQUENCES,
                              deadline=None)
    settings.load_profile(os.environ.get('HYPOTHESIS_PROFILE', 'ci'))


def sequence_count(share=1):
    """Return how many sequences to try; in the profile ci, one in `share`."""
    nightly = settings.default.max_examples == NIGHTLY_SEQUENCES
    return NIGHTLY_SEQUENCES if nightly else SEQUENCES // share
