#!/usr/bin/env python3
"""The elastic steel at its extremes: steel_table.py BIN_FOLDER SCENES_FOLDER [TABLE.md]

Runs a small gyratory compaction for each setting and prints a table: setting, gain (bound of the
bed's stiffness over that of the softest mode: a bare static exchange diverges above 1), stable
(the run ended, exit status 0, with every number finite), drift (mean force of the mix on the head
over the last quarter gyration against ram and weight). Then the rigid limit: steel a million times
stiffer against rigid walls. Exits 1 if a run diverges."""
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import h5py
import numpy as np

BIN, SCENES = sys.argv[1], sys.argv[2]
os.environ["OMP_WAIT_POLICY"] = "passive"

INTRODUCTION = """Made by `tests/extremes/steel_table.py build/bin apps/scenes tests/extremes/steel_table.md` (150 stones,
0.5 gyrations; test `extremes.no_setting_of_the_steel_diverges`, slow). Gain: bound of the bed's
stiffness over that of the softest mode; a bare static exchange diverges above 1
(`static_exchange.settles_below_its_threshold_and_chatters_above`). Drift: mean force of the mix on the
head over the last quarter gyration against ram and weight. With inertia scaled by 1e5 the head has not
come to rest on the mix when the run ends: its drift is that of a short run, not of the coupling. Rubber
is pressed with 1 kPa: under 600 kPa the linear shaft of 14 mm would shorten by four times its length, and
the run stops with status 3.
"""

STEEL = 210e9  # [Pa]
BASE = {"stones.count": "150", "mould.diameter": "36 mm", "gyration.ramp": "0.2 s",
        "gyration.count": "0.5", "output.picture_interval": "0 s", "mould.elastic.modes": "20",
        "head.elastic.shaft_diameter": "14 mm", "mould.elastic.height": "90 mm"}
RIGID = {"head.elastic": "none", "mould.elastic": "none"}


def run(changes):
    """History and summary of a run, or what it said when it failed."""
    scene = {**BASE, **changes}
    if scene.get("head.elastic") == "none":
        scene = {key: value for key, value in scene.items()
                 if not key.startswith(("head.elastic.", "mould.elastic."))}
    with tempfile.TemporaryDirectory() as place:
        folder = os.path.join(place, "run")
        line = [os.path.join(BIN, "gyratory"), os.path.join(SCENES, "gyratory_sma11_150C.toml"),
                "--out", folder, "--quiet", "--threads", "1"]
        for key, value in scene.items():
            line += ["--set", f"{key}={value}"]
        done = subprocess.run(line, capture_output=True, text=True)
        if done.returncode != 0:
            return None, done.stderr.strip()
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            history = {key: values[:] for key, values in file["history"].items()}
        with open(os.path.join(folder, "summary.json")) as file:
            return history, json.load(file)


def drift(history, summary):
    late = history["gyration"] > history["gyration"][-1] - 0.25
    section = np.pi / 4 * summary["mould_diameter_m"] ** 2
    wanted = np.mean(history["ram_pressure"][late]) * section + summary["head_weight_N"]
    return np.mean(history["head_force"][late]) / wanted - 1


def young(share):
    """Young's modulus of all steel. Rubber is pressed with 1 kPa: under 600 kPa the shaft, linear as
    it is, would shorten to less than nothing."""
    text = f"{STEEL * share:g} Pa"
    soft = {"gyration.pressure": "1 kPa"} if STEEL * share < 1e7 else {}
    return {"head.elastic.young": text, "mould.elastic.young": text, **soft}


def settings(stiffness):
    """Label and overrides of each setting; `stiffness` of the head in steel [N m/rad]."""
    for wanted in (1e4, 1e5, 1e6, 1e7, 1e8, 1e9):
        yield (f"head {wanted:.0e} N m/rad",
               {"head.elastic.young": f"{STEEL * wanted / stiffness:g} Pa"})
    for modulus in (1e6, 1e8, 1e10, 1e12, 1e15, 1e18):
        at = ", 1 kPa" if modulus < 1e7 else ""
        yield f"all steel E = {modulus:.0e} Pa{at}", young(modulus / STEEL)
    for wall in (2, 5, 7.5, 15, 30):
        yield f"mould wall {wall} mm", {"mould.elastic.wall_thickness": f"{wall} mm"}
    for interval in (1, 10, 100, 1000):
        yield f"exchange every {interval} steps", {"numerics.exchange_interval": str(interval)}
        yield (f"exchange every {interval} steps, E = 1e+06 Pa, 1 kPa",
               {"numerics.exchange_interval": str(interval), **young(1e6 / STEEL)})
    for scale in (1, 100, 1e5):
        short = {} if scale > 50 else {"gyration.ramp": "0.02 s", "gyration.count": "0.02"}
        both = {"numerics.mass_scale": f"{scale:g}", "numerics.head_mass_scale": f"{scale:g}"}
        yield f"mass scale {scale:g}", {**both, **short}


def rigid_limit(out):
    """Until when, and how well after that, nearly rigid steel follows rigid walls."""
    rigid, stiff = run(RIGID), run(young(1e6))
    if rigid[0] is None or stiff[0] is None:
        return False
    out("\n| steel x 1e6 against rigid walls | |\n|---|---|")
    force = stiff[0]["head_force"] - rigid[0]["head_force"]
    apart = np.abs(force) > 1e-2 * np.max(rigid[0]["head_force"])
    since = rigid[0]["time"][np.argmax(apart)] if apart.any() else rigid[0]["time"][-1]
    out(f"| head force within 1 % of its largest until | {since:.2f} s of"
        f" {rigid[0]['time'][-1]:.2f} s |")
    for name, text in (("height", "height"), ("air_voids", "air voids"),
                       ("coordination", "coordination"), ("head_force", "head force")):
        late = rigid[0]["gyration"] > rigid[0]["gyration"][-1] - 0.25
        mean = [np.mean(history[name][late]) for history in (stiff[0], rigid[0])]
        out(f"| mean {text} over the last quarter gyration | {mean[0] / mean[1] - 1:+.1e} |")
    return True


def main():
    lines = []

    def out(text):
        print(text, flush=True)
        lines.append(text)

    history, steel = run({})
    if history is None:
        sys.exit(steel)
    out("| setting | gain of the head | gain of the mould | stable | drift |\n|---|---|---|---|---|")
    good = True
    asked = list(settings(1 / abs(steel["head_tilt_per_moment_rad_per_Nm"])))
    with ThreadPoolExecutor(max_workers=4) as workers:
        answers = list(workers.map(lambda setting: run(setting[1]), asked))
    for (label, _), (history, summary) in zip(asked, answers):
        stable = history is not None and all(np.isfinite(v).all() for v in history.values())
        good = good and stable
        gains = (f"{summary['head_gain']:.2g} | {summary['mould_gain']:.2g}" if stable else "- | -")
        out(f"| {label} | {gains} | {'yes' if stable else 'NO: ' + summary} |"
            f" {f'{drift(history, summary):+.1%}' if stable else ''} |")
    good = rigid_limit(out) and good
    if len(sys.argv) > 3:
        with open(sys.argv[3], "w") as file:
            file.write("# The elastic steel at its extremes\n\n" + INTRODUCTION + "\n" +
                       "\n".join(lines) + "\n")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
