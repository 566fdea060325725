"""Quasi-static drainage of a packing in Yade's TwoPhaseFlowEngine, for comparison.

Usage: yade -n -x yade_drainage.py PACKING.csv OUT.csv PC_MAX STEP SIDES(open|closed)
Packing: x,y,z,r in metres in a box from 0. Air enters from the upper z face, water leaves below; the
engine knows reservoirs along its y axis only, so y and z are exchanged on the way in.
Writes pc_Pa,saturation and, on stderr, the time of initialization and of all invasions.
"""
import sys
import time

from yade import O, Vector3, utils
from yade import TwoPhaseFlowEngine, ForceResetter, NewtonIntegrator

packing, out, pc_max, step, sides = sys.argv[1], sys.argv[2], float(sys.argv[3]), float(sys.argv[4]), sys.argv[5]

box, grains = None, []
for line in open(packing):
    if line.startswith("# box"):
        box = [float(v) for v in line.split()[2:5]]
    elif line[0] not in "#x":
        grains.append([float(v) for v in line.split(",")[:4]])

O.materials.append(utils.FrictMat(young=1e6, poisson=0.3, frictionAngle=0, density=2650))
walls = utils.aabbWalls([Vector3(0, 0, 0), Vector3(box[0], box[2], box[1])], thickness=0)
O.bodies.append(walls)
for x, y, z, r in grains:
    O.bodies.append(utils.sphere((x, z, y), r))

flow = TwoPhaseFlowEngine()
O.engines = [ForceResetter(), flow, NewtonIntegrator()]
flow.isPhaseTrapped = True
flow.isInvadeBoundary = sides == "open"
flow.surfaceTension = 0.0728
flow.isDrainageActivated = True
flow.isImbibitionActivated = False
flow.bndCondIsPressure = [0, 0, 1, 1, 0, 0]
flow.bndCondValue = [0, 0, -1e-12, 0, 0, 0]
start = time.time()
flow.initialization()
initialized = time.time()
with open(out, "w") as f:
    f.write("pc_Pa,saturation\n")
    pc = 0.0
    while pc < pc_max - 1e-9:
        pc += step
        flow.bndCondValue = [0, 0, -pc, 0, 0, 0]
        flow.invasion()
        f.write(f"{pc:g},{flow.getSaturation(False):.6f}\n")
print(f"initialization {initialized - start:.3f} s, invasion {time.time() - initialized:.3f} s", file=sys.stderr)
