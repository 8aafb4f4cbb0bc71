"""Random sequences of events: their numbers, and how many to try.

The profile ci always tries the same, so that only a change makes a test fail; nightly tries new ones.
"""

from hypothesis import settings
from hypothesis import strategies as st

from odometry_tests.messages import STRANGE

settings.register_profile('ci', derandomize=True, deadline=None)
settings.register_profile('nightly', max_examples=1000, deadline=None)

any_number = st.one_of(st.sampled_from([*STRANGE, 1.7e308, -5e-324]), st.floats())
