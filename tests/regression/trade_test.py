#!/usr/bin/python3
"""Studies by the program trade: trade_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME"""
import os
import shutil
import signal
import subprocess
import time

import h5py
from small_runs import BIN, SCENES, SmallRuns, run_named_test, run_script

STUDY = """[study]
program = "flow_test"
scene = "{scenes}/flow_sma11_150C.toml"
seeds = [1, 2]
reference = "fine"
[base]
stones.count = 130
stones.fracture = "none"
flow.length = "40 mm"
flow.width = "34 mm"
flow.strip_length = "16 mm"
flow.displacement = "0.2 mm"
output.picture_interval = "0 s"
[[setting]]
name = "fine"
[[setting]]
name = "the same"
numerics.safety = 0.2
"""


class Trade(SmallRuns):
    def setUp(self):
        super().setUp()
        self.out = self.folder("out")

    def command(self, text, *options):
        study = self.folder("study.toml")
        with open(study, "w") as file:
            file.write(text.format(scenes=SCENES))
        return [os.path.join(BIN, "trade"), study, "--out", self.out, "--quiet", *options]

    def study(self, text, *options):
        return subprocess.run(self.command(text, *options), capture_output=True, text=True)

    def runs(self):
        """When each run's summary was written."""
        found = {}
        for folder, _, files in os.walk(self.out):
            if "summary.json" in files:
                found[folder] = os.stat(os.path.join(folder, "summary.json")).st_mtime_ns
        return found

    def test_a_setting_differs_in_nothing_from_itself(self):
        answer = self.study(STUDY, "--tolerance", "1%")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("cheapest that shows no error above 1.0 %", answer.stdout)
        # No stone breaks in two runs: up to 3 / 2 a run are not told from none.
        self.assertEqual(answer.stdout.count("| none in 2 runs |"), 2)
        self.assertIn("\n  fractured stones: none in 2 runs, there may be 1.5 in one", answer.stdout)
        with h5py.File(os.path.join(self.out, "study.h5")) as file:
            same = file["settings/the_same"]
            self.assertEqual(len(same["seconds"]), 2)
            self.assertGreater(min(same["seconds"]), 0)
            for quantity in ("pressure_curve", "pressure_peak", "uplift_end", "coordination"):
                self.assertEqual(same[quantity]["error"][0], 0)
                self.assertEqual(same[quantity]["noise"][0], 0)
                self.assertGreater(file["settings/fine"][quantity]["noise"][0], 0)
        # Called again it runs what is new only, and a changed setting; another build's run it tells.
        before = self.runs()
        with open(os.path.join(self.out, "runs/fine/seed_1.build"), "w") as file:
            file.write("another")
        again = self.study(STUDY.replace("safety = 0.2", "safety = 0.15"))
        self.assertEqual(again.returncode, 0, again.stderr)
        changed = [run for run, at in self.runs().items() if before[run] != at]
        self.assertEqual(len(changed), 2)
        self.assertTrue(all("the_same" in run for run in changed))
        self.assertIn("\n1 of the runs are of another build of the program.\n", again.stdout)

    def test_a_tolerance_is_a_share_or_has_a_percent_sign(self):
        for wrong in ("10", "1", "1e9", "inf", "inf%", "nan", "0", "-1%", "1 percent"):
            answer = self.study(STUDY, "--check", f"--tolerance={wrong}")
            self.assertEqual(answer.returncode, 2, wrong)
            self.assertIn(f'found "{wrong}"; write ', answer.stderr)
        self.assertIn("write 10%", self.study(STUDY, "--check", "--tolerance=10").stderr)
        for right in ("0.1", "10%", "150 %"):
            answer = self.study(STUDY, "--check", f"--tolerance={right}")
            self.assertEqual(answer.returncode, 0, answer.stderr)

    def test_check_says_what_the_runs_will_be(self):
        line = self.command(STUDY, "--check")
        line.remove("--quiet")
        answer = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        told = r": steps about \d.*, time to take about \d.*\n"
        self.assertRegex(answer.stdout, f"^2 settings, 2 seeds: 4 runs\nfine{told}the same{told}$")
        self.assertEqual(self.runs(), {})
        self.assertEqual(self.study(STUDY, "--check").stdout, "")

    def test_a_stopped_study_goes_on(self):
        process = subprocess.Popen(self.command(STUDY), stderr=subprocess.PIPE, text=True)
        scene = os.path.join(self.out, "runs/fine/seed_1/scene.toml")
        while not os.path.exists(scene):
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        words = process.communicate()[1]
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, words)
        self.assertLess(len(self.runs()), 4)
        self.assertEqual(self.study(STUDY).returncode, 0)
        self.assertEqual(len(self.runs()), 4)

    def test_a_scene_that_is_refused_ends_the_study_before_it_runs(self):
        answer = self.study(STUDY.replace("safety = 0.2", "safety = 7"))
        self.assertEqual(answer.returncode, 2)
        self.assertIn("numerics.safety", answer.stderr)
        self.assertEqual(len(answer.stderr.splitlines()), 1)
        self.assertEqual(self.runs(), {})
        self.assertRegex(answer.stderr, r"study.toml:18:10: expected .* \(setting the same\)\n$")
        every = self.study(STUDY.replace("stones.count", "stones.cuont"))
        self.assertRegex(every.stderr, r"^\S*study.toml:7:8: expected a known key, .*count\"\?\n$")
        option = self.study(STUDY, "--set", "setting[1].numerics.savety=0.1")
        self.assertRegex(option.stderr, r"^--set setting\[1\].numerics.savety: expected a known key")

    def test_a_run_in_numerical_trouble_is_told(self):
        crushed = STUDY.replace(
            "safety = 0.2", 'largest_overlap = 1e-9\nbinder = "none"\nstones.count = 300')
        builds = [os.path.join(self.out, f"runs/the_same/seed_{seed}.build") for seed in (1, 2)]
        for _ in range(2):
            answer = self.study(crushed)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertRegex(answer.stdout, r"\| the same \| stopped: stone \d+, time .* overlap")
            # What another build stopped is run anew.
            for build in builds:
                with open(build) as file:
                    self.assertNotEqual(file.read(), "another")
                with open(build, "w") as file:
                    file.write("another")

    def test_a_study_without_a_result_ends_with_status_3(self):
        crushed = STUDY.replace('name = "fine"', 'name = "fine"\nnumerics.largest_overlap = 1e-9')
        crushed = crushed.replace("safety = 0.2", "largest_overlap = 1e-9").replace(
            "stones.count = 130", 'stones.count = 300\nbinder = "none"')
        self.assertEqual(self.study(crushed).returncode, 3)

    def test_a_folder_is_that_of_one_study(self):
        self.assertEqual(self.study(STUDY).returncode, 0)
        before = self.runs()
        other = self.folder("other.toml")
        shutil.copy(self.folder("study.toml"), other)
        line = self.command(STUDY)
        line[1] = other
        answer = subprocess.run(line, capture_output=True, text=True)
        self.assertEqual(answer.returncode, 4)
        self.assertIn("expected a folder without another study, found that of study.toml",
                      answer.stderr)
        self.assertEqual(self.runs(), before)

    def test_a_run_that_refuses_its_scene_on_the_way_is_told(self):
        # The mould holds the specimen, not the loose bed: seen when the head comes down.
        study = os.path.join(SCENES, "studies", "gyratory_small.toml")
        with open(study) as file:
            text = file.read().replace("../", SCENES + "/")
        low = text.split("[[setting]]")[0] + """[[setting]]
name = "reference"
gyration.count = 0.01
[[setting]]
name = "low"
mould.elastic.height = "46 mm"
"""
        answer = self.study(low)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stdout, r"\| low \| .* expected a mould as high as the settled bed")

    def test_the_small_study_tells_what_speed_costs(self):
        # The energy ledger watches from outside: its setting errs as the standard does, bit by bit.
        study = os.path.join(SCENES, "studies", "gyratory_small.toml")
        answer = subprocess.run([os.path.join(BIN, "trade"), study, "--out", self.out, "--quiet"],
                                capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with h5py.File(os.path.join(self.out, "study.h5")) as file:
            ledger, standard = file["settings/energy_ledger"], file["settings/standard"]
            for quantity, found in standard.items():
                if isinstance(found, h5py.Group):
                    for name, value in found.items():
                        self.assertTrue((ledger[quantity][name][:] == value[:]).all(), quantity)
            self.assertGreater(min(ledger["seconds"]), max(standard["seconds"]))
            self.assertGreater(min(file["settings/reference/seconds"]), max(standard["seconds"]))
        self.assertEqual(run_script("plot_trade.py", self.out).returncode, 0)
        self.assertTrue(os.path.exists(os.path.join(self.out, "trade.svg")))


if __name__ == "__main__":
    run_named_test(Trade)
