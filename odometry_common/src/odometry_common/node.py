"""Start a node, set up its output, wait, and exit."""

import os
import signal
import sys
import threading
import time
import traceback

import rosgraph
import rospy

from odometry_common import node_help
from odometry_common.parameters import ParameterError, Parameters, StartError
from odometry_common.process_setup import (
    go_without_logs_if_necessary,
    open_output,
    raise_limit_on_files,
)
from odometry_common.rospy_fixes import fix_rospy
from odometry_common.signals import LONGEST_WAIT, interrupt_waits_by_signals, on_signals

EXIT_FAILURE = 1
EXIT_BAD_PARAMETER = 2
MASTER_RETRY_PERIOD = 0.5  # s
UNREGISTER_TIMEOUT = 0.4  # s, for a master that does not answer
NO_PARAMETERS = Parameters()

_failures = []  # exit status and text
_hooks_have_run = threading.Event()  # the final command has been sent
_unregistered = threading.Event()
_exit_lock = threading.Lock()
_pythons_excepthook = threading.excepthook  # Python before 3.10 has no threading.__excepthook__


def run_node(name, main, documentation, parameters=NO_PARAMETERS, **init_node_options):
    """Run a node from start to end and exit the process.

    :param name: node name
    :param main: function without arguments; returns when the node is done
    :param documentation: the first part of the node's --help
    :param parameters: the table of its Parameters
    :param init_node_options: passed on to rospy.init_node

    The exit status is 0, or 2 with one line on stderr if the node cannot start, or 1 if main()
    fails. However main() ends, rospy's shutdown hooks have run before the process exits.
    """
    threading.excepthook = _report_thread
    open_output()
    rospy.core.add_preshutdown_hook(lambda _reason: _exit_soon(name))
    rospy.core.add_shutdown_hook(lambda _reason: _unregistered.set())
    try:
        node_help.show_help_if_asked(documentation, parameters)
        node_help.check_command_line(parameters)
        raise_limit_on_files()
        go_without_logs_if_necessary()
        _start(name, init_node_options)
        node_help.warn_of_unknown(parameters)
        main()
    except StartError as error:
        stays = node_help.how_to_forget(error.name) if isinstance(error, ParameterError) else ''
        _failures.append((EXIT_BAD_PARAMETER, f'{error}{stays}\n'))
    except (rospy.ROSInterruptException, KeyboardInterrupt):
        pass
    except OSError as error:
        end_node(error)
    except Exception:  # noqa: BLE001
        # At shutdown rospy raises one if it closes a topic during a publish.
        if not rospy.core.is_shutdown_requested():
            _failures.append((EXIT_FAILURE, traceback.format_exc()))
    rospy.signal_shutdown('the node has ended')
    _exit(name)


def spin(check=lambda: None, period=LONGEST_WAIT):
    """Return at shutdown, at once; rospy.spin() may take half a second.

    :param check: called every `period` s of wall time
    """
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    while not (rospy.core.is_shutdown_requested() or ended.wait(period)):
        check()


def end_node(error):
    """Shut down because of an OSError; a reader that exits, as in `| head`, is no failure."""
    if not isinstance(error, BrokenPipeError) and not rospy.core.is_shutdown_requested():
        _failures.append((EXIT_FAILURE, f'{error}\n'))
    _shut_down(str(error))


def _exit_soon(name):
    """Exit even if main() does not return; rospy calls this after the node's shutdown hooks."""
    _hooks_have_run.set()
    threading.Thread(target=_exit, args=[name], daemon=True).start()


def _exit(name):
    """Exit even if other threads block, for example on a stuck master."""
    _hooks_have_run.wait()
    _unregistered.wait(UNREGISTER_TIMEOUT)
    _exit_lock.acquire()  # never released: only the first thread reports
    status, reason = _failures[0] if _failures else (0, None)
    if reason:
        sys.stderr.write(f'{name}: {reason}')
    os._exit(status)


def _report_thread(failure):
    """Report the exception that ended a thread, unless the node is shutting down.

    At shutdown rospy's threads fail on sockets that it has closed.
    """
    if not rospy.core.is_shutdown_requested():
        _pythons_excepthook(failure)


def _start(name, init_node_options):
    """Initialise rospy; a signal meanwhile raises KeyboardInterrupt.

    rospy and rosgraph swallow exceptions in places, hence the list of signals. Not an Event: this
    thread may hold its lock when the signal arrives.
    """
    interrupted = []

    def interrupt(signum, _frame):
        interrupted.append(signum)
        raise KeyboardInterrupt

    interrupt_waits_by_signals()
    on_signals(interrupt)
    _wait_for_master(interrupted)
    if not interrupted:
        fix_rospy()
        rospy.init_node(name, disable_signals=True, **init_node_options)
    on_signals(lambda signum, _frame: _shut_down(signal.Signals(signum).name))
    if interrupted:
        raise KeyboardInterrupt


def _wait_for_master(interrupted):
    """Wait for the master; rospy itself exits with a traceback if it has parameters to upload."""
    try:
        if rosgraph.is_master_online() or interrupted:
            return
    except ValueError as error:  # the URI
        raise StartError(error) from None
    print(f'Unable to register with master node [{rosgraph.get_master_uri()}]: master may '
          'not be running yet. Will keep trying.', file=sys.stderr)
    while not (interrupted or rosgraph.is_master_online()):
        time.sleep(MASTER_RETRY_PERIOD)


def _shut_down(reason):
    """Shut the node down on a new thread.

    rospy would run the shutdown hooks right here, inside a signal handler or a log call, where this
    thread may hold the lock that a hook needs to publish, or may have sent half a message.
    """
    threading.Thread(target=rospy.signal_shutdown, args=[reason]).start()
