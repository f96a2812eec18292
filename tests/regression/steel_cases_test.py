#!/usr/bin/python3
"""The steel under loads of its own: steel_cases_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME"""
import json
import math
import os
import subprocess

from small_runs import BIN, SCENES, SmallRuns, run_named_test


class SteelCases(SmallRuns):
    def load_steel(self, case, *overrides):
        line = [os.path.join(BIN, "wall_stress"), os.path.join(SCENES, "walls", case + ".toml"),
                "--json"]
        for override in overrides:
            line += ["--set", override]
        return subprocess.run(line, capture_output=True, text=True)

    def test_the_described_case_of_the_steel_is_one_of_theirs(self):
        # As it stands, what the program says of a case is Lame's cylinder; every key is in it.
        line = [os.path.join(BIN, "wall_stress"), "--describe"]
        told = subprocess.run(line, check=True, capture_output=True, text=True).stdout
        for key in ("kind", "inner_diameter", "shaft_length", "harmonic", "refinement", "modes"):
            self.assertRegex(told, rf"(?m)^{key} = ")
        case = self.folder("case.toml")
        with open(case, "w") as file:
            file.write(told)
        done = subprocess.run([os.path.join(BIN, "wall_stress"), case, "--json"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(json.loads(done.stdout)["rows"]), 3)

    def test_a_case_of_the_steel_that_cannot_be_is_refused(self):
        for case, override, words in (
                ("point", "load.eccentricity=75 mm", r"load\.eccentricity a point on the plate"),
                ("ovalling", "mould.height=115 mm", r"mould\.height .*plane strain.* 119 mm"),
                ("one_stone", "stones.modes=100000", r"stones\.modes: .*fewer .*found 100000"),
                ("column", "stones.modes=100000", r"stones\.modes: .*fewer .*found 100000")):
            done = self.load_steel(case, override)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, words)

    def test_a_case_with_stones_has_no_finer_mesh_to_be_held_against(self):
        line = [os.path.join(BIN, "wall_stress"), os.path.join(SCENES, "walls", "one_stone.toml"),
                "--refined"]
        done = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("--refined: expected a case without stones", done.stderr)

    def test_below_a_point_every_mesh_is_asked_at_the_same_depths(self):
        # Boussinesq from 5 to 10 mm, a fifth of the shaft's radius and twice that; nodes of the
        # mesh lie at 5.35 and 10.75 mm. 1e-6: what the row is told with.
        done = self.load_steel("point", "head.plate_thickness=40 mm")
        row = json.loads(done.stdout)["rows"][-1]
        self.assertEqual(row["quantity"], "shortening_below_point")
        self.assertTrue(row["pass"], row)
        force, young, nu = 1000, 210e9, 0.3
        exact = force * (1 + nu) * (3 - 2 * nu) / (2 * math.pi * young) * (1 / 5e-3 - 1 / 10e-3)
        self.assertAlmostEqual(row["reference"], exact, delta=1e-6 * exact)

    def test_a_mould_of_the_least_height_is_in_plane_strain(self):
        # 2 %, as of a tall one: of a mould as low as it may be, free ends take 1.4 %.
        for wall, height in ((2, 61), (7.5, 119), (30, 254)):
            done = self.load_steel("ovalling", f"mould.wall_thickness={wall} mm",
                                   f"mould.height={height} mm")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_column_without_wall_friction_is_in_balance(self):
        # What should be nothing is, but for rounding, nothing against the wall's push.
        done = self.load_steel("column", "stones.count=60", "stones.wall_friction=0")
        rows = {row["quantity"]: row for row in json.loads(done.stdout)["rows"]}
        for quantity in ("traction_resultant", "fe_reaction"):
            self.assertTrue(rows[quantity]["pass"], rows[quantity])

    def test_a_thin_wall_comes_to_rest_under_its_stone(self):
        # Its slowest mode swings at 7 Hz, damped by 15 %: 1.3 s to 1e-4, the stone takes 0.5 s.
        done = self.load_steel("one_stone", "mould.wall_thickness=2 mm")
        approach = json.loads(done.stdout)["rows"][0]
        self.assertEqual(approach["quantity"], "approach")
        self.assertTrue(approach["pass"], approach)


if __name__ == "__main__":
    run_named_test(SteelCases)
