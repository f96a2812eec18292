#!/usr/bin/python3
"""Runs the same settled beds of dry stones with ours and with other DEM codes, from the same decks
and to the same time, and prints what the walls carry, how high the beds stand and how many
neighbours a stone has.

The beds are those of the peers' own generator, settled by their own deck, one for each seed. All
codes start from the same stones, without shear springs, and take the same steps. Forces are those
of Hertz at the last overlaps, counted by one routine for all; where a code's wall is stiffer than
4/3 E0 sqrt(R) d^1.5, which a probe of a stone on floor and cylinder finds out, its factor is used.
Needs numpy, and of the other codes (LAMMPS, LIGGGHTS) those that are to be compared with."""
import argparse
import csv
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile

import numpy

HOUSE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
UNDAMPED = "liggghts_no_shear_damping"        # the shared deck with that one option added
PROGRAMS = {"lammps_hist": "lmp", "lammps_granular": "lmp", "liggghts": "liggghts",
            UNDAMPED: "liggghts"}
YOUNG, POISSON, GRAVITY = 1e9, 0.15, 196.2    # of the decks [Pa], [-], [m/s2]
STIFFNESS = 4 / 3 * YOUNG / (2 * (1 - POISSON**2))  # of Hertz, a stone on a wall of stone [Pa]
TIME_STEP = 1e-6                              # of the decks [s]
QUANTITIES = {"floor_force": "floor force / weight", "wall_force": "wall's normal force / weight",
              "height": "bed height / mm", "centre": "height of the centre of mass / mm",
              "coordination": "mean coordination"}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peers", default=os.path.join(os.path.dirname(HOUSE), "shared", "peers"),
                        help="folder with beds/, decks/, gen_packing.py and run_bench.py")
    parser.add_argument("--program", default=os.path.join(HOUSE, "build", "bin", "dem_speed"))
    parser.add_argument("--codes", default=",".join(PROGRAMS))
    parser.add_argument("--stones", type=int, default=5000)
    parser.add_argument("--seeds", type=int, default=5, help="number of beds")
    parser.add_argument("--steps", type=int, default=20000, help="of 1 us")
    parser.add_argument("--beds", help="folder that keeps the settled beds for another call")
    parser.add_argument("--out", help="table of every run (CSV) to write")
    options = parser.parse_args()
    if not os.path.isfile(os.path.join(options.peers, "run_bench.py")):
        parser.error(f"no run_bench.py in {options.peers}; name the folder with --peers")
    if not os.access(options.program, os.X_OK):
        parser.error(f"no program at {options.program}; build it, or name it with --program")
    return options


class Peers:
    """The other codes, their decks and their generator of beds."""

    def __init__(self, folder, scratch):
        sys.dont_write_bytecode = True
        sys.path.insert(0, folder)
        import beds
        import gen_packing
        import run_bench
        self.beds, self.generator, self.bench = beds, gen_packing, run_bench
        self.folder, self.scratch = folder, scratch

    def settled_bed(self, stones, seed, path):
        """Writes a bed of the generator, settled by the peers' deck, as a file of ours."""
        self.generator.SEED = seed
        position, radius = self.generator.generate(stones)[:2]
        data, out = f"{self.scratch}/loose", f"{self.scratch}/settled"
        self.beds.write_data(data, position, radius, self.beds.cyl_radius(stones), "lammps")
        self.bench.sh(self.bench.MPI + [
            "2", "lmp", "-nc", "-in", f"{self.folder}/decks/in.settle.lmp", "-log", "none", "-var",
            "data", data, "-var", "R", repr(self.beds.cyl_radius(stones)), "-var", "S1", "12000",
            "-var", "S2", "20000", "-var", "out", out], self.scratch)
        position, radius = self.beds.read_dump(out)
        self.beds.write_bed(path, position, radius,
                            f"cylinder_radius={self.beds.cyl_radius(stones):.9f}")

    def run(self, code, position, radius, stones, steps):
        """Centres and radii after so many steps."""
        self.beds.write_data(f"{self.scratch}/data_{stones}", position, radius,
                             self.beds.cyl_radius(stones), "lammps")
        self.bench.HERE = self.without_shear_damping() if code == UNDAMPED else self.folder
        code = "liggghts" if code == UNDAMPED else code
        self.bench.one(code, stones, 1, self.bench.BEST[code], steps - 1, 1, self.scratch)
        return self.beds.read_dump(f"{self.scratch}/out")

    def without_shear_damping(self):
        """A folder with the decks, LIGGGHTS's with its damping in shear taken away."""
        changed = f"{self.scratch}/undamped"
        if not os.path.exists(changed):
            shutil.copytree(f"{self.folder}/decks", f"{changed}/decks")
            with open(f"{self.folder}/decks/in.liggghts") as deck:
                lines = [line.rstrip() + " tangential_damping off" * ("hertz tangential" in line)
                         for line in deck]
            os.chmod(f"{changed}/decks", 0o755)
            os.remove(f"{changed}/decks/in.liggghts")
            with open(f"{changed}/decks/in.liggghts", "w") as deck:
                deck.write("\n".join(lines) + "\n")
        return changed


