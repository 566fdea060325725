"""Cases: a file with units, keys in place of the file's, check and run."""

import json
import os
import pathlib
import re
import tempfile
from typing import Any, Dict, List, Mapping, Optional, Union

from .program import INTERRUPTED, NumericalError, PHYSICS_STOPPED, call
from .results import Run

PathLike = Union[str, "os.PathLike[str]"]


def toml(value: Any) -> str:
    """A value of a key as TOML. Raises TypeError for what a case file cannot hold."""
    if isinstance(value, (bool, str)):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{toml_key(key)} = {toml(v)}" for key, v in value.items()) + " }"
    if hasattr(value, "tolist"):  # NumPy
        return toml(value.tolist())
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    raise TypeError(f"a case file cannot hold {value!r}; allowed: text, number, true or false, list, dict")


def toml_key(key: str) -> str:
    return key if re.fullmatch("[A-Za-z0-9_-]+", key) else json.dumps(key)


class Case:
    """A case file, with keys that replace its own. A value: `with_keys` gives a new one."""

    def __init__(self, path: PathLike, keys: Optional[Mapping[str, Any]] = None):
        self.path = pathlib.Path(path)
        self.keys: Dict[str, Any] = dict(keys or {})
        self._folder: Optional["tempfile.TemporaryDirectory[str]"] = None  # of a case made in memory

    @classmethod
    def from_file(cls, path: PathLike) -> "Case":
        """A case.toml. It is read when the case is checked or run."""
        return cls(path)

    @classmethod
    def from_template(cls, name: str, folder: PathLike) -> "Case":
        """A shipped case (see `templates`), copied into a new folder. Raises InputError for an unknown name."""
        call(["new", name, os.fspath(folder)])
        return cls(pathlib.Path(folder) / "case.toml")

    @classmethod
    def from_dict(cls, sections: Mapping[str, Any], name: str = "case", files: Optional[Mapping[str, str]] = None) -> "Case":
        """A case made in memory.

        sections  keys as in a case file: {"grains": {...}, "stage": [{...}, ...]}; quantities are texts with a unit or SI numbers
        name      names the folder of a run
        files     texts of the files that the case names, by name
        """
        folder = tempfile.TemporaryDirectory(prefix="puadem-")
        home = pathlib.Path(folder.name) / name
        home.mkdir()
        for file, text in (files or {}).items():
            (home / file).write_text(text)
        lines = [f"{toml_key(key)} = {toml(value)}\n" for key, value in sections.items()]
        (home / "case.toml").write_text("".join(lines))
        case = cls(home / "case.toml")
        case._folder = folder
        return case

    def with_keys(self, keys: Mapping[str, Any]) -> "Case":
        """The case with other values: {"grains.count": 500, "stage.0.stress": "5 kPa"}; stages count from 0."""
        case = Case(self.path, {**self.keys, **keys})
        case._folder = self._folder
        return case

    def arguments(self) -> List[str]:
        """The case as the program's command line names it."""
        return [os.fspath(self.path)] + [a for key, value in self.keys.items() for a in ("--set", f"{key}={toml(value)}")]

    def check(self) -> str:
        """What the case will do, without running it. Raises InputError with all its errors at once."""
        done = call(["check", *self.arguments()])
        return done.stderr + done.stdout

    def run(self, output: Optional[PathLike] = None, threads: int = 0, time_limit: Optional[float] = None,
            show_progress: bool = False) -> Run:
        """Runs all stages and returns the results.

        output         new folder; None: runs/<time>_<name>_<hash> in the working folder
        threads        0: one for every 5,000 grains; results do not depend on it
        time_limit     wall time [s] after which the run writes a checkpoint and stops: `interrupted` is then set
        show_progress  a line on the terminal

        Raises InputError, and NumericalError, whose `run` holds what is on disk. Ctrl-C leaves a checkpoint.
        """
        return run_verb("run", self.arguments(), output, threads, time_limit, show_progress)


def run_verb(verb: str, arguments: List[str], output: Optional[PathLike], threads: int, time_limit: Optional[float],
             show_progress: bool) -> Run:
    """`puadem run` or `puadem resume`, and what it left."""
    arguments = [verb, *arguments, "--json", "--threads", str(threads)]
    if output is not None:
        arguments += ["--output", os.fspath(output)]
    if time_limit is not None:
        arguments += ["--time-limit", repr(float(time_limit))]
    if not show_progress:
        arguments.append("--quiet")
    done = call(arguments, show_progress)
    outcome = json.loads(done.stdout)
    run = Run(outcome["folder"]) if outcome["folder"] else None
    if done.returncode == PHYSICS_STOPPED:
        error = NumericalError(outcome["error"])
        error.run = run
        raise error
    if run is None:
        raise NumericalError("interrupted before the first result; nothing is kept")
    assert run.interrupted == (done.returncode == INTERRUPTED)
    return run


def templates() -> List[str]:
    """Names of the shipped cases."""
    return call(["new"]).stdout.split()
