#!/usr/bin/python3
"""Writes the page of the physics checks, README.md in this folder, and its picture:

    tests/physics/checks.py

runs build/tests/physics_tests, which adds a row for every check it makes, and takes the comparison
with other codes from bulk.csv, as compare_bulk.py --out wrote it last. Exits 1 if a check does not
hold, or at a suite that it does not know."""
import argparse
import collections
import csv
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import compare_bulk
import plot_impacts

HERE = os.path.dirname(os.path.abspath(__file__))
HOUSE = os.path.dirname(os.path.dirname(HERE))
COLUMNS = ["suite", "test", "quantity", "unit", "at", "computed", "reference", "kind", "tolerance",
           "source"]
SUITES = {
    "binder": "Binder: normal force", "film": "Binder: shear of the film", "bond": "Bond",
    "ting": "Binder: unloading against Ting's exact solution", "hertz": "Stone: normal force",
    "mindlin": "Stone: shear force", "impact": "Impacts of Chung & Ooi (2011)",
    "fracture": "Fracture", "strength": "Strength", "frame": "Frame of a contact",
    "passivity": "Energy of closed paths", "contact_box": "Anywhere in the box of a scene",
    "stability": "Critical time step", "statics": "Beds at rest"}
LEFT_OUT = {"energy", "ledger", "ledger_beds", "random"}  # plain GoogleTest, which writes no rows

