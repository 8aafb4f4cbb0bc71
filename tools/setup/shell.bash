# ./ws shell reads this in place of ~/.bashrc. It sources that first, since ~/.bashrc may change PATH
# and ROS's address.
address=$(declare -p ROS_HOSTNAME ROS_IP 2>/dev/null)
[ ! -f ~/.bashrc ] || . ~/.bashrc
unset ROS_HOSTNAME ROS_IP
eval "$address"
. "$ODOMETRY_ROOT/tools/setup/enter.bash"
PS1="(ws) $PS1"

# Debian loads the completion of ROS's commands only with the package bash-completion.
complete -p rostopic &>/dev/null || . /usr/share/bash-completion/completions/rosbash 2>/dev/null

# Install what some launch arguments and programs need when you first type them.
roslaunch() { "$ODOMETRY_ROOT/ws" --set-up roslaunch "$@" && command roslaunch "$@"; }
rosrun() { "$ODOMETRY_ROOT/ws" --set-up rosrun "$@" && command rosrun "$@"; }
