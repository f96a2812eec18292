#!/usr/bin/env python3
"""Whole runs of the programs: runs_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

Each test is one run or two of a bed small enough to take seconds."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

BIN, SCENES = sys.argv[1], sys.argv[2]
os.environ["OMP_WAIT_POLICY"] = "passive"  # tests run side by side: waiting threads must not spin

SMALL = ["stones.count=150", "mould.diameter=36 mm", "gyration.ramp=0.5 s", "gyration.count=2"]
STEEL = ["head.elastic.shaft_diameter=14 mm", "mould.elastic.modes=20"]
RIGID = ["head.elastic=none", "mould.elastic=none"]


def command(program, scene, folder, overrides, *options):
    line = [os.path.join(BIN, program), os.path.join(SCENES, scene), "--out", folder, "--quiet"]
    for override in overrides:
        line += ["--set", override]
    return line + list(options)


class Runs(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)

    def run_scene(self, name, program, scene, overrides, *options):
        folder = os.path.join(self.place.name, name)
        subprocess.run(command(program, scene, folder, overrides, *options), check=True)
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            history = {key: values[:] for key, values in file["history"].items()}
        with open(os.path.join(folder, "summary.json")) as file:
            return history, json.load(file)

    def gyrate(self, name, overrides, *options):
        return self.run_scene(name, "gyratory", "gyratory_sma11_150C.toml", SMALL + overrides,
                              *options)

    def test_the_head_loses_its_angle_as_its_stiffness_says(self):
        # Static answer of the full FE head to the recorded moment and force: the run's modes swing
        # with scaled inertia, which may cost 5 % of the angle lost.
        history, summary = self.gyrate("run", STEEL)
        angle = np.radians(history["commanded_angle"])
        # A row's means belong to the middle of its interval, half of 10 ms before its end.
        phase = 2 * np.pi * (history["gyration"] - 0.5 * 0.01 * 0.5)
        # Forces in the tilted frame of the head: the axial force bends the shaft too.
        force_x = history["head_lateral_x"] - history["head_force"] * angle * np.cos(phase)
        force_y = history["head_lateral_y"] - history["head_force"] * angle * np.sin(phase)
        per_moment = summary["head_tilt_per_moment_rad_per_Nm"]
        per_force = summary["head_tilt_per_force_rad_per_N"]
        about_x = per_moment * history["head_moment_x"] - per_force * force_y
        about_y = per_moment * history["head_moment_y"] + per_force * force_x
        expected = angle - np.hypot(-angle * np.sin(phase) + about_x, angle * np.cos(phase) + about_y)
        lost = angle - np.radians(history["internal_angle"])
        last = history["gyration"] > 1
        rms = lambda values: np.sqrt(np.mean(values[last] ** 2))
        self.assertGreater(rms(lost), 1e-5)
        self.assertLess(rms(lost - expected), 0.05 * rms(expected))

    def test_the_head_force_balances_ram_and_weight(self):
        # Newton's second law over a gyration in which the head hardly moves: 1 % as promised.
        history, summary = self.gyrate("run", RIGID)
        section = np.pi / 4 * summary["mould_diameter_m"] ** 2
        last = history["gyration"] > 1
        pressure = np.mean(history["ram_pressure"][last])
        self.assertAlmostEqual(pressure, 600e3, delta=6e3)
        ram = pressure * section + summary["head_weight_N"]
        self.assertAlmostEqual(np.mean(history["head_force"][last]), ram, delta=0.01 * ram)
        self.assertLess(history["air_voids"][-1], history["air_voids"][np.argmax(last)])

    def test_rigid_walls_keep_the_commanded_angle(self):
        # Geometry: nothing between ram root and plate face can bend; 1e-9 is rounding.
        history, _ = self.gyrate("run", RIGID)
        difference = history["internal_angle"] - history["commanded_angle"]
        self.assertLess(np.max(np.abs(difference)), 1e-9)

    def test_threads_and_pictures_do_not_change_a_bit(self):
        # The names differ in length, so that the two runs' memory is laid out differently, too.
        short = ["gyration.ramp=0.2 s", "gyration.count=0.05"]
        for name, steel in (("rigid", RIGID), ("steel", STEEL)):
            one, _ = self.gyrate(name, steel + short + ["output.picture_interval=0 s"],
                                 "--threads", "1")
            two, _ = self.gyrate(name + "_with_more_pictures",
                                 steel + short + ["output.picture_interval=0.03 s"],
                                 "--threads", "2")
            for key in one:
                self.assertEqual(one[key].tobytes(), two[key].tobytes(), key)

    def test_the_uplift_first_falls_then_rises(self):
        # Olsson, Jelagin, Partl, section 3.2: compression first, then an uplift.
        history, _ = self.run_scene("flow", "flow_test", "flow_sma11_150C.toml", [])
        uplift = history["uplift"]
        lowest = np.argmin(uplift)
        self.assertLess(uplift[lowest], -1e-4)
        self.assertGreater(uplift[-1], 0)
        self.assertLess(history["displacement"][lowest], 0.6 * history["displacement"][-1])
        self.assertGreater(history["force"][-1], 0)

    def test_mistakes_end_with_status_2_and_nothing_written(self):
        folder = os.path.join(self.place.name, "never")
        for program, scene, override in (
                ("gyratory", "gyratory_sma11_150C.toml", "gyration.pressure=600 mm"),
                ("gyratory", "gyratory_sma11_150C.toml", "stones.count=5000"),
                ("gyratory", "gyratory_sma11_150C.toml", "gyration.presure=1"),
                ("gyratory", "missing.toml", "run.seed=2"),
                ("flow_test", "flow_sma11_150C.toml", "stones.count=5")):
            done = subprocess.run(command(program, scene, folder, [override]), capture_output=True,
                                  text=True)
            self.assertEqual(done.returncode, 2, override)
            self.assertIn("expected", done.stderr)
            self.assertFalse(os.path.exists(folder))

    def test_a_crushed_bed_stops_with_status_3_naming_the_stone(self):
        folder = os.path.join(self.place.name, "crushed")
        scene = SMALL + RIGID + ["gyration.pressure=10 MPa", "numerics.largest_overlap=1e-3"]
        done = subprocess.run(command("gyratory", "gyratory_sma11_150C.toml", folder, scene),
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, r"stopped: stone \d+, time .* s: stone overlap")

    def test_a_run_is_not_written_over(self):
        folder = os.path.join(self.place.name, "kept")
        line = command("flow_test", "flow_sma11_150C.toml", folder,
                       ["flow.displacement=0.1 mm"])
        subprocess.run(line, check=True)
        again = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(again.returncode, 4)
        self.assertIn("results.h5", again.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "Runs.test_" + sys.argv[3]])
