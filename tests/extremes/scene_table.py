#!/usr/bin/python3
"""Whole scenes at their extremes:

    scene_table.py BIN_FOLDER SCENES_FOLDER [TABLE.md | --only WORD] [--long]

Runs a small gyratory compaction with one thing at a time taken to its extreme, and prints how each
ends: as a run whose energy ledger is closed, with its inertial number and the warnings that --check
gives beforehand, or as a stop with its reason. Exits 1 if one hangs, crashes, writes a number that
is not finite, or leaves more than 1 % of the work unexplained in any row of the history without a
warning beforehand."""
import argparse
import datetime
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import h5py
import numpy as np

os.environ["OMP_WAIT_POLICY"] = "passive"
LONGEST = 1500  # of a run [s]: beyond it is hung
STOPPED = 60  # a run that would take hours [s]: some thousand steps of it
TODAY = datetime.date.today()
STOPPED_TWICE = f"200,000 stones, stopped twice, on {TODAY}"
LONG = ("| 20,000 stones", "| 200,000 stones")  # rows that --long makes

INTRODUCTION = """# Scenes at their extremes

Made by `tests/extremes/scene_table.py build/bin apps/scenes tests/extremes/scene_table.md`. The
rows of 20,000 and 200,000 stones are made with `--long`, on the day they tell, and kept without it.
One thing at a time is taken to its extreme in a scene of 150 stones of SMA 11 between rigid walls,
a quarter of a gyration at 600 kPa. Residual, where the energy ledger watches: the most that it
cannot explain in any row of the history, of the most work in any. Weak stones break where they
touch another stone: their shells keep most apart. Inertial number: as `--check` foretells it; at
3e-4 a quarter of the densification is lost ([trade.md](../../apps/docs/trade.md)), up to 1e-3 flows
are called quasi-static. A warning is what `--check` says before the run.

| extreme | ends | air voids | broken | steps | residual | inertial number | warning |
|---|---|---|---|---|---|---|---|
"""
BASE = {"stones.count": 150, "mould.diameter": "36 mm", "mould.elastic": "none",
        "head.elastic": "none", "gyration.ramp": "0.2 s", "gyration.count": 0.25,
        "output.picture_interval": "0 s", "output.movie": "false",
        "output.energy_ledger": "true"}


def sieves(place, rows):
    path = os.path.join(place, f"sieves{len(os.listdir(place))}.csv")
    with open(path, "w") as file:
        file.write("sieve_mm,passing_percent\n")
        file.writelines(f"{size},{passing}\n" for size, passing in rows)
    return path


def settings(place, long):
    """Label and overrides of each extreme."""
    yield "as it is", {}
    scaled = {"mould.diameter": "none", "mould.aspect_ratio": 1}
    for count in (1, 2):
        yield f"{count} stones", {"stones.count": count, "mould.diameter": "28 mm"}
    if long:
        yield f"20,000 stones, 0.02 gyrations, on {TODAY}", {
            **scaled, "stones.count": 20000, "gyration.count": 0.02, "gyration.ramp": "0.05 s",
            "output.energy_ledger": "false", "fill.rest_energy": 0.1}
        yield STOPPED_TWICE, {
            **scaled, "stones.count": 200000, "output.energy_ledger": "false"}
    for pressure in ("1 kPa", "10 MPa"):
        yield pressure, {"gyration.pressure": pressure}
    for angle in (0, 5):
        yield f"tilt {angle} deg", {"gyration.angle": f"{angle} deg"}
    for speed, count in ((1, 0.02), (300, 2)):
        yield f"{speed} rev/min, {count} gyrations", {"gyration.speed": f"{speed / 60} rev/s",
                                                      "gyration.count": count}
    for label, modulus in (("-20 degC: 500 MPa", "500 MPa"), ("200 degC: 10 kPa", "10 kPa")):
        yield label, {"binder.temperature": "none", "binder.shear_modulus": modulus,
                      "binder.alpha": "[0.513, 0.487]", "binder.tau": "[0.0948, 105.9]"}
    yield "no binder", {"binder": "none"}
    for content in ("3 %", "12 %"):
        yield f"{content} of binder", {"binder.content": content}
    for friction in (0, 1.5):
        yield f"friction {friction}", {"stones.friction": friction, "mould.wall_friction": friction,
                                       "head.friction": friction}
    yield "equal stones, mould of 50 mm", {"stones.gradation": sieves(place, [(7.9, 0), (8, 100)]),
                           "stones.distribution": "log_linear", "stones.smallest": "7.9 mm",
                           "binder.content": "6.6 %", "mould.diameter": "50 mm"}
    yield "sizes 1:16, 1500 stones", {"stones.gradation": sieves(place, [(1, 0), (16, 100)]),
                         "stones.distribution": "log_linear", "stones.smallest": "1 mm",
                         "stones.count": 1500, "mould.diameter": "40 mm",
                         "output.energy_ledger": "false"}
    for strength in (40, 1):
        yield f"stones of {strength} MPa", {"stones.fracture.scale": f"{strength} MPa"}
    yield "stones of 1 MPa, no binder", {"stones.fracture.scale": "1 MPa", "binder": "none"}
    for restitution in (1, 0.01):
        yield f"no binder, restitution {restitution}", {
            "binder": "none", "stones.fracture": "none", "stones.restitution": restitution}
    for scale in (1, 1e2, 1e5, 1e6, 1e7):
        brief = {"gyration.ramp": "0.02 s", "gyration.count": 0.02} if scale < 10 else {}
        label = ", 0.02 gyrations" if brief else ""
        yield f"mass scale {scale:.0e}{label}", {"numerics.mass_scale": scale, **brief}
    for safety in (0.5, 1, 1.5, 2, 3):  # a single contact swings stably up to 2
        yield f"time step {safety} sqrt(m/k)", {"numerics.safety": safety}


