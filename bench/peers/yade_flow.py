"""One fluid through a packing in Yade's FlowEngine, for comparison: seconds of the first call (triangulation,
conductances, factor, solve) and of a further solve on the same mesh.

Usage: yade -n -x yade_flow.py PACKING.csv
Packing: x,y,z,r in metres in a box from 0. Pressure at the z faces, closed sides; CHOLMOD (useSolver 3).
"""
import sys
import time

from yade import O, Vector3, utils
from yade import FlowEngine, ForceResetter, NewtonIntegrator

box, grains = None, []
for line in open(sys.argv[1]):
    if line.startswith("# box"):
        box = [float(v) for v in line.split()[2:5]]
    elif line[0] not in "#x":
        grains.append([float(v) for v in line.split(",")[:4]])

O.materials.append(utils.FrictMat(young=1e6, poisson=0.3, frictionAngle=0, density=2650))
O.bodies.append(utils.aabbWalls([Vector3(0, 0, 0), Vector3(*box)], thickness=0))
for x, y, z, r in grains:
    O.bodies.append(utils.sphere((x, y, z), r))

flow = FlowEngine()
flow.useSolver = 3
flow.viscosity = 1e-3
flow.meshUpdateInterval = 1000000
flow.defTolerance = -1
flow.bndCondIsPressure = [0, 0, 0, 0, 1, 1]
flow.bndCondValue = [0, 0, 0, 0, 1.0, 0]
O.engines = [ForceResetter(), flow]
O.dt = 1e-9
seconds = []
for k in range(6):
    if k:
        flow.bndCondValue = [0, 0, 0, 0, 1.0 + k, 0]
        flow.updateBCs()
    start = time.process_time()
    O.step()
    seconds.append(time.process_time() - start)
print(f"first {seconds[0]:.3f} s, again {min(seconds[1:]):.4f} s")