class WallLaw:
    """Force of a code's walls / that of Hertz with the stone's own radius."""

    def __init__(self, floor=1.0, curved=False):
        self.floor, self.curved = floor, curved

    def at_cylinder(self, radius, cylinder):
        return self.floor * (1 / numpy.sqrt(1 - radius / (2 * cylinder)) if self.curved else 1)

    @classmethod
    def of(cls, peers, code):
        """By one stone on the floor, one at the cylinder and a pair, each pressed by 1 % of a
        radius, and the way they are thrown in the first step."""
        stones, steps = 5000, 1  # stones of the cylinder; before anything moves nothing is damped
        cylinder = peers.beds.cyl_radius(stones)
        radius = 0.2 * cylinder
        overlap = 0.01 * radius
        start = numpy.array([[0, 0, radius - overlap],
                             [cylinder - radius + overlap, 0, 4 * radius],
                             [-2 * radius, 0, 4 * radius],
                             [-2 * radius, 0, 6 * radius - overlap]])
        moved = peers.run(code, start, numpy.full(len(start), radius), stones, steps)[0] - start
        mass = peers.beds.DENSITY * 4 / 3 * math.pi * radius**3
        thrown = 0.5 * (steps * TIME_STEP)**2 / mass * STIFFNESS * math.sqrt(radius) * overlap**1.5
        fallen = 0.5 * (steps * TIME_STEP)**2 * GRAVITY
        pair = (moved[3, 2] - moved[2, 2]) / 2 / thrown * math.sqrt(2)
        if abs(pair - 1) > 0.01:
            sys.exit(f"{code}: expected pairs as stiff as ours, found {pair:.3f} times")
        floor = (moved[0, 2] + fallen) / thrown
        return cls(floor, -moved[1, 0] / thrown / floor > 1.01)


def state_of(peers, position, radius, cylinder, law):
    """What one reads off a bed."""
    weight = peers.beds.DENSITY * 4 / 3 * math.pi * (radius**3).sum() * GRAVITY

    def hertz(overlap, factor):
        return (factor * STIFFNESS * numpy.sqrt(radius) * numpy.maximum(overlap, 0)**1.5).sum()

    at_wall = numpy.hypot(position[:, 0], position[:, 1]) + radius - cylinder
    tops = numpy.sort(position[:, 2] + radius)[-10:]
    return {"floor_force": hertz(radius - position[:, 2], law.floor) / weight,
            "wall_force": hertz(at_wall, law.at_cylinder(radius, cylinder)) / weight,
            "height": 1e3 * tops.mean(),
            "centre": 1e3 * (radius**3 * position[:, 2]).sum() / (radius**3).sum(),
            "coordination": 2 * peers.beds.contacts(position, radius, cylinder)[0] / len(radius)}


def ours(options, peers, bed, steps, scratch):
    out = f"{scratch}/ours.csv"
    command = [options.program, "--bed", bed, "--law", "dry", "--threads", "1", "--warmup",
               str(steps - 1), "--steps", "1", "--out", out]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit("failed: " + " ".join(command) + "\n" + done.stderr)
    return peers.beds.read_bed(out)


def bed_files(options, peers, folder):
    """The shared bed and as many of other seeds as asked for."""
    shared = os.path.join(options.peers, "beds", f"bed_{options.stones}.csv")
    yield "shared", shared
    for seed in range(1, options.seeds):
        path = os.path.join(folder, f"bed_{options.stones}_{seed}.csv")
        if not os.path.exists(path):
            print(f"settling the bed of seed {seed}", flush=True)
            peers.settled_bed(options.stones, seed, path)
        yield str(seed), path


HEAD = ["quantity", "code", "theirs", "ours", "scatter of ours", "ours less theirs",
        "of theirs", "scatter of the difference"]


def comparison(runs):
    """One line a quantity and code: means over the beds, and ours less theirs bed by bed."""
    beds = sorted({bed for bed, _ in runs})
    spread = lambda values: statistics.stdev(values) if len(values) > 1 else float("nan")
    for key, name in QUANTITIES.items():
        for code in sorted({code for _, code in runs} - {"ours"}):
            mine = [runs[bed, "ours"][key] for bed in beds]
            theirs = [runs[bed, code][key] for bed in beds]
            gaps = [a - b for a, b in zip(mine, theirs)]
            gap = statistics.mean(gaps)
            yield [name, code, f"{statistics.mean(theirs):.4g}", f"{statistics.mean(mine):.4g}",
                   f"{spread(mine):.2g}", f"{gap:+.2g}",
                   f"{100 * gap / statistics.mean(theirs):+.2f} %", f"{spread(gaps):.2g}"]


def read_runs(file):
    """The runs of a table that --out wrote, by bed and code."""
    runs = {}
    for row in csv.DictReader(file):
        place = row.pop("bed"), row.pop("code")
        runs[place] = {key: float(value) for key, value in row.items()}
    return runs


def main():
    options = arguments()
    codes = [code for code in options.codes.split(",") if shutil.which(PROGRAMS[code])]
    runs, rows = {}, []
    with tempfile.TemporaryDirectory() as scratch:
        peers = Peers(options.peers, scratch)
        cylinder = peers.beds.cyl_radius(options.stones)
        laws = {"ours": WallLaw()} | {code: WallLaw.of(peers, code) for code in codes}
        for code in codes:
            print(f"{code}: wall force / Hertz {laws[code].floor:.3f}"
                  f"{', and curvature at the cylinder' if laws[code].curved else ''}", flush=True)
        for bed, path in bed_files(options, peers, options.beds or scratch):
            start = peers.beds.read_bed(path)
            for code in ["ours"] + codes:
                end = (ours(options, peers, path, options.steps, scratch) if code == "ours" else
                       peers.run(code, *start, options.stones, options.steps))
                runs[bed, code] = state_of(peers, *end, cylinder, laws[code])
                rows.append({"bed": bed, "code": code, "stones": options.stones,
                             "steps": options.steps} | runs[bed, code])
                print(bed, code, {k: round(v, 5) for k, v in runs[bed, code].items()}, flush=True)
    layout = "{:<36} {:<16} {:>9} {:>9} {:>16} {:>17} {:>10} {:>26}"
    print(layout.format(*HEAD))
    for line in comparison(runs):
        print(layout.format(*line))
    if options.out:
        with open(options.out, "w", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys())
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    main()
