"""Settings of the unit tests."""

import os

from hypothesis import settings
from odometry_tests.fuzzing import NIGHTLY_SEQUENCES

settings.register_profile('ci', deadline=None)
settings.register_profile('nightly', max_examples=NIGHTLY_SEQUENCES, deadline=None)
settings.load_profile(os.environ.get('HYPOTHESIS_PROFILE', 'ci'))
