"""Granular media with two fluids in their pores: cases, packings, networks and results as NumPy arrays.

The package drives the program `puadem`, so a run from Python gives the same bits as one from the shell. The program is
taken from the environment variable PUADEM, else from the build folder beside this source, else from the PATH.
All numbers are SI.
"""

from .case import Case, templates
from .network import Network
from .packing import Packing
from .polydata import PolyData, read_polydata
from .program import InputError, NumericalError, version
from .results import Frame, Run
from .sweep import product, sweep

__all__ = [
    "Case", "Frame", "InputError", "Network", "NumericalError", "Packing", "PolyData", "Run", "product", "read_polydata", "sweep",
    "templates", "version",
]
