// A robot client in C++: `client rate`, `client timer`, `client spinners` or `client usleep` commands an
// angular velocity that shows what it has seen.
#include <string>

#include <unistd.h>

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "client");
  ros::NodeHandle node;
  const std::string kind = argc > 1 ? argv[1] : "rate";
  const ros::Publisher publisher = node.advertise<geometry_msgs::Twist>("cmd_vel", 10);
  double x = 0.0;

  const auto drive = [&] {
    geometry_msgs::Twist command;
    command.linear.x = 0.2;
    command.angular.z = x;
    publisher.publish(command);
  };
  const ros::Subscriber subscriber = node.subscribe<nav_msgs::Odometry>(
      "odom", 10, [&](const nav_msgs::Odometry::ConstPtr& message) { x = message->pose.pose.position.x; });

  if (kind == "rate") {
    for (ros::Rate loop(10); ros::ok(); loop.sleep()) {
      ros::spinOnce();
      drive();
    }
    return 0;
  }
  if (kind == "usleep") {
    for (; ros::ok(); usleep(100000)) {
      ros::spinOnce();
      drive();
    }
    return 0;
  }
  const ros::Timer timer = node.createTimer(ros::Duration(0.1), [&](const ros::TimerEvent&) { drive(); });
  if (kind == "spinners")
    ros::MultiThreadedSpinner(4).spin();
  else
    ros::spin();
}