OPENING = """# What the contact physics is checked against

Written by `tests/physics/checks.py`: no number in a table is typed by hand. Every check of the
contact laws, fracture, the time step and beds at rest that a test of this folder or of
`tests/extremes/contact_box_test.cc` makes with `check.h` is a line; checks that differ in one
number only share a line, which shows the one nearest to its tolerance, and their count. The reason
of each tolerance is in the test that makes the check.

What these tests expect beside, in plain GoogleTest, is no line, and neither is anything of
`energy_test.cc` and `ledger_test.cc` (the balance of energy), `steel_*.cc` and `coupling_*.cc`
(elastic steel, and what couples it to the stones).
"""
IMPACTS = """
![Impacts of Chung & Ooi](impacts.png)

Drawn by `tests/physics/plot_impacts.py` from the same rows: dots are ours, lines and crosses the
references.

Where friction sticks, no closed form exists. The curve of Chung & Ooi is that of their spring,
T = -8 G* a s, as an integration apart from our simulation shows; what Cattaneo and Mindlin's theory
has is partial slip, solved by Maw, Barber & Fawcett (1976), whose deepest reversal finite elements
confirm. Ours is a spring, too, which gives up force as the contact shrinks so that no cycle creates
energy; unlike theory it does not know where the contact has slipped, and differs from it by as much
as the lines "exact partial slip" say.
"""
BULK = """
## Beds against other codes

From `tests/physics/compare_bulk.py --steps {steps} --out tests/physics/bulk.csv`: {beds} beds of {stones}
stones, {steps} steps of 1 us from rest without shear springs; the shared bed, and others by its
generator and settling deck with the seeds {seeds}. Floor and wall force are those of Hertz at the
last overlaps, / weight; they exceed 1 because the beds were settled soft and hardened under load,
which their wall friction holds in place. `scatter` is the standard deviation over the beds, of ours
and of ours less theirs.

{table}

What differs, and is not tuned away:
- LIGGGHTS and LAMMPS damp in shear, ours does not. At the start, where stones without shear springs
  settle anew, damping saves some of the locked-in load. LIGGGHTS without it, the last code of the
  table, stays with ours.
- `hertz/history` of LAMMPS damps by constants, not by a restitution.
- The walls of LAMMPS `granular` are 1 + nu times stiffer than Hertz (E / 2(1 - nu) in place of
  E / 2(1 - nu^2)) and lose more of their load at the start, which works against the damping in
  shear: that its floor force is near to ours is chance. Both of its styles count the curvature of
  the cylinder. The probe of compare_bulk.py measures this; the forces are counted with it.
- They keep the displacement of the shear spring while a contact shrinks; ours gives up force.
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=f"{HOUSE}/build/tests/physics_tests")
    parser.add_argument("--bulk", default=f"{HERE}/bulk.csv")
    parser.add_argument("--out", default=HERE, help="folder of the page")
    return parser.parse_args()


def rows_of(program):
    """Runs the tests and reads the rows they write; numbers as numbers."""
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/rows.csv"
        done = subprocess.run([program, "--gtest_brief=1"],
                              env=os.environ | {"GYRATORY_CHECKS": path, "RC_PARAMS": "seed=1"})
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file, COLUMNS))
    for row in rows:
        for name in ("at", "computed", "reference", "tolerance"):
            row[name] = float(row[name])
        row["error"] = abs(row["computed"] - row["reference"])
    return rows, done.returncode == 0


def unknown_suites(program, rows):
    """Suites without a title that are not left out, or write rows in spite of it."""
    listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True,
                            check=True).stdout
    suites = set(re.findall(r"^(\S+)\.(?:\s|$)", listed, re.MULTILINE)) - LEFT_OUT
    return sorted((suites | {row["suite"] for row in rows}) - set(SUITES))


def strain(row):
    """How much of its tolerance a check uses; above 1 it does not hold."""
    if row["kind"] in ("at_least", "at_most"):
        sign = 1 if row["kind"] == "at_most" else -1
        return 1 + sign * (row["computed"] - row["reference"]) / (abs(row["reference"]) or 1)
    allowed = row["tolerance"] * (abs(row["reference"]) if row["kind"] == "relative" else 1)
    return row["error"] / allowed if allowed else float(row["error"] > 0)


def shown(value, unit=""):
    return f"{value:.4g}" + ("" if unit in ("", "1") else f" {unit}")


def line_of(group):
    row = max(group, key=strain)
    unit, relative = row["unit"], row["kind"] == "relative"
    if row["kind"] in ("at_least", "at_most"):
        error, tolerance = "", "at least" if row["kind"] == "at_least" else "at most"
    elif relative:
        error = f"{100 * row['error'] / abs(row['reference']):.2g} %"
        tolerance = f"{100 * row['tolerance']:.2g} %"
    else:
        error, tolerance = shown(row["error"], unit), shown(row["tolerance"], unit)
    where = "" if row["at"] != row["at"] else f" (at {row['at']:.4g})"
    cells = [row["quantity"] + where, row["source"], shown(row["computed"], unit),
             shown(row["reference"], unit), error, tolerance, str(len(group))]
    return "| " + " | ".join(cells) + " |"


def section(title, rows, text=""):
    groups = collections.defaultdict(list)
    for row in rows:
        groups[row["quantity"], row["source"]].append(row)
    head = ("| quantity | reference | computed | expected | error | tolerance | checks |\n"
            "|---|---|---|---|---|---|---|\n")
    return f"\n## {title}\n{text}\n{head}" + "\n".join(map(line_of, groups.values())) + "\n"


def bulk_section(path):
    with open(path, newline="") as file:
        runs = compare_bulk.read_runs(file)
    beds = sorted({bed for bed, _ in runs})
    table = "| " + " | ".join(compare_bulk.HEAD) + " |\n" + "|---" * len(compare_bulk.HEAD) + "|\n"
    table += "\n".join("| " + " | ".join(line) + " |" for line in compare_bulk.comparison(runs))
    first = next(iter(runs.values()))
    return BULK.format(beds=len(beds), stones=int(first["stones"]), steps=int(first["steps"]),
                       seeds=", ".join(bed for bed in beds if bed != "shared"), table=table)


def main():
    options = arguments()
    rows, passed = rows_of(options.program)
    if unknown := unknown_suites(options.program, rows):
        sys.exit(f"checks.py: {', '.join(unknown)}: give each suite a title in SUITES or, if it "
                 "writes no rows, name it in LEFT_OUT")
    page = OPENING
    for suite, title in SUITES.items():
        mine = [row for row in rows if row["suite"] == suite]
        if mine:
            page += section(title, mine, IMPACTS if suite == "impact" else "")
    page += bulk_section(options.bulk)
    plot_impacts.picture(rows).savefig(f"{options.out}/impacts.png", dpi=110)
    with open(f"{options.out}/README.md", "w") as file:
        file.write(page)
    verdict = "all hold" if passed else "NOT ALL HOLD"
    print(f"{len(rows)} checks, {verdict}: {options.out}/README.md")
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
