# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program in a folder with limits of time and memory, and keeps the command beside what it wrote."""
import functools
import os
import pathlib
import resource
import shlex
import signal
import subprocess
import time

MEMORY = 6 << 30  # bytes of addresses; more than any small run takes, less than what brings a machine down
SANITIZED = {"ASAN_OPTIONS": "exitcode=86:allocator_may_return_null=1:detect_stack_use_after_return=1",
             "UBSAN_OPTIONS": "print_stacktrace=1", "TSAN_OPTIONS": "exitcode=86:ignore_noninstrumented_modules=1"}


class Outcome:
    """How a run ended: its code (negative: the signal it died of), what it printed, and whether it had to be stopped."""

    def __init__(self, code, text, seconds, is_late, is_stuck):
        self.code, self.text, self.seconds = code, text, seconds
        self.is_late, self.is_stuck = is_late, is_stuck


@functools.cache
def is_sanitized(program):
    """AddressSanitizer and ThreadSanitizer take terabytes of addresses: their programs get no limit."""
    listed = subprocess.run(["nm", "-D", str(program)], capture_output=True, text=True).stdout
    return "__asan_init" in listed or "__tsan_init" in listed


def asan_library(program):
    """The library of AddressSanitizer that a program is linked with, which wants to be loaded first; in a list."""
    listed = subprocess.run(["ldd", str(program)], capture_output=True, text=True).stdout
    return [line.split()[2] for line in listed.splitlines() if line.split()[:1] and "libasan" in line.split()[0]]


def environment(**more):
    return {**os.environ, **SANITIZED, "OMP_WAIT_POLICY": "passive", **more}


def build_shim(folder, compiler):
    """The library that has calls of a run fail, made by a C compiler."""
    shim = folder / "fault_shim.so"
    source = pathlib.Path(__file__).with_name("fault_shim.c")
    subprocess.run([compiler, "-x", "c", "-shared", "-fPIC", "-O1", "-o", str(shim), str(source), "-ldl"], check=True)
    return shim


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def note_command(folder, command, **more):
    words = [f"{name}={shlex.quote(value)}" for name, value in more.items()]
    with open(folder / "command.txt", "a") as file:
        file.write(" ".join([*words, shlex.join(map(str, command))]) + "\n")


def start(command, folder, **more):
    """A process whose output goes to printed.txt; `more` is added to its environment."""
    note_command(folder, command, **more)
    with open(folder / "printed.txt", "ab") as printed:
        return subprocess.Popen(list(map(str, command)), cwd=folder, stdin=subprocess.DEVNULL, stdout=printed,
                                stderr=printed, env=environment(**more),
                                preexec_fn=None if is_sanitized(command[0]) else limit_memory)


def processor_seconds(process):
    """What the process has had of processors so far; machines may be busy with other work."""
    try:
        with open(f"/proc/{process.pid}/stat") as file:
            fields = file.read().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def ends_within(process, limit):
    """Whether it ends before it has had `limit` seconds of a processor more, or has been there for 20 times as long."""
    begun, had = time.monotonic(), processor_seconds(process)
    while processor_seconds(process) - had < limit and time.monotonic() - begun < 20 * limit:
        try:
            process.wait(0.2 * limit)
            return True
        except subprocess.TimeoutExpired:
            pass
    return process.poll() is not None


def time_limit(program):
    """Seconds of a processor that a run of few steps never takes."""
    return 60.0 if is_sanitized(program) else 10.0


def run(command, folder, limit=10.0, stop_within=None, **more):
    """Runs to the end. After `limit` seconds the run is asked to stop, as a scheduler would; what then goes on for
    `stop_within` seconds, by default twice the limit, is stuck."""
    begun = time.monotonic()
    path = folder / "printed.txt"
    at = path.stat().st_size if path.exists() else 0
    process = start(command, folder, **more)
    is_late = is_stuck = False
    if not ends_within(process, limit):
        is_late = True
        process.send_signal(signal.SIGTERM)
        is_stuck = not ends_within(process, stop_within or 2 * limit)
        if is_stuck:
            process.kill()
        process.wait()
    text = path.read_bytes()[at:].decode(errors="replace")
    return Outcome(process.returncode, text, time.monotonic() - begun, is_late, is_stuck)
