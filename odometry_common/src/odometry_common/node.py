"""How a node starts, prints and ends."""

import os
import signal
import sys
import threading

import rospy

from odometry_common.parameters import ParameterError, check_command_line

EXIT_BAD_PARAMETER = 2


def run_node(name, main, **init_node_options):
    """Run a node from start to end and exit the process.

    :param name: node name
    :param main: function without arguments; returns when the node is done
    :param init_node_options: passed on to rospy.init_node

    The exit status is 0, or 2 with one line on stderr if a parameter is unusable.
    However main() ends, rospy's shutdown hooks have run before the process exits.
    """
    try:
        check_command_line()
        rospy.init_node(name, **init_node_options)
        _shut_down_on_signals()
        main()
    except ParameterError as error:
        print(f'{name}: {error}', file=sys.stderr)
        sys.exit(EXIT_BAD_PARAMETER)
    except rospy.ROSInterruptException:
        pass
    except rospy.ROSInitException:
        if not rospy.is_shutdown():
            raise
    finally:
        rospy.signal_shutdown('the node has ended')


def print_line(text):
    """Print a line at once, and end the node quietly if nobody reads it any more.

    The reader of ``rosrun ... | head`` goes away while the node still has lines to print.
    """
    try:
        print(text, flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        rospy.signal_shutdown('nobody reads stdout')


def _shut_down_on_signals():
    """Let Ctrl-C, SIGTERM and a closed terminal shut the node down from a thread of its own.

    rospy would run the shutdown hooks inside the signal handler, on top of whatever the
    main thread is doing: a hook that publishes could then wait for a lock that its own
    thread holds, or cut in front of a message that is half written.
    """
    def shut_down(signum, _frame):
        reason = signal.Signals(signum).name
        threading.Thread(target=rospy.signal_shutdown, args=[reason]).start()

    for signum in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(signum, shut_down)
