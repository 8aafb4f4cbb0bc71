"""Podman, with all that it makes in a folder, and a network and mounts of its own.

What it publishes on the host's loopback is on that network's, where no port is taken, and where
nothing leads out.
"""

import contextlib
import os
import shutil
import subprocess
import sys

from odometry_tests.processes import Process
from odometry_tests.waiting import wait_until

BASE = 'docker.io/library/debian:12'
SUITE = 'bookworm'
# How the machine's packages and Python's are reached: a user behind a proxy has it in his base, too.
OF_THE_MACHINE = ['/etc/pip.conf', '/etc/ssl/certs/ca-certificates.crt', '/usr/local/share/ca-certificates']
MAKE_TIMEOUT = 300.0  # s

# Folders of this machine to which podman would write, and mixed control groups, which crun refuses.
PRIVATE = """
umount /sys/fs/cgroup/unified 2>/dev/null || true
mount -t tmpfs none /dev/shm
for folder in /run/netns /var/lib/containers; do
    mkdir -p $folder
    mount -t tmpfs none $folder
done
ip link set lo up
echo ready
exec sleep infinity
"""
# docker's name stands for podman, so that what the documents say can be typed.
COMMAND = """#!/bin/sh
if [ "$1" = build ]; then
    shift
    set -- build --network host --isolation chroot "$@"
else
    network=--net
fi
exec nsenter --target {pid} --mount $network sh -c 'cd "$0" && exec "$@"' "$PWD" {podman} "$@"
"""
SETTINGS = {
    # Who may not raise limits can keep to lower ones.
    'CONTAINERS_CONF': """
[containers]
default_ulimits = ["nofile=1024:4096", "nproc=4096:4096"]
[network]
network_config_dir = "{folder}/networks"
[engine]
cgroup_manager = "cgroupfs"
events_logger = "none"
tmp_dir = "{folder}/tmp"
""",
    'CONTAINERS_STORAGE_CONF': """
[storage]
driver = "overlay"
graphroot = "{folder}/storage"
runroot = "{folder}/run"
""",
}
FETCH = """
import http.client, sys
host, port, *headers = sys.argv[1:]
connection = http.client.HTTPConnection(host, int(port), timeout=60)
connection.request('GET', '/', headers=dict(zip(headers[::2], headers[1::2])))
print(connection.getresponse().status)
"""
LISTENING = """
import psutil
for socket in psutil.net_connections('tcp'):
    if socket.status == psutil.CONN_LISTEN:
        print(*socket.laddr)
"""


class NotHere(Exception):
    """Containers cannot be run on this machine; the message says why."""


class Podman:
    """A context in which `docker` and `podman` are commands, with an image to start from."""

    def __init__(self, folder):
        """Take a folder for everything, which is removed at the end."""
        self._folder = folder
        self._stack = contextlib.ExitStack()
        self.environment = {**os.environ, 'PATH': f'{folder}/bin:{os.environ["PATH"]}'}

    def __enter__(self):
        """Raise NotHere unless a container can be run."""
        if missing := [name for name in ('podman', 'debootstrap', 'ip') if not shutil.which(name)]:
            raise NotHere(f'{", ".join(missing)} is not installed')
        if os.geteuid():
            raise NotHere('debootstrap needs root')
        with contextlib.ExitStack() as stack:
            self._set_up(stack)
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *_):
        """End and forget all containers."""
        self._stack.close()

    def _set_up(self, stack):
        # Two gigabytes; it is the last thing to go, after the mounts.
        stack.callback(shutil.rmtree, self._folder)
        self._holder = stack.enter_context(
            Process('unshare', '--mount', '--net', 'sh', '-ec', PRIVATE))
        wait_until(lambda: self._holder.stdout or not self._holder.running, 20.0, 'a network')
        if not self._holder.running:
            raise NotHere(f'no network can be made here: {self._holder.stderr}')
        (self._folder / 'bin').mkdir()
        for name in ('docker', 'podman'):
            command = self._folder / 'bin' / name
            command.write_text(COMMAND.format(pid=self._holder.pid, podman=shutil.which('podman')))
            command.chmod(0o755)
        for name, text in SETTINGS.items():
            file = self._folder / name.lower()
            file.write_text(text.format(folder=self._folder))
            self.environment[name] = str(file)
        self._make_base()
        stack.callback(self.forget_containers)
        try:
            self.run('run', '--rm', BASE, 'true')
        except AssertionError as error:
            raise NotHere(f'no container can be run here: {error}') from None

    def run(self, *arguments, timeout=MAKE_TIMEOUT):
        """Run podman to its end and return what it has printed."""
        with Process(self._folder / 'bin' / 'podman', *arguments, env=self.environment) as process:
            assert process.wait(timeout) == 0, process.output
        return process.stdout

    def forget_containers(self):
        """End and remove whatever there is."""
        self.run('rm', '--all', '--force', '--time', '0')

    def fetch(self, port, host='127.0.0.1', **headers):
        """Return the status of an answer at a port of the host's loopback."""
        words = [word for pair in headers.items() for word in pair]
        return int(self._beside('-c', FETCH, host, port, *words))

    def listening(self):
        """Return the addresses and ports on which the host listens, as a set of lines."""
        return set(self._beside('-c', LISTENING).splitlines())

    def _beside(self, *arguments):
        """Run Python on podman's network and return what it has printed."""
        with Process('nsenter', '--target', self._holder.pid, '--net', sys.executable,
                     *arguments) as process:
            assert process.wait() == 0, process.output
        return process.stdout

    def _make_base(self):
        """Make the image from which the Dockerfile starts, as its registry has it."""
        base = self._folder / 'base'
        with Process('debootstrap', '--variant=minbase', SUITE, base, *mirror()) as process:
            if process.wait(MAKE_TIMEOUT):
                raise NotHere(f'debootstrap: {process.output[-500:]}')
        # As in the registry's, where nobody waits for the disk.
        (base / 'etc' / 'dpkg' / 'dpkg.cfg.d' / 'docker-apt-speedup').write_text('force-unsafe-io\n')
        for path in filter(os.path.exists, OF_THE_MACHINE):
            subprocess.run(['cp', '-rL', '--parents', path, base], check=True)
        archive = self._folder / 'base.tar'
        subprocess.run(['tar', '-C', base, '-cf', archive, '.'], check=True)
        shutil.rmtree(base)
        self.run('import', archive, BASE)
        archive.unlink()


def mirror():
    """Return where this machine has Debian's packages from, as debootstrap's argument, or nothing."""
    with Process('apt-get', 'indextargets', '--format', '$(REPO_URI) $(RELEASE)',
                 'Created-By: Packages') as process:
        process.wait()
    return [line.split()[0] for line in process.stdout.splitlines()
            if line.split()[1:] == [SUITE] and line.split()[0].rstrip('/').endswith('/debian')][:1]
