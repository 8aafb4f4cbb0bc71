#!/usr/bin/env python3
"""Simulate a TurtleBot 2 in PyBullet.

Subscribes:
    cmd_vel, mobile_base/commands/velocity (geometry_msgs/Twist): linear.x, angular.z
    mobile_base/commands/reset_odometry (std_msgs/Empty): odometry back to zero

Publishes:
    odom (nav_msgs/Odometry): odom -> base_footprint
    base_pose_ground_truth (nav_msgs/Odometry): where the robot really is, in the world
    joint_states (sensor_msgs/JointState): both wheels
    /tf (tf2_msgs/TFMessage): odom -> base_footprint
    /clock (rosgraph_msgs/Clock): when /use_sim_time is true
    ~warning (std_msgs/String): that the machine is too slow; empty otherwise; latched

Services (std_srvs/Empty):
    ~pause_physics, ~unpause_physics, ~reset_simulation

Parameters:
    ~gui (bool, false): open PyBullet's window
    ~world (str, ''): URDF or SDF file to load beside the floor
    ~robots (int, 1): more than one share a world, robot k in namespace robot_k
    ~x, ~y, ~yaw (float, 0.0 m, m, rad): where the robot starts
    ~odom_rate (float, 20 Hz): odometry messages per simulated second
    ~odometry_source (str, world): world is the true pose, encoder counts wheel ticks
    ~gyro (bool, false): encoder takes the yaw from a gyro
    ~wheel_slip (float, 0.0): encoder, share of the wheels' travel that moves nothing
    ~wheel_noise (float, 0.0 m): encoder, deviation of a wheel's travel after one metre
    ~gyro_noise (float, 0.0 rad): encoder, deviation of the gyro's yaw after one second
    ~seed (int, 0): for the noise
    ~cmd_vel_timeout (float, 0.6 s): stop when commands cease; 0 turns it off
    ~real_time_factor (float, 1.0): simulated seconds per second; 0: as fast as possible
    ~lockstep_rate (float, 0.0 Hz): do not pass a multiple of 1/rate without a command; 0 is off
    ~lockstep_patience (float, 2.0 s of wall time): go on without a controller silent for so long
"""

from sim_turtlebot.node import main

if __name__ == '__main__':
    main(__doc__)
