# What ./ws shell reads in place of ~/.bashrc, which it reads first: that may put another
# python3 first on PATH, and ROS on another address than ./ws was told.
address=$(declare -p ROS_HOSTNAME ROS_IP 2>/dev/null)
[ ! -f ~/.bashrc ] || . ~/.bashrc
unset ROS_HOSTNAME ROS_IP
eval "$address"
. "$ODOMETRY_ROOT/setup/enter.bash"
PS1="(ws) $PS1"

# Debian has completion of ROS's commands only beside the package bash-completion.
complete -p rostopic &>/dev/null || . /usr/share/bash-completion/completions/rosbash 2>/dev/null

# What some launch arguments and programs need is installed when they are first typed.
roslaunch() { "$ODOMETRY_ROOT/ws" --set-up roslaunch "$@" && command roslaunch "$@"; }
rosrun() { "$ODOMETRY_ROOT/ws" --set-up rosrun "$@" && command rosrun "$@"; }
