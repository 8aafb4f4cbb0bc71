// A robot client in C++: `client rate`, `client timer`, `client spinners` or `client usleep` commands an
// angular velocity that shows what it has seen. `client partners` commands the times (s) at which it has begun
// and ended a computation, as linear.x and linear.y.
#include <ctime>
#include <string>
#include <thread>

#include <unistd.h>

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

const int ROUNDS = 50;

void compute(double seconds) {
  for (const std::clock_t end = std::clock() + seconds * CLOCKS_PER_SEC; std::clock() < end;) {
  }
}

// Let two threads compute in turn: each sleeps while it waits for the other.
void compute_in_turn() {
  int there[2], back[2];
  if (pipe(there) || pipe(back))
    return;
  char baton = 0;
  std::thread partner([&] {
    for (int round = 0; round < ROUNDS && read(there[0], &baton, 1) == 1; ++round)
      if (write(back[1], &baton, 1) != 1)
        return;
  });
  for (int round = 0; round < ROUNDS; ++round) {
    compute(0.002);
    if (write(there[1], &baton, 1) != 1 || read(back[0], &baton, 1) != 1)
      break;
  }
  partner.join();
  for (int end : {there[0], there[1], back[0], back[1]})
    close(end);
}

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
  if (kind == "partners") {
    for (ros::Rate loop(10); ros::ok(); loop.sleep()) {
      geometry_msgs::Twist times;
      times.linear.x = ros::Time::now().toSec();
      compute_in_turn();
      times.linear.y = ros::Time::now().toSec();
      publisher.publish(times);
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
