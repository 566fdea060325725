"""Tables with named columns."""

import csv
import os
import pathlib
from typing import Dict, List, Sequence, Union

import numpy as np

from .program import InputError


def read_columns(path: Union[str, "os.PathLike[str]"]) -> Dict[str, List[str]]:
    """Columns of a table by name, as text. Lines that begin with '#' are comments."""
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if line.strip() and not line.startswith("#")))
    if not rows:
        raise InputError(f"{path}: no heading")
    for number, row in enumerate(rows):
        if len(row) != len(rows[0]):
            raise InputError(f"{path}: row {number} has {len(row)} fields, but the header names {len(rows[0])}")
    return {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])}


def numbers_or_text(fields: List[str]) -> np.ndarray:
    """Numbers, empty fields as NaN, where all fields are numbers; else text."""
    try:
        return np.array([float(field) if field else np.nan for field in fields], dtype=float)
    except ValueError:
        return np.array(fields, dtype=str)


def read_table(path: Union[str, "os.PathLike[str]"], text: Sequence[str] = ()) -> np.ndarray:
    """A table as a structured array (rows,): `table["pc_Pa"]` is a column, `table[0]` a row.

    text  columns that are text even where all their fields look like numbers or are empty
    """
    if not pathlib.Path(path).is_file():
        raise InputError(f"{path}: no such table")
    columns = {name: np.array(fields, dtype=str) if name in text else numbers_or_text(fields)
               for name, fields in read_columns(path).items()}
    rows = len(next(iter(columns.values())))
    table = np.empty(rows, dtype=[(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table
