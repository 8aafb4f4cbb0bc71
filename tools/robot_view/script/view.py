#!/usr/bin/env python3
"""Show robots, simulated or real, in a browser.

Everybody who opens the page can drive the robot.

Subscribes:
    odom, base_pose_ground_truth (nav_msgs/Odometry): each robot's odometry, and true pose
    joint_states (sensor_msgs/JointState): the wheels
    scan (sensor_msgs/LaserScan): in the frame camera_depth_frame
    moved_distance (std_msgs/Float64): metres travelled
    rotate_robot/target (std_msgs/Float64): heading in degrees, for rotate.py
    sim_turtlebot/world_markers (visualization_msgs/MarkerArray): the world
    map (nav_msgs/OccupancyGrid): its occupied cells
    move_base/NavfnROS/plan (nav_msgs/Path): move_base's plan
    amcl_pose (geometry_msgs/PoseWithCovarianceStamped): amcl's estimate of the pose
    sim_turtlebot/warning (std_msgs/String): shown in the panel

Publishes:
    cmd_vel (geometry_msgs/Twist): while a button of the pad is held, then zero
    moved_distance/reset (std_msgs/Empty): reset
    sim_turtlebot/set_pose, sim_turtlebot/robot_k/set_pose (geometry_msgs/PoseStamped): from the
        panel

Calls:
    sim_turtlebot/pause_physics, sim_turtlebot/unpause_physics,
        sim_turtlebot/reset_simulation (std_srvs/Empty): the panel's buttons
"""

from odometry_common.node import run_node
from odometry_common.parameters import StartError
from robot_view.address import PARAMETERS, read_address
from robot_view.robots import Robots

FIRST_ROBOT_TIMEOUT = 2.0  # s


def main():
    """View until shutdown."""
    address = read_address()
    parameters = PARAMETERS.read()
    robots = Robots(distance_target=parameters.target or None,
                    heading_target=parameters.heading_target or None)
    # Otherwise a robot that starts now drives while viser is imported, and its messages are missed.
    robots.found.wait(FIRST_ROBOT_TIMEOUT)
    try:
        from robot_view.browser_page import BrowserPage
    except ModuleNotFoundError as error:
        raise StartError(f'{error.name} is not installed; tools/robot_view/requirements.txt '
                         'lists what the page needs: pip install -r it') from None
    page = BrowserPage(address, robots)
    print(f'view: {address.url}')
    page.run()


if __name__ == '__main__':
    # disable_rostime: simulated time may stand still, and the page does not need it.
    run_node('view', main, __doc__, PARAMETERS, anonymous=True, disable_rostime=True)
