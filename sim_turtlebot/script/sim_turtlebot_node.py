#!/usr/bin/env python3
"""Simulate a TurtleBot 2 in PyBullet.

Subscribes:
    cmd_vel, mobile_base/commands/velocity (geometry_msgs/Twist): linear.x up to 0.7 m/s,
        angular.z up to 180 degrees/s; the rest is ignored
    cmd_vel_mux/input/teleop, cmd_vel_mux/input/navi (geometry_msgs/Twist): the same by way of a
        TurtleBot 2's multiplexer: nothing comes through navi while teleop speaks, and for one
        second after
    mobile_base/commands/reset_odometry (std_msgs/Empty): odometry back to zero; the robot stays
    ~set_pose (geometry_msgs/PoseStamped): puts the robot there, at rest; z is 0 where it stands on
        the floor, and frame_id world or empty. Of several robots ~robot_k/set_pose; where there is
        no room, it is refused with a warning

Publishes:
    odom (nav_msgs/Odometry): odom -> base_footprint
    base_pose_ground_truth (nav_msgs/Odometry): where the robot really is, in the frame world
    joint_states (sensor_msgs/JointState): both wheels
    mobile_base/sensors/imu_data (sensor_msgs/Imu): the gyro's heading, zero where odom is, and
        its rate, in the frame gyro_link
    scan (sensor_msgs/LaserScan): with ~scan, what the depth camera sees at its height
    /tf (tf2_msgs/TFMessage): odom -> base_footprint, base_link -> wheels
    /tf_static (tf2_msgs/TFMessage): latched; base_footprint -> base_link -> the URDF's fixed frames
    /clock (rosgraph_msgs/Clock): when /use_sim_time is true
    ~warning (std_msgs/String): latched; that the machine is too slow for the real-time factor,
        and which one it reaches; which robot lies on its side, and where; empty otherwise

Services:
    ~pause_physics, ~unpause_physics (std_srvs/Empty): as Gazebo's. Each service answers when it is
        done, and fails after 5 s of wall time; a call that has not begun by then has no effect
    ~reset_simulation (std_srvs/Empty): back to the start: simulated time and header.seq are zero;
        robots, and whatever a world file adds, are at their first poses, at rest; odometry and gyro
        are zero; the noise repeats its random numbers; the multiplexer is open to every input; all
        commands are forgotten. It takes back the ~warning of a robot on its side, but not that of
        a slow machine. A paused simulation stays paused

Parameters:
    ~gui (bool, false): open PyBullet's window
    ~world (str, ''): URDF or SDF file to load beside the floor; refused if it cannot be loaded,
        or if a robot would start inside something
    ~robots (int, 1, from 1 to 1000): more than one share a world, robot k in namespace robot_k,
        one metre to the left of the one before
    ~x, ~y (float, 0.0 m, from -10000 to 10000): where the robot starts; odom is zero there
    ~yaw (float, 0.0 rad, from -2 pi to 2 pi): its heading there
    ~odom_rate (float, 20 Hz, from 0.1 to 1000): odometry messages per simulated second
    ~clock_rate (float, 0.0 Hz, 0 or from ~odom_rate to 1000): ticks of /clock per simulated second,
        or as few more as divide the time between two odometry messages evenly; 0 is 200,
        but about 1000 per second of wall time at most, 100 in lockstep, and else one with each odometry if
        unpaced
    ~odometry_source (str, world, world or encoder): world is the true pose, encoder counts
        wheel ticks
    ~gyro (bool, true): encoder: take the yaw from the gyro, as a Kobuki does, not from the wheels
    ~wheel_slip (float, 0.0, from 0 to below 1): encoder: share of the wheels' travel that moves
        nothing
    ~wheel_noise (float, 0.0 m, from 0 to 1): encoder: standard deviation of a wheel's travel
        after one metre
    ~gyro_noise (float, 0.0 rad, from 0 to 1): standard deviation of the gyro's yaw after one
        second
    ~gyro_drift (float, 0.0 rad/s, from -1 to 1): bias of the gyro, also at rest
    ~scan (bool, false): publish scans; their beams meet whatever a robot can run into
    ~scan_rate (float, 10.0 Hz, from 0.1 to ~odom_rate): scans per simulated second, each with an
        odometry of the same stamp; lower if ~odom_rate is
    ~scan_beams (int, 640, from 2 to 10000): ranges in a scan
    ~scan_fov (float, 1.012 rad, from 0.01 to 2 pi): angle from the first beam to the last
    ~scan_range_min (float, 0.45 m, from 0 to 100): what is nearer is -inf
    ~scan_range_max (float, 10.0 m, above ~scan_range_min and up to 1000): where nothing is nearer,
        +inf
    ~scan_noise (float, 0.0 m, from 0 to 1): standard deviation of a range
    ~seed (int, 0, from -2147483648 to 2147483647): for the noise
    ~cmd_vel_timeout (float, 0.6 s, from 0 to 3600): stop when commands cease for this long; 0
        turns it off
    ~real_time_factor (float, 1.0, 0 or from 0.001 to 1000): simulated seconds per second; 0 is
        as fast as the machine can
    ~lockstep (bool, false): time goes on when every node on this machine has done what it has to do
        with the odometry and the clock of this moment
    ~paused (bool, false): time begins with ~unpause_physics
"""

import signal

# Python's own answer to Ctrl-C is a traceback; what is imported below takes its time.
signal.signal(signal.SIGINT, signal.SIG_DFL)

from odometry_common.node import run_node
from sim_turtlebot.node import simulate

if __name__ == '__main__':
    # disable_rostime: the clock is ours, so there is none to subscribe to and wait for.
    run_node('sim_turtlebot', simulate, __doc__, disable_rostime=True)
