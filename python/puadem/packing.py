"""Packings: spheres in a box, and what follows from them."""

import dataclasses
import os
import pathlib
import tempfile
from typing import Any, List, Mapping, Optional, Sequence, Union

import numpy as np

from .case import Case
from .network import Network
from .program import InputError, call
from .results import Run


@dataclasses.dataclass
class Packing:
    """Spheres in a box whose lower corner is the origin."""

    position: np.ndarray  #: (N, 3) centres [m]
    radius: np.ndarray  #: (N,) [m]
    box: np.ndarray  #: (3,) edge lengths [m]

    def __post_init__(self) -> None:
        self.position = np.asarray(self.position, dtype=float)
        self.radius = np.asarray(self.radius, dtype=float)
        self.box = np.asarray(self.box, dtype=float)
        if self.position.shape != (len(self.radius), 3) or self.radius.ndim != 1 or self.box.shape != (3,):
            raise InputError(f"shapes {self.position.shape}, {self.radius.shape} and {self.box.shape} of position, radius and box "
                             "must be (N, 3), (N,) and (3,)")

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> "Packing":
        """Reads a packing file: a line `# box lx ly lz`, then x,y,z,r [m] a line."""
        lines = pathlib.Path(path).read_text().splitlines()
        box: Optional[List[float]] = None
        rows: List[List[float]] = []
        for number, line in enumerate(lines, 1):
            try:
                if line.startswith("# box"):
                    box = [float(word) for word in line.split()[2:]]
                elif line.strip() and not line.startswith("#") and not (not rows and line.strip() == "x,y,z,r"):
                    x, y, z, r = map(float, line.split(","))
                    rows.append([x, y, z, r])
            except ValueError:
                raise InputError(f"{path}:{number}: not a sphere x,y,z,r: {line!r}") from None
        if box is None:
            raise InputError(f"{path}: no line `# box lx ly lz`")
        table = np.array(rows).reshape(-1, 4)
        return cls(table[:, :3], table[:, 3], np.array(box))

    def text(self) -> str:
        """The packing as a file; numbers read back to the same bits."""
        lines = ["# box " + " ".join(repr(float(length)) for length in self.box), "x,y,z,r"]
        lines += [",".join(repr(float(v)) for v in (*centre, r)) for centre, r in zip(self.position, self.radius)]
        return "\n".join(lines) + "\n"

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        pathlib.Path(path).write_text(self.text())

    def network(self, merge_ratio: Optional[float] = 0.9, periodic: Sequence[str] = ()) -> Network:
        """Pores and throats of the packing.

        merge_ratio  neighbours merge where their throat is wider than this share of the smaller pore; None: no merging
        periodic     axes without walls, such as ("x", "y")
        """
        with tempfile.TemporaryDirectory(prefix="puadem-") as folder:
            packing, table = os.path.join(folder, "packing.csv"), os.path.join(folder, "network.csv")
            self.write(packing)
            arguments = ["convert", packing, table, "--to", "network", "--merge-ratio",
                         "none" if merge_ratio is None else repr(float(merge_ratio))]
            call(arguments + (["--periodic", ",".join(periodic)] if periodic else []))
            return Network.read(table)

    def case(self, *stages: Mapping[str, Any], name: str = "packing", **sections: Any) -> Case:
        """A case of these grains: stages and sections as in a case file."""
        grains = {"file": "packing.csv", **sections.pop("grains", {})}
        return Case.from_dict({**sections, "grains": grains, "stage": list(stages)}, name, {"packing.csv": self.text()})

    def retention(self, path: Sequence[Union[str, float]], step: Union[str, float], surface_tension: Union[str, float] = 0.0728,
                  contact_angle: Union[str, float] = 0.0, output: Optional[Union[str, "os.PathLike[str]"]] = None) -> Run:
        """Retention curve from saturation 1 through the capillary pressures of `path`, in steps.

        Numbers are Pa, N/m and rad; texts carry their unit. The curve is `.series("retention")` of the run.
        """
        case = self.case({"kind": "retention", "path": list(path), "step": step}, name="retention",
                         fluids={"surface_tension": surface_tension, "contact_angle": contact_angle})
        return case.run(output)
