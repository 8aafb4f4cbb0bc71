# What ./ws shell reads in place of ~/.bashrc, which it reads first: that may put another
# python3 first on PATH.
[ ! -f ~/.bashrc ] || . ~/.bashrc
. "$ODOMETRY_ROOT/.ws/devel/setup.bash"
PATH=$ODOMETRY_ROOT/.venv/bin:$PATH
PS1="(ws) $PS1"

# view:=true, rviz:=true and gui:=true need parts that are installed when they are first asked for.
roslaunch() { "$ODOMETRY_ROOT/ws" --set-up roslaunch "$@" && command roslaunch "$@"; }
rosrun() { "$ODOMETRY_ROOT/ws" --set-up rosrun "$@" && command rosrun "$@"; }
