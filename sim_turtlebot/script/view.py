#!/usr/bin/env python3
"""Show the robots in a browser, by their topics: simulated ones and real ones.

Subscribes, for each robot, while a page is open:
    odom (nav_msgs/Odometry): the robot's odometry
    base_pose_ground_truth (nav_msgs/Odometry): where a simulated robot really is
    joint_states (sensor_msgs/JointState): the wheels
    moved_distance (std_msgs/Float64): metres travelled, from odom_movement_detector
    rotate_robot/target (std_msgs/Float64): heading in degrees, for rotate.py

Subscribes, always:
    sim_turtlebot/warning (std_msgs/String): what the simulator warns of

Publishes:
    cmd_vel (geometry_msgs/Twist): while the pad is held; zero when it is released

Calls:
    sim_turtlebot/pause_physics, unpause_physics, reset_simulation (std_srvs/Empty)

Parameters:
    ~port (int, 8080): where the page is
    ~host (str, localhost): name or address to listen on; 0.0.0.0 lets the network in, and
        whoever sees the page can drive the robot
    ~allowed_hosts (str, none): further names of the page, where a proxy or a forwarded port gives
        it others: with or without a port, separated by commas or spaces. It is always reached as
        localhost, as ~host and by the address of this machine; who comes by another name, or from
        another page, is refused
"""

from odometry_common.node import run_node
from odometry_common.parameters import StartError
from robot_view.address import read_address


def main():
    """View until shutdown."""
    address = read_address()
    try:
        from robot_view.node import view
    except ModuleNotFoundError as error:
        raise StartError(f'{error.name} is not installed; sim_turtlebot/requirements-view.txt '
                         'lists what the page needs: pip install -r it') from None
    view(address)


if __name__ == '__main__':
    # Simulated time may stand still, and the page has nothing to do with it.
    run_node('view', main, __doc__, anonymous=True, disable_rostime=True)
