"""A case at many values of its keys: one folder a point, one table of results."""

import csv
import hashlib
import itertools
import os
import pathlib
import shutil
import time
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from .case import Case, toml
from .program import INTERRUPTED, InputError, PHYSICS_STOPPED, interrupt, message_of, start
from .results import Run
from .tables import read_table

OUTCOMES = {0: "ok", 1: "wrong input", PHYSICS_STOPPED: "failed", INTERRUPTED: "interrupted"}
LOOK_EVERY = 0.02  # at the running points [s]


def product(values: Mapping[str, Sequence[Any]]) -> List[Dict[str, Any]]:
    """All combinations of the values of some keys, the last key fastest."""
    return [dict(zip(values, combination)) for combination in itertools.product(*values.values())]


def sweep(case: Case, points: Sequence[Mapping[str, Any]], folder: Union[str, "os.PathLike[str]"], jobs: int = 1) -> np.ndarray:
    """Runs the case at each point and returns the table of results, which is `sweep.csv` in the folder as well.

    points  keys and their values, as for `Case.with_keys`; all points have the same keys
    folder  one results folder a point is made in it; what is done already, by an earlier call, is not done again
    jobs    points that run at once, each on one thread

    The table is a structured array with a row for each point: the keys, `outcome` ("ok", "failed", "wrong input"), `error`,
    `folder`, and every number of `Run.results`, NaN where a point has none. A point that fails does not end the sweep. Ctrl-C
    stops the running points at a checkpoint; the next call goes on from there. A point is known by the text of the case and its
    keys: when another file that the case names has changed, take a new folder.
    """
    if not points or any(list(point) != list(points[0]) for point in points) or jobs < 1:
        raise InputError("a sweep needs points with the same keys in the same order, and at least one job")
    home = pathlib.Path(folder)
    home.mkdir(parents=True, exist_ok=True)
    places = [home / _name(case, point) for point in points]
    errors = _run_points([case.with_keys(point) for point in points], places, jobs)
    rows = [_row(point, place, errors.get(place)) for point, place in zip(points, places)]
    _write_table(home / "sweep.csv", rows)
    return read_table(home / "sweep.csv", text=("outcome", "error", "folder"))


def _name(case: Case, point: Mapping[str, Any]) -> str:
    """Folder of a point, which depends on all that the case is made of."""
    identity = "\n".join([case.path.read_text(), toml({**case.keys, **point})])
    return "point_" + hashlib.sha256(identity.encode()).hexdigest()[:12]


def _command(case: Case, place: pathlib.Path) -> Optional[List[str]]:
    """What is left to do for a point; None: nothing."""
    if place.exists():
        if (place / "manifest.json").exists() and not Run(place).interrupted:
            return None
        if (place / "checkpoints").exists():
            return ["resume", str(place), "--quiet", "--threads", "1"]
        shutil.rmtree(place)  # killed before its first checkpoint
    return ["run", *case.arguments(), "--output", str(place), "--quiet", "--threads", "1"]


def _run_points(cases: Sequence[Case], places: Sequence[pathlib.Path], jobs: int) -> Dict[pathlib.Path, str]:
    """Runs what is left to do; the messages of points that left no folder."""
    commands = {place: _command(case, place) for case, place in zip(cases, places)}
    waiting = [(place, command) for place, command in commands.items() if command is not None]
    running: Dict[pathlib.Path, Any] = {}
    errors: Dict[pathlib.Path, str] = {}
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                place, command = waiting.pop(0)
                running[place] = start(command)
            for place in [place for place, process in running.items() if process.poll() is not None]:
                process = running.pop(place)
                _, err = process.communicate()
                if process.returncode not in OUTCOMES:
                    raise RuntimeError(message_of(err))
                if process.returncode != 0:
                    errors[place] = message_of(err)
            time.sleep(LOOK_EVERY)
    finally:
        for process in running.values():
            interrupt(process)
    return errors


def _row(point: Mapping[str, Any], place: pathlib.Path, error: Optional[str]) -> Dict[str, Any]:
    row: Dict[str, Any] = {key: value if isinstance(value, str) else toml(value) for key, value in point.items()}
    if not (place / "manifest.json").exists():
        return {**row, "outcome": "wrong input", "error": error, "folder": ""}
    run = Run(place)
    outcome = OUTCOMES[run.manifest["exit_code"]]
    return {**row, "outcome": outcome, "error": run.manifest["error"], "folder": place.name, **run.results}


def _write_table(path: pathlib.Path, rows: Sequence[Mapping[str, Any]]) -> None:
    columns = list(dict.fromkeys(name for row in rows for name in row))  # in the order in which they come up
    beside = path.with_suffix(".new")
    with open(beside, "w", newline="") as file:
        table = csv.DictWriter(file, columns, restval="")
        table.writeheader()
        table.writerows({name: " ".join(v.split()) if isinstance(v, str) else v for name, v in row.items()} for row in rows)
    beside.replace(path)
