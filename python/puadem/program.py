"""The program behind the package: where it is, how it is called, what its exit codes mean."""

import os
import pathlib
import shutil
import signal
import subprocess
from typing import Any, Optional, Sequence


class InputError(ValueError):
    """The user can mend it: what is wrong, where, what is allowed and the nearest right name."""


class NumericalError(ArithmeticError):
    """The run could not go on, or ended outside the bounds of [expected].

    `run` holds what is on disk (a `puadem.Run`), or None where nothing was kept.
    """

    run: Any = None


WRONG_INPUT, PHYSICS_STOPPED, INTERRUPTED = 1, 2, 3  # exit codes


def program() -> str:
    """Path of the program. Raises FileNotFoundError where there is none."""
    if "PUADEM" in os.environ:
        return os.environ["PUADEM"]
    built = pathlib.Path(__file__).resolve().parents[2] / "build" / "release" / "puadem"
    if built.is_file():
        return str(built)
    found = shutil.which("puadem")
    if found is None:
        raise FileNotFoundError("no program puadem: build it with `make build`, or name it in the environment variable PUADEM")
    return found


def start(arguments: Sequence[str], show_progress: bool = False) -> "subprocess.Popen[str]":
    """Starts the program. `interrupt` stops it so that a run writes its checkpoint."""
    # A session of its own: the terminal would send Ctrl-C as well, and a second one ends the program at once.
    return subprocess.Popen([program(), *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=None if show_progress else subprocess.PIPE, text=True, start_new_session=True)


def interrupt(process: "subprocess.Popen[str]") -> None:
    """Asks a run to stop and waits until it has."""
    process.send_signal(signal.SIGINT)
    process.communicate()


def call(arguments: Sequence[str], show_progress: bool = False) -> "subprocess.CompletedProcess[str]":
    """Runs the program to its end and raises what its exit code says; codes 2 and 3 of a run are left to the caller.

    Ctrl-C is passed on once, so that a run writes its checkpoint before KeyboardInterrupt is raised.
    """
    process = start(arguments, show_progress)
    try:
        out, err = process.communicate()
    except BaseException:
        interrupt(process)
        raise
    if process.returncode == WRONG_INPUT:
        raise InputError(message_of(err))
    if process.returncode not in (0, PHYSICS_STOPPED, INTERRUPTED):
        raise RuntimeError(message_of(err) or f"puadem ended with code {process.returncode}")
    return subprocess.CompletedProcess(process.args, process.returncode, out, err)


def message_of(err: Optional[str]) -> str:
    """The error in what the program wrote to its second stream, which is empty where that went to the screen."""
    text = (err or "see the message above").strip()
    start = text.find("error: ")
    return text[start + len("error: "):] if start >= 0 else text


def version() -> str:
    """Version of the program, such as "0.1.0 (commit ...)"."""
    return call(["version"]).stdout.strip()
