"""Fields of a run: the .vtp files of its folder as arrays."""

import dataclasses
import os
import pathlib
import xml.etree.ElementTree as ElementTree
from typing import Dict, Union

import numpy as np

from .program import InputError

_TYPES = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "UInt8": "|u1"}
_APPENDED = b'<AppendedData encoding="raw">'


@dataclasses.dataclass
class PolyData:
    """Points, or lines between points, with their data. Arrays are read-only views of the file's bytes."""

    points: np.ndarray  #: (N, 3) [m]
    lines: np.ndarray  #: (M, 2) indices of points; M = 0: none
    point_data: Dict[str, np.ndarray]  #: (N,) or (N, 3) by name, SI
    cell_data: Dict[str, np.ndarray]  #: (M,) or (M, 3) by name, SI; without lines there is one cell a point
    field_data: Dict[str, np.ndarray]  #: of the whole, by name, SI


def read_polydata(path: Union[str, "os.PathLike[str]"]) -> PolyData:
    """Reads a .vtp file as puadem writes it. Raises InputError for any other."""
    data = pathlib.Path(path).read_bytes()
    head = data.find(_APPENDED)
    start = data.find(b"_", head + len(_APPENDED)) + 1
    if head < 0 or start == 0:
        raise InputError(f"{path}: not a .vtp file of puadem, whose data are appended raw")
    root = ElementTree.fromstring(data[:head] + b"</VTKFile>")

    def array(element: ElementTree.Element) -> np.ndarray:
        offset = start + int(element.attrib["offset"])
        kind = np.dtype(_TYPES[element.attrib["type"]])
        length = int(np.frombuffer(data, "<u8", 1, offset)[0])
        values = np.frombuffer(data, kind, length // kind.itemsize, offset + 8)
        columns = int(element.attrib.get("NumberOfComponents", "1"))
        return values if columns == 1 else values.reshape(-1, columns)

    def arrays(where: str) -> Dict[str, np.ndarray]:
        return {e.attrib["Name"]: array(e) for e in root.findall(f".//{where}/DataArray")}

    lines = arrays("Lines").get("connectivity", np.empty(0, "<i8"))
    return PolyData(arrays("Points")["Points"].reshape(-1, 3), lines.reshape(-1, 2), arrays("PointData"), arrays("CellData"),
                    arrays("FieldData"))
