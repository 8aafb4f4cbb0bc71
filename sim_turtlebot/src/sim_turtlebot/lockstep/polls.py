"""Find threads of idle processes that may still have work, since they poll for it by wall time."""


def classify(processes, idle_usage, check_begin, receivers, lateness):
    """Tell working threads from those that only poll.

    :param processes: Processes, all idle
    :param idle_usage: what this returned as usage when all were last idle
    :param check_begin: when the check began that found them so (monotonic, s)
    :param receivers: how many threads of a process may have run without work for those that poll
    :param lateness: how long a poll may last (s), even if the Process's `longest_poll` is shorter
    :returns: the usage of the working threads, by Process; and, by thread that polls, how often
        it has slept once it has polled again
    """
    usage, polling = {}, {}
    for process in processes:
        limit, threads = process.longest_poll, process.threads.values()
        for thread in threads if process.is_cpp else ():
            thread.sample_polling()
        usage[process], earlier = process.usage(), idle_usage.get(process, {})
        # Most often it is the same dictionary; comparing its items takes ten times as long.
        have_run = () if usage[process] is earlier else usage[process].items() - earlier.items()
        # ros::Rate and ros::Timer poll for the clock.
        if limit and (process.is_cpp or len(have_run) > receivers):
            for thread in threads:
                if thread in usage[process] or thread.ignored:
                    continue
                if thread.is_asleep and thread.sleeps_longer_than(max(limit, lateness),
                                                                  check_begin):
                    continue
                polling[thread] = thread.sleep_count + (1 if thread.is_asleep else 2)
    return usage, polling


def has_news(thread, usage, before):
    """Return whether another node ran, and may have sent something, between two usages.

    The usages are those that classify() returned.
    """
    return before is None or any(
        process.longest_poll and process.pid != thread.pid and usages != before.get(process)
        for process, usages in usage.items())
