"""A packing at rest in Yade with its Hertz-Mindlin law, for comparison of speed.

Usage: yade -n -x yade_grains.py PACKING.csv STEPS
"""
import math
import sys
import time

from yade import O, utils
from yade import Bo1_Sphere_Aabb, Bo1_Wall_Aabb, ForceResetter, Ig2_Sphere_Sphere_ScGeom, Ig2_Wall_Sphere_ScGeom
from yade import InsertionSortCollider, InteractionLoop, Ip2_FrictMat_FrictMat_MindlinPhys, Law2_ScGeom_MindlinPhys_Mindlin
from yade import FrictMat, NewtonIntegrator

packing, steps = sys.argv[1], int(sys.argv[2])
grain = O.materials.append(FrictMat(young=1e8, poisson=0.3, frictionAngle=math.radians(30), density=2650))
smooth = O.materials.append(FrictMat(young=1e8, poisson=0.3, frictionAngle=0, density=2650))
for line in open(packing):
    if line.startswith("# box"):
        for axis, length in enumerate(float(v) for v in line.split()[2:5]):
            O.bodies.append(utils.wall(0, axis, sense=1, material=smooth))
            O.bodies.append(utils.wall(length, axis, sense=-1, material=smooth))
    elif line[0] not in "#x":
        x, y, z, r = (float(v) for v in line.split(",")[:4])
        O.bodies.append(utils.sphere((x, y, z), r, material=grain))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=5e-5),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys()],
                    [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-6
O.run(max(steps // 10, 1), True)
start = time.time()
O.run(steps, True)
print(f"{time.time() - start:.3f} s for {steps} steps")
