#!/usr/bin/env python3
"""Dry grains at rest in puadem and in LAMMPS: the same packing, law, friction and time step, one table.

Usage: lammps_dem.py PACKING.csv BENCH_DEM_THROUGHPUT [steps=2000] [repeats=3]

LAMMPS is Debian's package `lammps` (binary `lmp`); the two programs run in turn on core 0, so that what else
the machine does meets both, and the best of the repeats counts. gran/hertz/history is the law of our
Hertz-Mindlin: K_n = 4/3 E*, K_t = 8 G*.
"""
import math
import os
import re
import subprocess
import sys
import tempfile

packing, program = sys.argv[1], sys.argv[2]
steps = int(sys.argv[3]) if len(sys.argv) > 3 else 2000
repeats = int(sys.argv[4]) if len(sys.argv) > 4 else 3

youngs, poisson, density, friction = 100e6, 0.3, 2650.0, math.tan(math.radians(30))
k_n = 4 / 3 * youngs / (2 * (1 - poisson**2))
k_t = 8 * youngs / (2 * (1 + poisson)) / (2 * (2 - poisson))

box, grains = None, []
for line in open(packing):
    if line.startswith("# box"):
        box = [float(v) for v in line.split()[2:5]]
    elif line[0] not in "#x":
        grains.append([float(v) for v in line.split(",")[:4]])

law = f"hertz/history {k_n} {k_t} 0 0 {{mu}} 0"
walls = "\n".join(
    f"fix w{axis} all wall/gran {law.format(mu=0)} {axis}plane 0 {length}" for axis, length in zip("xyz", box)
)
script = f"""
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data data.txt
neighbor 1e-4 bin
neigh_modify delay 0 every 1 check yes
pair_style gran/{law.format(mu=friction)}
pair_coeff * *
{walls}
fix move all nve/sphere
timestep 1e-6
compute virial all pressure NULL pair
thermo_style custom step c_virial
thermo {steps}
run {steps // 10}
run {steps}
"""


def lammps(folder):
    out = subprocess.run(["taskset", "-c", "0", "lmp", "-in", "in.txt", "-log", "none"], cwd=folder, text=True,
                         capture_output=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    loops = re.findall(r"Loop time of ([\d.e+-]+)", out.stdout)
    if len(loops) < 2:
        sys.exit("LAMMPS failed:\n" + out.stdout[-2000:] + out.stderr[-2000:])
    virial = re.findall(r"^\s+\d+\s+([-\d.e+]+)\s*$", out.stdout, re.M)
    return float(loops[1]), float(virial[-1])


def puadem(threads):
    cores = "0" if threads == 1 else f"0-{threads - 1}"
    out = subprocess.run(["taskset", "-c", cores, program, packing, str(steps), str(threads)], text=True,
                         capture_output=True, check=True, env={**os.environ, "OMP_WAIT_POLICY": "passive"}).stdout
    stress = float(re.findall(r"end: pair stress ([\d.]+)", out)[0])
    return float(re.search(r"threads: ([\d.]+) s", out).group(1)), stress


with tempfile.TemporaryDirectory() as folder:
    with open(os.path.join(folder, "data.txt"), "w") as data:
        data.write(f"packing\n\n{len(grains)} atoms\n1 atom types\n\n")
        for axis, length in zip("xyz", box):
            data.write(f"0 {length} {axis}lo {axis}hi\n")
        data.write("\nAtoms\n\n")
        for k, (x, y, z, r) in enumerate(grains, 1):
            data.write(f"{k} 1 {2 * r} {density} {x} {y} {z}\n")
    open(os.path.join(folder, "in.txt"), "w").write(script)
    rows = {"LAMMPS gran/hertz/history, 1 core": [], "puadem, 1 thread": [], "puadem, 2 threads": []}
    for _ in range(repeats):
        rows["LAMMPS gran/hertz/history, 1 core"].append(lammps(folder))
        rows["puadem, 1 thread"].append(puadem(1))
        if (os.cpu_count() or 1) > 1:
            rows["puadem, 2 threads"].append(puadem(2))

work = len(grains) * steps * 1e-6
reference = min(rows["LAMMPS gran/hertz/history, 1 core"])[0]
print(f"{len(grains)} grains, {steps} steps, best of {repeats}\n")
print("| code | s | Mps/s | against LAMMPS | pair stress at the end, Pa |\n|---|---|---|---|---|")
for name, runs in rows.items():
    if runs:
        seconds, stress = min(runs)
        print(f"| {name} | {seconds:.3f} | {work / seconds:.2f} | {reference / seconds:.2f} | {stress:.2f} |")
