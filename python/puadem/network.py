"""Pores and throats as arrays."""

import dataclasses
import os
from typing import Dict, Union

import numpy as np

from .tables import numbers_or_text, read_columns


@dataclasses.dataclass
class Network:
    """A pore network in the names of OpenPNM's tables, SI units.

    `pore["coords"]` (P, 3) [m], `pore["volume"]` [m3], `pore["diameter"]` inscribed [m], labels `pore["left"]` to
    `pore["top"]`; `throat["conns"]` (T, 2) indices of pores, `throat["shift"]` (T, 3) periods by which the second pore is moved,
    `throat["conductance"]` times viscosity [m3], `throat["entry_radius"]` r* [m]: entry pressure gamma / r*, and more.
    """

    pore: Dict[str, np.ndarray]
    throat: Dict[str, np.ndarray]
    box: np.ndarray  #: (3,) edge lengths [m]

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> "Network":
        """Reads a table as `puadem convert --to network` writes it."""
        parts: Dict[str, Dict[str, np.ndarray]] = {"pore": {}, "throat": {}, "param": {}}
        for name, fields in read_columns(path).items():
            part, _, rest = name.partition(".")
            filled = len(fields)
            while filled > 0 and not fields[filled - 1]:  # shorter columns end in empty fields
                filled -= 1
            values = numbers_or_text(fields[:filled])
            if values.dtype.kind == "U":
                values = values == "True"
            parts[part][rest] = values
        for columns in parts.values():
            _join_components(columns)
        throat = parts["throat"]
        for name in ("conns", "shift"):
            throat[name] = throat[name].astype(int)
        return cls(parts["pore"], throat, parts["param"]["box"][0])


def _join_components(columns: Dict[str, np.ndarray]) -> None:
    """Columns "name[0]", "name[1]", ... become one of shape (rows, components)."""
    for first in [name for name in columns if name.endswith("[0]")]:
        name = first[:-len("[0]")]
        parts = []
        while f"{name}[{len(parts)}]" in columns:
            parts.append(columns.pop(f"{name}[{len(parts)}]"))
        columns[name] = np.column_stack(parts)
