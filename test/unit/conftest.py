"""Settings of the unit tests.

By day the examples are the same each time, so that only a change makes a test fail; by night new
ones are tried.
"""

import os

from hypothesis import settings
from odometry_tests.fuzzing import NIGHTLY_SEQUENCES

settings.register_profile('ci', derandomize=True, deadline=None)
settings.register_profile('nightly', derandomize=False, max_examples=NIGHTLY_SEQUENCES,
                          deadline=None)
settings.load_profile(os.environ.get('HYPOTHESIS_PROFILE', 'ci'))
