#!/usr/bin/python3
"""What the programs refuse, and how they say it: refusals_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME"""
import json
import os
import shutil
import subprocess

from small_runs import (BIN, FLOW, RIGID, SCENE_OF, SCENES, SMALL, SmallRuns, command,
                        run_named_test)


class Refusals(SmallRuns):
    def contents(self, folder):
        found = {}
        for name in os.listdir(folder):
            with open(os.path.join(folder, name), "rb") as file:
                found[name] = file.read()
        return found

    def test_mistakes_end_with_status_2_and_nothing_written(self):
        folder = self.folder("never")
        for program, scene, override in (
                ("gyratory", None, "gyration.pressure=600 mm"),
                ("gyratory", None, "stones.count=5000"),
                ("gyratory", None, "gyration.presure=1"),
                ("gyratory", "missing.toml", "run.seed=2"),
                ("flow_test", None, "stones.count=5")):
            done = subprocess.run(command(program, folder, [override], scene=scene),
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, override)
            self.assertIn("expected", done.stderr)
            self.assertFalse(os.path.exists(folder))
        cases = []
        for part in ("one", "other"):  # whose pictures would have the same names
            os.makedirs(self.folder(part))
            cases.append(shutil.copy(os.path.join(SCENES, "walls", "point.toml"),
                                     self.folder(part)))
        done = subprocess.run([os.path.join(BIN, "wall_stress"), *cases, "--out", folder],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r"other/point\.toml: expected a case of another name")
        self.assertFalse(os.path.exists(folder))

    def test_check_reports_eight_mistakes_in_eight_lines(self):
        # Where each mistake stands: line and column of the value, or of a key that is itself wrong.
        with open(self.folder("sieves.csv"), "w") as file:
            file.write("sieve_mm,passing_percent\n2,25\n8,57\n16,100\n")
        scene = self.folder("scene.toml")
        with open(scene, "w") as file:
            file.write("""[stones]
count = 450.5
gradation = "sieves.csv"
yuong = "74 GPa"
poisson = 0.5
[binder]
content = "6.6 %"
temperature = "130 degC"
[mould]
diameter = "50 kg"
[gyration]
pressure = 600 kPa
speed = "0.5 revs/s"
[head.elastik]
modes = 20
""")
        done = subprocess.run([os.path.join(BIN, "gyratory"), scene, "--check"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        expected = [("2:9", "whole number"), ("4:1", "\"stones.young\"?"), ("5:11", "below 0.5"),
                    ("8:15", "110 degC or 150 degC"), ("10:12", "50 kg"), ("12:12", "quotes"),
                    ("13:9", "unknown unit"), ("14:1", "\"head.elastic\"?")]
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), len(expected), done.stderr)
        for line, (place, words) in zip(lines, expected):
            self.assertTrue(line.startswith(f"{scene}:{place}: expected "), line)
            self.assertIn(words, line)

    def test_the_described_scene_and_the_schema_are_those_of_the_reader(self):
        for program in ("gyratory", "flow_test"):
            ask = lambda option: subprocess.run([os.path.join(BIN, program), option], check=True,
                                                capture_output=True, text=True).stdout
            scene = self.folder(program + ".toml")
            with open(scene, "w") as file:
                file.write(ask("--describe"))
            for name in os.listdir(os.path.join(SCENES, "gradations")):
                os.makedirs(self.folder("gradations"), exist_ok=True)
                shutil.copy(os.path.join(SCENES, "gradations", name),
                            self.folder("gradations"))
            done = subprocess.run([os.path.join(BIN, program), scene, "--check", "--quiet"],
                                  capture_output=True, text=True)
            self.assertNotIn("known", done.stderr)  # its sizes need not fit each other
            self.assertIn("stones", json.loads(ask("--schema"))["properties"])

    def test_a_bed_that_stands_out_of_its_elastic_mould_is_refused(self):
        # Lower than the specimen will be: at once; lower than the loose bed: when the head comes.
        for height, words, seen in (("15 mm", "specimen", False), ("34 mm", "settled bed", True)):
            folder = self.folder(height)
            line = command("gyratory", folder, SMALL + [f"mould.elastic.height={height}"])
            done = subprocess.run(line, capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, rf"elastic\.height: expected .*{words}.*found {height}")
            self.assertEqual(os.path.exists(os.path.join(folder, "results.h5")), seen)

    def test_elastic_steel_needs_the_program_that_knows_it(self):
        alone = shutil.copy(os.path.join(BIN, "gyratory"), self.folder("gyratory"))
        line = [alone] + command("gyratory", self.folder("never"), SMALL)[1:]
        done = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, r":\d+:\d+: expected rigid steel, .* found elastic")
        for key in RIGID:
            line += ["--set", key]
        self.assertEqual(subprocess.run(line + ["--check"], capture_output=True).returncode, 0)
        loaded = subprocess.run(["ldd", alone], capture_output=True, text=True, check=True).stdout
        self.assertNotRegex(loaded, "deal_II|trilinos|libmpi")

    def test_what_is_read_is_not_written_over(self):
        mix = shutil.copytree(os.path.join(SCENES, "paths"), self.folder("mix"))
        shutil.copy(os.path.join(SCENES, SCENE_OF["flow_test"]), os.path.join(mix, "scene.toml"))
        for name, text in (("of_pair.toml", 'include = "pair.toml"\n'),
                           ("of_scene.toml", 'include = "scene.toml"\n'),
                           ("of_table.toml", '[stones]\ngradation = "gradation.csv"\n'),
                           ("gradation.csv", "sieve_mm,passing_percent\n2,25\n16,100\n"),
                           ("bed.csv", "0,0,0.01,0.01\n")):
            with open(os.path.join(mix, name), "w") as file:
                file.write(text)
        before = self.contents(mix)
        place = lambda name: os.path.join(mix, name)
        bed = ["--law", "dry", "--steps", "1", "--radius", "0.05", "--bed", place("bed.csv")]
        for words, out in (
                (["contact_path", place("pair.toml")], place("pair.toml")),
                (["contact_path", place("pair.toml")], place("press_hold_pull.csv")),
                (["contact_path", place("of_pair.toml")], place("pair.toml")),
                (["dem_speed", *bed], place("bed.csv")),
                (["flow_test", place("scene.toml"), "--overwrite"], mix),
                (["flow_test", place("of_scene.toml"), "--overwrite"], mix),
                (["flow_test", place("of_table.toml"), "--overwrite"], mix)):
            line = [os.path.join(BIN, words[0]), *words[1:], "--out", out]
            done = subprocess.run(line, capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, "^--out: expected a.*\n$")
            self.assertEqual(self.contents(mix), before)
            if words[0] != "dem_speed":
                check = subprocess.run(line + ["--check"], capture_output=True, text=True)
                self.assertNotIn("--out", check.stderr)  # writes nothing

    def test_steel_that_cannot_be_is_refused(self):
        gauge = 'output.gauge=[{angle="0 deg", height="12 mm", length="50 mm"}]'
        for key, words in (
                ("head.elastic.shaft_diameter=35.99 mm", r"shaft_diameter: .*thinner than the plate"),
                ("head.elastic.modes=100000", r"modes: expected fewer .*found 100000; take fewer"),
                (gauge, r"gauge: expected a gauge of at most 20\.03 mm.*found 50 mm")):
            line = command("gyratory", self.folder("refused"), SMALL + [key])
            line.remove("--quiet")  # which leaves out what the steel will cost
            done = subprocess.run(line + ["--check"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, words)

    def test_a_crushed_bed_stops_with_status_3_naming_the_stone(self):
        folder = self.folder("crushed")
        scene = SMALL + RIGID + ["gyration.pressure=10 MPa", "numerics.largest_overlap=1e-3"]
        done = subprocess.run(command("gyratory", folder, scene), capture_output=True, text=True)
        self.assertEqual(done.returncode, 3)
        self.assertRegex(done.stderr, r"stopped: stone \d+, time .* s: stone overlap")

    def test_a_run_is_not_written_over(self):
        folder = self.folder("kept")
        line = command("flow_test", folder, FLOW)
        subprocess.run(line, check=True)
        again = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(again.returncode, 4)
        self.assertIn("expected a folder without a run, found one", again.stderr)
        # Its scene is run again elsewhere, but not where it would replace somebody's files.
        stored = os.path.join(folder, "scene.toml")
        subprocess.run(command("flow_test", self.folder("again"), [], scene=stored), check=True)
        for name in ("scene.toml", "gradation.csv"):
            others = self.folder("with_" + name)
            os.makedirs(others)
            with open(os.path.join(others, name), "w") as file:
                file.write("somebody's")
            for options in ([], ["--overwrite"]):
                done = subprocess.run(command("flow_test", others, [], *options, scene=stored),
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn(f"without a {name} that is not of a run, found one", done.stderr)
                self.assertEqual(self.contents(others)[name], b"somebody's")


if __name__ == "__main__":
    run_named_test(Refusals)
