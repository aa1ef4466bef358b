"""Programs that a Python script starts, and that end with it, however it ends.

A shell of its own, the keeper, waits until the script is gone and then kills the process groups that it was told of: a parent's
death ends no child. The same as common/program/keeper.cpp.
"""
import os
import signal
import socket
import subprocess
import threading

KEEPER = """
live=" "
while read -r sign group; do
    case "$sign$live" in
        +*) live="$live$group " ;;
        -*" $group "*) live="${live%% "$group" *} ${live#* "$group" }" ;;
    esac
done
for group in $live; do kill -KILL "-$group"; done
"""


class Children:
    """Runs programs, from any thread. They are in process groups of their own: Ctrl-C reaches the script, which ends them."""

    def __init__(self):
        self.running, self.stopped, self.lock = set(), False, threading.RLock()
        self.keeper, theirs = socket.socketpair()
        with theirs:
            subprocess.Popen(["/bin/sh", "-c", KEEPER], stdin=theirs, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             cwd="/", start_new_session=True)

    def tell(self, sign, group):
        try:
            self.keeper.send(f"{sign} {group}\n".encode(), socket.MSG_NOSIGNAL | socket.MSG_DONTWAIT)
        except OSError:
            pass  # somebody has killed it

    def start(self, command, **options):
        """As subprocess.Popen. Raises KeyboardInterrupt once stop() has been called."""
        with self.lock:
            if self.stopped:
                raise KeyboardInterrupt
            # The child tells the keeper itself: were it we, somebody could kill us right before.
            process = subprocess.Popen(command, start_new_session=True, preexec_fn=lambda: self.tell("+", os.getpid()), **options)
            self.running.add(process)
        return process

    def run(self, command, *, input=None, timeout=None, **options):
        """As subprocess.run(capture_output=True); a program that takes too long is killed with all that it started."""
        stdin = subprocess.DEVNULL if input is None else subprocess.PIPE
        process = self.start(command, stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        try:
            out, err = process.communicate(input, timeout)
        finally:
            self.end(process)
        return subprocess.CompletedProcess(command, process.returncode, out, err)

    def kill(self, process):
        if process.returncode is None:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def end(self, process):
        """Kills what is left of it, and waits."""
        self.kill(process)
        self.tell("-", process.pid)
        process.wait()
        with self.lock:
            self.running.discard(process)

    def stop(self):
        """Kills all that runs; nothing is started any more."""
        with self.lock:
            self.stopped = True
            for process in list(self.running):
                self.kill(process)


def signals():
    """Those that end a script; SIGHUP not if it is ignored, as under nohup."""
    hangup = [signal.SIGHUP] if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN else []
    return [signal.SIGINT, signal.SIGTERM, *hangup]


def raise_at_signals(children):
    """The first of them ends the children and raises KeyboardInterrupt, a second one ends the script at once."""
    def interrupt(*_):
        for number in signals():
            signal.signal(number, lambda *_: os._exit(130))
        children.stop()  # first: communicate() would give them time to end by themselves
        raise KeyboardInterrupt

    for number in signals():
        signal.signal(number, interrupt)


def ignore_signals():
    """For files that are about to be put into their places, which takes no time worth an interruption."""
    for number in signals():
        signal.signal(number, signal.SIG_IGN)
