"""In ten minutes of the robot's time no process comes to need more and more."""

import signal

import psutil
import pytest
import rospy
from odometry_tests.pausing import call, pause
from odometry_tests.tutorial import Truth, detector, mover, simulator_in_step
from odometry_tests.waiting import wait_for_subscribers
from std_msgs.msg import Empty

PARTS, PART = 6, 100  # s of the robot's time
ALLOWED = 3.0, 2, 3  # more MB, threads, files

pytestmark = [pytest.mark.nightly, pytest.mark.usefixtures('simulated_time')]


def usage(process):
    found = psutil.Process(process.pid)
    return found.memory_info().rss / 2**20, found.num_threads(), found.num_fds()


def test_memory_threads_and_files_stay_the_same(master):
    truth = Truth()
    reset = rospy.Publisher('moved_distance/reset', Empty, queue_size=1)
    with simulator_in_step('_real_time_factor:=0', '_scan:=true') as robot, detector() as counter, \
            mover('_distance:=1000000') as driver:
        wait_for_subscribers(reset)
        used = []
        for _ in range(PARTS):
            with detector('__name:=killed') as killed:
                truth.wait_for(lambda m: m.header.stamp.to_sec() > PART, 120.0, 'the end of a part')
                killed.send(signal.SIGKILL)
                killed.wait()
            used.append({name: usage(process) for name, process in [
                ('simulator', robot), ('detector', counter), ('mover', driver), ('master', master)]})
            pause(truth)
            truth.clear()
            reset.publish()
            call('reset_simulation')
            call('unpause_physics')
    # The least of each half: the simulator's files follow the threads of the graph, which come and go.
    for name in used[0]:
        before, after = ([min(values) for values in zip(*(part[name] for part in half))]
                         for half in (used[:PARTS // 2], used[PARTS // 2:]))
        assert all(late - early <= allowed for early, late, allowed in zip(before, after, ALLOWED)), (name, used)
