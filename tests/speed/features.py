#!/usr/bin/python3
"""What a scene's features cost: features.py BIN_FOLDER SCENES_FOLDER

Runs the small scenes with each feature on and off and prints: bytes that a contact remembers (as
--check says), processor time per step, time to read and check the scene, most memory, and how many
libraries the program loads and whether those of the finite elements are among them. What a scene does
not name it does not pay for."""
import json
import os
import re
import subprocess
import sys
import tempfile

BIN, SCENES = sys.argv[1], sys.argv[2]
os.environ["OMP_WAIT_POLICY"] = "passive"

DRY = {"binder": "none", "stones.fracture": "none"}
FLOW = {"stones.count": 600, "flow.displacement": "0.5 mm", "output.picture_interval": "0 s"}
RIGID = {"head.elastic": "none", "mould.elastic": "none"}
TURN = {"gyration.count": 0.5, "gyration.ramp": "0.2 s", "output.picture_interval": "0 s",
        "output.movie": "false"}
CASES = [
    ("flow test, dry", "flow_test", {**FLOW, **DRY}),
    ("+ restitution", "flow_test", {**FLOW, **DRY, "stones.restitution": 0.5}),
    ("+ fracture", "flow_test", {**FLOW, "binder": "none"}),
    ("+ binder", "flow_test", {**FLOW, "stones.fracture": "none"}),
    ("+ binder, bonds of no strength", "flow_test",
     {**FLOW, "stones.fracture": "none", "binder.bond_energy": 0}),
    ("+ binder, fracture", "flow_test", FLOW),
    ("+ binder, fracture, energy ledger", "flow_test",
     {**FLOW, "output.energy_ledger": "true"}),
    ("+ binder, fracture, a row every 1 ms", "flow_test",
     {**FLOW, "output.history_interval": "1 ms"}),
    ("gyratory, dry, rigid steel", "gyratory", {**TURN, **RIGID, **DRY}),
    ("gyratory, rigid steel", "gyratory", {**TURN, **RIGID}),
    ("+ elastic head", "gyratory", {**TURN, "mould.elastic": "none"}),
    ("+ elastic head and mould", "gyratory", TURN),
    ("+ elastic head and mould, maps", "gyratory", {**TURN, "output.maps": "true"}),
]


def command(program, scene):
    kind = "flow" if program == "flow_test" else "gyratory"
    line = [os.path.join(BIN, program), os.path.join(SCENES, f"{kind}_sma11_150C.toml"),
            "--threads", "1"]
    for key, value in scene.items():
        line += ["--set", f"{key}={value}"]
    return line


def spent(line):
    """Processor time [s] and most memory [MB] of a process."""
    process = subprocess.Popen(line, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"failed: {' '.join(line)}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def libraries(program, scene):
    if program == "gyratory" and not RIGID.items() <= scene.items():
        program = "gyratory_elastic"  # to which it hands elastic steel on
    names = subprocess.run(["ldd", os.path.join(BIN, program)], capture_output=True, text=True,
                           check=True).stdout
    elements = "yes" if re.search("deal_II|trilinos|libmpi", names) else "no"
    return names.count("\n"), elements


def main():
    print("| scene | a contact remembers | us a step | start-up | most memory | libraries | "
          "of them finite elements, MPI |\n|---|---:|---:|---:|---:|---:|---|")
    for label, program, scene in CASES:
        line = command(program, scene)
        told = subprocess.run(line + ["--check"], capture_output=True, text=True, check=True).stdout
        memory = re.search(r"remembers (\d+) B", told).group(1)
        start = min(spent(line + ["--check", "--quiet"])[0] for _ in range(5))
        with tempfile.TemporaryDirectory() as place:
            folder = os.path.join(place, "run")
            seconds, most = spent(line + ["--out", folder, "--quiet"])
            with open(os.path.join(folder, "summary.json")) as file:
                summary = json.load(file)
        seconds -= start + summary["seconds_steel_setup"]
        count, elements = libraries(program, scene)
        print(f"| {label} | {memory} B | {1e6 * seconds / summary['steps']:.0f} | {1e3 * start:.0f} ms "
              f"| {most:.0f} MB | {count} | {elements} |", flush=True)


if __name__ == "__main__":
    main()
