#!/usr/bin/python3
"""Whole runs of the programs: runs_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

Each test is one run or two of a bed small enough to take seconds."""
import json
import os
import re
import subprocess
import sys

import h5py
import numpy as np
from small_runs import FLOW, RIGID, SMALL, SmallRuns, command, run_named_test, run_script

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import static_head

STEEL = ["head.elastic.shaft_diameter=14 mm", "mould.elastic.modes=20"]


class Runs(SmallRuns):
    def run_scene(self, name, program, overrides, *options):
        folder = self.folder(name)
        subprocess.run(command(program, folder, overrides, *options), check=True)
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            history = {key: values[:] for key, values in file["history"].items()}
        with open(os.path.join(folder, "summary.json")) as file:
            return history, json.load(file)

    def gyrate(self, name, overrides, *options):
        return self.run_scene(name, "gyratory", SMALL + overrides, *options)

    def test_the_head_loses_its_angle_as_its_stiffness_says(self):
        # Static answer of the full FE head to the recorded moment and force: the run's modes swing
        # with scaled inertia, which may cost 5 % of the angle lost.
        history, summary = self.gyrate("run", STEEL)
        expected = static_head.angle_lost(history, summary)
        lost = np.radians(history["commanded_angle"] - history["internal_angle"])
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

    def test_the_energy_ledger_closes_and_changes_nothing(self):
        # Closed below 0.1 % of the work done, settling and over a gyration in elastic steel.
        tiny = STEEL + ["stones.count=60", "mould.diameter=33 mm", "gyration.ramp=0.2 s",
                        "gyration.speed=2 rev/s", "gyration.count=1", "fill.rest_energy=0.1"]
        plain, _ = self.gyrate("plain", tiny)
        booked = self.gyrate("booked", tiny + ["output.energy_ledger=true"])
        self.assertFalse([key for key in plain if key.startswith("energy_")])
        for key in plain:
            self.assertEqual(plain[key].tobytes(), booked[0][key].tobytes(), key)
        self.expect_closed(*booked)
        self.expect_closed(*self.gyrate("rings", tiny + ["output.energy_ledger=true",
                                                         "binder.film=rings"]))

    def expect_closed(self, booked, summary):
        self.assertLess(abs(summary["settling_energy_residual_share"]), 1e-3)
        gyrating = booked["gyration"] > 0
        self.assertGreater(booked["energy_work_of_walls"][-1], 0.1)
        self.assertLess(np.max(np.abs(booked["energy_residual_share"][gyrating])), 1e-3)
        # The columns are the whole balance: 1e-9 is rounding.
        known = sum(booked["energy_" + kind] for kind in (
            "kinetic", "stone_elastic", "binder_stored", "binder_dissipated", "friction",
            "stone_area_change", "film_area_change", "damping", "bond_breaking", "fracture",
            "residual"))
        work = booked["energy_work_of_walls"] + booked["energy_work_of_gravity"]
        np.testing.assert_allclose(known - known[0], work - work[0], atol=1e-9 * work[-1])

    def mould_map(self, folder):
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            return {key: values[:] for key, values in file["walls/mould"].items()}

    def test_maps_of_a_rigid_mould_hold_what_the_mix_presses(self):
        # Resultants of the map against the history: axially to a tenth of a row of the fifty, which
        # are not quite as long as another, radially less what the chords of 24 sectors take, 1 - cos(pi / 24).
        tiny = RIGID + ["stones.count=60", "mould.diameter=33 mm", "gyration.ramp=0.2 s",
                        "gyration.speed=2 rev/s", "gyration.count=1", "fill.rest_energy=0.1",
                        "output.gauge=none"]
        plain, _ = self.gyrate("plain", tiny)
        mapped, summary = self.gyrate("mapped", tiny + ["output.maps=true"])
        for key in plain:
            self.assertEqual(plain[key].tobytes(), mapped[key].tobytes(), key)
        folder = self.folder("mapped")
        wall = self.mould_map(folder)
        # The same steps, whatever the rows: not those of ramp and dwell.
        self.gyrate("mapped_by_turns", tiny + ["output.maps=true", "output.history_interval=0.5 s"])
        for key, values in self.mould_map(self.folder("mapped_by_turns")).items():
            self.assertEqual(values.tobytes(), wall[key].tobytes(), key)
        self.assertEqual(set(wall["gyration"]), {1})
        self.assertNotIn("hoop_stress", wall)  # there is no steel to be stressed
        levels = np.unique(wall["height"])
        cell = np.pi * summary["mould_diameter_m"] / 24 * (levels[1] - levels[0])
        ends = (wall["height"] == levels[0]) | (wall["height"] == levels[-1])
        area = np.where(ends, cell / 2, cell)
        gyrating = mapped["gyration"] > 1e-3  # behind the row at whose end the gyrations begin
        axial = np.sum(wall["axial_traction"] * area)
        expected = np.mean(mapped["mould_axial_force"][gyrating])
        self.assertGreater(abs(expected), 1)
        self.assertAlmostEqual(axial, expected, delta=2e-3 * abs(expected))
        push = np.sum(wall["normal_traction"] * area)
        pressed = np.mean(mapped["mould_force"][gyrating])
        self.assertAlmostEqual(push, pressed, delta=0.02 * pressed)
        self.assertEqual(run_script("stress_maps.py", folder).returncode, 0)
        self.assertTrue(os.path.exists(os.path.join(folder, "mould_map.png")))

    def test_the_uplift_first_falls_then_rises(self):
        # Olsson, Jelagin, Partl, section 3.2: compression first, then an uplift.
        history, _ = self.run_scene("flow", "flow_test", [])
        uplift = history["uplift"]
        lowest = np.argmin(uplift)
        self.assertLess(uplift[lowest], -1e-4)
        self.assertGreater(uplift[-1], 0)
        self.assertLess(history["displacement"][lowest], 0.6 * history["displacement"][-1])
        self.assertGreater(history["force"][-1], 0)

    def test_selective_mass_leaves_the_filling_as_it_is(self):
        # Weight would sort stones whose scales differ while they fall.
        uniform, whole = self.run_scene("uniform", "flow_test", FLOW)
        selective, less = self.run_scene("selective", "flow_test",
                                         FLOW + ["numerics.selective_mass=true"])
        self.assertEqual(whole["bed_height_m"], less["bed_height_m"])
        self.assertNotEqual(uniform["pressure"].tobytes(), selective["pressure"].tobytes())

    def test_rows_closer_than_steps_are_left_out(self):
        # By definition: a row tells of the steps since the one before, of which there must be one.
        often = ["output.history_interval=1e-30 s"]
        flow = FLOW + ["flow.displacement=0.02 mm"]
        gyration = RIGID + SMALL + ["gyration.ramp=0.005 s", "gyration.dwell=0 s",
                                    "gyration.count=0.015"]
        for program, overrides in (("flow_test", flow), ("gyratory", gyration)):
            history, _ = self.run_scene(program, program, overrides + often)
            self.assertGreater(len(history["time"]), 100)
            self.assertGreater(np.min(np.diff(history["time"])), 0)

    def test_check_says_what_the_run_will_be(self):
        # The estimate of the steps against the run itself: a factor of three is promised.
        scene = SMALL + RIGID + ["gyration.count=0.5"]
        line = command("gyratory", "unused", scene, "--check")
        told = subprocess.run([word for word in line if word != "--quiet"], check=True,
                              capture_output=True, text=True).stdout
        steps = float(re.search(r"steps +about (\S+)", told).group(1))
        summary = self.gyrate("run", RIGID + ["gyration.count=0.5"])[1]
        taken = summary["steps"]
        self.assertLess(steps, 3 * taken)
        self.assertGreater(steps, taken / 3)
        self.assertRegex(told, r"inertial number +\S+ \(high from 4e-04 on\)")
        self.assertIn("warning: the mould is small for the largest stone", told)
        found, asked, sieve = (summary["gradation_" + name]
                               for name in ("passing", "passing_asked", "sieve_m"))
        self.assertIn(f"{100 * found:.1f} % instead of {100 * asked:.1f} % pass {1e3 * sieve:g} mm",
                      told)
        line = command("flow_test", "unused", [], "--check")
        told = subprocess.run([word for word in line if word != "--quiet"], check=True,
                              capture_output=True, text=True).stdout
        self.assertIn("warning: the box is small for the largest stone", told)
        self.assertFalse(os.path.exists("unused"))

    def test_check_warns_of_steel_too_slow_for_the_gyrations(self):
        # A head of 1e8 Pa is 2100 times softer than steel: gain 2.5e5. Quick steel gets no warning.
        for override, warning in (
                ("head.elastic.young=210 GPa", None),
                ("head.elastic.young=0.1 GPa", "the head is soft, it would bend"),
                ("numerics.head_mass_scale=1e7", "lets the head swing at")):
            line = command("gyratory", "unused", SMALL + [
                "head.elastic.shaft_diameter=14 mm", "mould.elastic=none", override], "--check")
            told = subprocess.run([word for word in line if word != "--quiet"], check=True,
                                  capture_output=True, text=True).stdout
            self.assertIn("modes swing", told)
            warnings = re.findall(r"warning: .*head .*", told)
            if warning:
                self.assertIn(warning, " ".join(warnings))
            else:
                self.assertEqual(warnings, [])

    def test_what_is_told_of_the_gyrations_begins_with_them_however_long_a_row_is(self):
        # Means of forces are those of the same steps, but for their last bits.
        found = []
        for interval in ("0.01 s", "0.7 s"):
            _, summary = self.gyrate(interval.split()[0], RIGID + [
                "gyration.count=0.2", f"output.history_interval={interval}"])
            found.append(summary)
        fine, coarse = found
        self.assertEqual(fine["air_voids_start"], coarse["air_voids_start"])
        for mean in ("ram_pressure_mean_Pa", "head_force_mean_N"):
            self.assertAlmostEqual(fine[mean], coarse[mean], delta=1e-9 * fine[mean])

    def test_bonds_without_energy_are_none(self):
        for energy, some in (("0 J/mm2", False), ("0.01 J/mm2", True)):
            columns, _ = self.gyrate(energy.split()[0], RIGID + [f"binder.bond_energy={energy}"])
            self.assertEqual(bool(max(columns["bonds"]) > 0), some)


if __name__ == "__main__":
    run_named_test(Runs)
