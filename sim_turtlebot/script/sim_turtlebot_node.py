#!/usr/bin/env python3
"""Simulate a TurtleBot 2 in PyBullet.

Subscribes:
    cmd_vel, mobile_base/commands/velocity (geometry_msgs/Twist): linear.x up to 0.7 m/s,
        angular.z up to 180 degrees/s; the rest is ignored
    cmd_vel_mux/input/teleop, cmd_vel_mux/input/navi (geometry_msgs/Twist): the same through a
        multiplexer: teleop blocks navi until one second after its last message
    mobile_base/commands/reset_odometry (std_msgs/Empty): odometry back to zero; the robot stays
    ~set_pose (geometry_msgs/PoseStamped): places the robot there, at rest, unless something is in
        the way; z is 0 on the floor, frame_id world or empty. Of several robots ~robot_k/set_pose

Publishes:
    odom (nav_msgs/Odometry): odom -> base_footprint
    base_pose_ground_truth (nav_msgs/Odometry): the true pose, in the frame world
    joint_states (sensor_msgs/JointState): both wheels
    mobile_base/sensors/imu_data (sensor_msgs/Imu): the gyro's heading, zero where odom is, and
        rate
    scan (sensor_msgs/LaserScan): with ~scan, what the depth camera sees
    /tf (tf2_msgs/TFMessage): odom -> base_footprint, base_link -> wheels
    /tf_static (tf2_msgs/TFMessage): latched; base_footprint -> base_link -> the URDF's fixed frames
    /clock (rosgraph_msgs/Clock): when /use_sim_time is true
    ~world_markers (visualization_msgs/MarkerArray): latched; the world file's shapes
    ~warning (std_msgs/String): latched; the machine is too slow, a robot lies on its side, a pose
        was refused, models of the world are left out; empty otherwise

Services:
    ~step (std_srvs/Trigger): while paused, advance to the next odometry; answers with its stamp
    ~pause_physics, ~unpause_physics (std_srvs/Empty): as Gazebo's
    ~reset_simulation (std_srvs/Empty): everything back to the start: time, header.seq, odometry,
        noise, commands, and poses, a world file's too. A paused simulation stays paused
"""

from odometry_common.node import run_node
from sim_turtlebot.settings import PARAMETERS
from sim_turtlebot.simulator import simulate

if __name__ == '__main__':
    # disable_rostime: this node publishes the clock, so it must not wait for one.
    run_node('sim_turtlebot', simulate, __doc__, PARAMETERS, disable_rostime=True)
