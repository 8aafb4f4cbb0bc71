"""The same yaw on each processor, whichever kernel OpenBLAS takes there."""

import os
import platform
import sys

import pytest
from odometry_tests.processes import Process

KERNELS = 'Sandybridge', 'Haswell', 'Zen'
SCRIPT = """
import hashlib, random
import numpy
from tf.transformations import euler_from_quaternion
numbers = random.Random(0)
angles = [euler_from_quaternion([numbers.uniform(-1, 1) for _ in range(4)]) for _ in range(20000)]
print(numpy.__file__, hashlib.sha256(repr(angles).encode()).hexdigest())
"""


@pytest.fixture(scope='module')
def python(tmp_path_factory):
    """Return a Python with the numpy of PyPI, which has an OpenBLAS of its own."""
    folder = tmp_path_factory.mktemp('numpy')
    for command in ([sys.executable, '-m', 'venv', '--system-site-packages', folder],
                    [folder / 'bin/python3', '-m', 'pip', 'install', '--quiet', '--ignore-installed', 'numpy']):
        run = Process(*command)
        assert run.wait(300.0) == 0, run.output
    return folder / 'bin/python3'


@pytest.mark.nightly
@pytest.mark.skipif(platform.machine() != 'x86_64', reason='these are kernels of x86-64')
def test_the_yaw_is_the_same_with_every_kernel(python):
    results = set()
    for kernel in (os.environ['OPENBLAS_CORETYPE'], *KERNELS):
        run = Process('env', f'OPENBLAS_CORETYPE={kernel}', python, '-c', SCRIPT)
        assert run.wait(60.0) == 0, run.output
        results.add(tuple(run.stdout.split()))
    (path, _), = results
    assert path.startswith(str(python.parents[1])), path
