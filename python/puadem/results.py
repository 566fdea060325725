"""Results of a run: its folder as arrays."""

import dataclasses
import json
import os
import pathlib
import tempfile
import xml.etree.ElementTree as ElementTree
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Union

import numpy as np

from .network import Network
from .polydata import PolyData, read_polydata
from .program import InputError, call
from .tables import read_table

if TYPE_CHECKING:
    from .packing import Packing


@dataclasses.dataclass(frozen=True)
class Frame:
    """One file of a series of fields."""

    time: float  #: [s], or the number of the equilibrium
    path: pathlib.Path

    def read(self) -> PolyData:
        return read_polydata(self.path)


class Run:
    """The results folder of a run. Files are read when they are asked for."""

    def __init__(self, path: Union[str, "os.PathLike[str]"]):
        self.path = pathlib.Path(path).resolve()
        file = self.path / "manifest.json"
        if not file.is_file():
            raise InputError(f"{self.path}: a folder without manifest.json is no finished run of puadem")
        self.manifest: Dict[str, Any] = json.loads(file.read_text())  #: program, machine, seed, ledger, checks, ...

    def __repr__(self) -> str:
        return f"Run({str(self.path)!r})"

    @property
    def results(self) -> Dict[str, float]:
        """Main numbers by name; the unit is the end of the name: "pc_half_drainage-1_Pa"."""
        return dict(self.manifest["results"])

    @property
    def warnings(self) -> List[str]:
        return list(self.manifest["warnings"])

    @property
    def interrupted(self) -> bool:
        """Stopped before its end, by a time limit or a signal: `resume` goes on."""
        return self.manifest["exit_code"] == 3

    @property
    def report(self) -> pathlib.Path:
        """The report, one HTML file."""
        return self.path / "report.html"

    @property
    def series_names(self) -> List[str]:
        return sorted(file.stem for file in (self.path / "series").glob("*.csv"))

    def series(self, name: str) -> np.ndarray:
        """A table of series/ as a structured array (rows,); units are the ends of the columns' names."""
        if name not in self.series_names:
            raise InputError(f"{self.path}: no series {name!r}; there are: {', '.join(self.series_names)}")
        return read_table(self.path / "series" / f"{name}.csv")

    @property
    def fields_names(self) -> List[str]:
        return sorted(file.stem for file in (self.path / "fields").glob("*.pvd"))

    def fields(self, name: str) -> List[Frame]:
        """The frames of a series of fields, such as "grains", "pores" or "throats"."""
        if name not in self.fields_names:
            raise InputError(f"{self.path}: no fields {name!r}; there are: {', '.join(self.fields_names)}")
        folder = self.path / "fields"
        sets = ElementTree.parse(folder / f"{name}.pvd").getroot().iter("DataSet")
        return [Frame(float(s.attrib["timestep"]), folder / s.attrib["file"]) for s in sets]

    def packing(self) -> "Packing":
        """The grains as they lay when their network was last written."""
        from .packing import Packing  # it runs cases, whose results are of this class

        return Packing.read(self.path / "packing.csv")

    def network(self) -> Network:
        """Pores and throats of that packing, with the options of the case."""
        with tempfile.TemporaryDirectory(prefix="puadem-") as folder:
            table = os.path.join(folder, "network.csv")
            call(["convert", str(self.path), table, "--to", "network"])
            return Network.read(table)

    def resume(self, output: Optional[Union[str, "os.PathLike[str]"]] = None, threads: int = 0,
               time_limit: Optional[float] = None, show_progress: bool = False) -> "Run":
        """Goes on from the last checkpoint, as `Case.run`; output: a new folder, None: in the folder itself."""
        from .case import run_verb  # whose runs are of this class

        return run_verb("resume", [str(self.path)], output, threads, time_limit, show_progress)
