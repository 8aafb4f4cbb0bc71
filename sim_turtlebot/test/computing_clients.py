"""Robot clients that let other processes and threads work for them.

usage: computing_clients.py KIND
"""

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from clients import main


def work(x):
    sum(range(200_000))
    return x


def long(robot):
    """Compute for three seconds, as SLAM does, before each of the first two commands."""
    for number, x in enumerate(iter(robot.seen.get, None)):
        end = time.process_time() + (3.0 if number < 2 else 0.0)
        while time.process_time() < end:
            pass
        robot.drive(x)


def program(robot):
    for x in iter(robot.seen.get, None):
        code = f'print({x} + 0 * sum(range(200_000)))'
        done = subprocess.run([sys.executable, '-c', code], stdout=subprocess.PIPE, check=True)
        robot.drive(float(done.stdout))


def fork(robot):
    for x in iter(robot.seen.get, None):
        reader, writer = os.pipe()
        if not os.fork():
            # On Ctrl-C, rospy's handler would wait for threads that the child does not have.
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            os.write(writer, str(work(x)).encode())
            os._exit(0)
        os.wait()
        robot.drive(float(os.read(reader, 99)))
        os.close(reader)
        os.close(writer)


def processes(robot):
    pool = multiprocessing.Pool(2)
    for x in iter(robot.seen.get, None):
        robot.drive(pool.apply(work, [x]))


def threads(robot):
    pool = ThreadPoolExecutor(2)
    for x in iter(robot.seen.get, None):
        robot.drive(pool.submit(work, x).result())


if __name__ == '__main__':
    main(globals())