def command(program, options, scene):
    line = [os.path.join(options.bin, program),
            os.path.join(options.scenes, "gyratory_sma11_150C.toml"), "--threads", "1"]
    for key, value in scene.items():
        line += ["--set", f"{key}={value}"]
    return line


def flat(scene):
    """Without the keys below a section that is taken away, and with `none` first."""
    gone = [key for key, value in scene.items() if value == "none"]
    kept = {key: value for key, value in scene.items()
            if not any(key.startswith(section + ".") for section in gone)}
    return dict(sorted(kept.items(), key=lambda item: item[1] != "none"))


def stop_twice(line, folder):
    """Stops a run after a while, lets it go on from there, and tells how far it came each time."""
    reached = []
    for more in (line + ["--out", folder], [line[0], "--resume", folder, "--threads", "1"]):
        with subprocess.Popen(more, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True) as process:
            try:
                process.wait(STOPPED)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGINT)
            said = process.communicate()[0]
        if process.returncode != 130:
            return {"ends": f"FAILS, status {process.returncode}: {said.splitlines()[-1]}",
                    "sound": False}
        reached.append(float(re.findall(r"time (\S+) s", said)[-1]))
    return {"ends": f"stopped while settling at {reached[0]:.2f} s, goes on, stopped at "
                    f"{reached[1]:.2f} s", "sound": reached[1] > reached[0]}


def run(options, label, changes):
    scene = flat({**BASE, **changes})
    told = subprocess.run(command("gyratory", options, scene) + ["--check"], capture_output=True,
                          text=True)
    number = re.search(r"inertial number\s+(\S+)", told.stdout)
    row = {"label": label, "number": number.group(1) if number else "", "sound": True,
           "warning": "; ".join(re.findall(r"warning: ([^;,\n]*)", told.stdout))}
    if told.returncode == 2:
        return {**row, "ends": "refused: " + told.stderr.strip().split("expected ")[-1],
                "sound": False}
    with tempfile.TemporaryDirectory() as place:
        folder = os.path.join(place, "run")
        if label == STOPPED_TWICE:
            return {**row, **stop_twice(command("gyratory", options, scene), folder)}
        try:
            done = subprocess.run(command("gyratory", options, scene) +
                                  ["--out", folder, "--quiet"], capture_output=True, text=True,
                                  timeout=LONGEST)
        except subprocess.TimeoutExpired:
            return {**row, "ends": f"HANGS: over {LONGEST} s", "sound": False}
        if done.returncode == 3:
            return {**row, "ends": done.stderr.strip().splitlines()[-1]}
        if done.returncode != 0:
            return {**row, "ends": f"FAILS, status {done.returncode}", "sound": False}
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            history = {key: values[:] for key, values in file["history"].items()}
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    finite = all(np.isfinite(values).all() for values in history.values())
    row.update(ends="runs" if finite else "NOT FINITE", sound=finite,
               voids=f"{100 * summary['air_voids_end']:.1f} %", broken=summary["fractured_stones"],
               steps=f"{summary['steps']:.1e}")
    if "energy_residual" in history:
        # The shares that the rows tell would not do: the first are of next to no work.
        work = np.abs(history["energy_work_of_walls"]) + np.abs(history["energy_work_of_gravity"])
        share = np.max(np.abs(history["energy_residual"])) / np.max(work)
        row["residual"] = f"{share:.0e}"
        row["sound"] = finite and (share < 0.01 or "energy may come" in row["warning"])
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin")
    parser.add_argument("scenes")
    parser.add_argument("table", nargs="?")
    parser.add_argument("--only", default="", help="extremes whose label has this word")
    parser.add_argument("--long", action="store_true",
                        help="20,000 and 200,000 stones, too: a quarter of an hour in all; "
                        "without it the table keeps their rows")
    options = parser.parse_args()
    if options.only and options.table:
        parser.error(f"--only makes a part of the table, which would replace {options.table}")
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(os.cpu_count()) as workers:
        asked = [case for case in settings(place, options.long) if options.only in case[0]]
        rows = list(workers.map(lambda case: run(options, *case), asked))
    lines = ["| " + " | ".join(str(row.get(key, "")) for key in (
        "label", "ends", "voids", "broken", "steps", "residual", "number", "warning")) + " |\n"
             for row in rows]
    if options.table and not options.long and os.path.exists(options.table):
        with open(options.table) as page:
            lines += [line for line in page if line.startswith(LONG)]
    text = INTRODUCTION + "".join(sorted(lines, key=lambda line: line.startswith(LONG)))
    print(text)
    if options.table:
        with open(options.table, "w") as file:
            file.write(text)
    sys.exit(0 if all(row["sound"] for row in rows) else 1)


if __name__ == "__main__":
    main()
