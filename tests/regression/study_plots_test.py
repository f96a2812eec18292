#!/usr/bin/python3
"""What is drawn and said of a study, from made-up runs: study_plots_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME"""
import itertools
import json
import os
import shutil
import sys

import h5py
import numpy
from small_runs import SCENES, SmallRuns, run_named_test, run_script


class StudyPlots(SmallRuns):
    def setUp(self):
        super().setUp()
        self.out = self.folder("out")

    def test_the_slope_of_a_straight_line_is_found(self):
        # By construction: 3 and 5 per cent per decade, after gyrations that count for nothing.
        for seed, slope in (1, 0.03), (2, 0.05):
            gyration = numpy.linspace(-1, 20, 400)
            line = slope * numpy.log10(numpy.maximum(gyration, 1e-9))
            self.write_run("out", "a_mix", seed, {
                "gyration": gyration, "air_voids": numpy.where(gyration < 5, 0.3, 0.25 - line)})
        # One that has not come to its end does not count.
        self.write_run("out", "a_mix", 12, {"gyration": numpy.linspace(0, 6, 100),
                                            "air_voids": numpy.full(100, 0.3)})
        os.remove(os.path.join(self.out, "runs", "a_mix", "seed_12", "summary.json"))
        answer = run_script("plot_densification.py", self.out, "--from", "5")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stdout, r"\| a mix \| 2 \| 4.00 \| 1.00 \|.*\| 30.0 \| 19.8 \|")
        self.assertTrue(os.path.exists(os.path.join(self.out, "densification.svg")))
        # Nor does one of a setting that the study has no longer.
        with h5py.File(os.path.join(self.out, "study.h5"), "w") as file:
            file["settings/another/seeds"] = [1]
        os.renames(os.path.join(self.out, "runs", "a_mix", "seed_1"),
                   os.path.join(self.out, "runs", "another", "seed_1"))
        answer = run_script("plot_densification.py", self.out, "--from", "5")
        self.assertNotIn("| a mix |", answer.stdout)
        self.assertIn("| another | 1 | 3.00 | nan |", answer.stdout)
        self.assertIn("runs/a_mix: left out, no setting of study.h5, which trade writes when all",
                      answer.stderr)
        self.write_run("flow", "a_mix", 1, {"displacement": numpy.arange(50.0)})
        for folder, words in (
                (self.folder("flow"), "a_mix/seed_1: expected a run of gyratory"),
                (self.out, "below the 20 gyrations of this run, found 20; give --from 10")):
            refused = run_script("plot_densification.py", folder, "--from", "20")
            self.assertEqual(refused.returncode, 2)
            self.assertIn(words, refused.stderr.splitlines()[-1])

    def test_the_slope_of_a_single_gyration_is_found(self):
        gyration = numpy.linspace(0, 1, 50)
        self.write_run("out", "a_mix", 1, {
            "gyration": gyration,
            "air_voids": 0.2 - 0.03 * numpy.log10(numpy.maximum(gyration, 0.1))})
        answer = run_script("plot_densification.py", self.out)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("| a mix | 1 | 3.00 | nan | 23.0 | 20.0 |", answer.stdout)

    def test_what_cannot_be_drawn_is_told_in_a_line(self):
        self.write_run("study", "a_mix", 1, {"gyration": numpy.arange(50.0),
                                             "air_voids": numpy.full(50, 0.3)})
        study = self.folder("study")
        run = os.path.join(study, "runs", "a_mix", "seed_1")
        shutil.copytree(run, self.folder("damaged"))
        with open(os.path.join(self.folder("damaged"), "results.h5"), "r+b") as file:
            file.truncate(1000)
        os.makedirs(self.folder("damaged_study"))
        with open(os.path.join(self.folder("damaged_study"), "study.h5"), "w") as file:
            file.write("no HDF5")
        os.makedirs(self.folder("begun/runs/a_mix/seed_1"))
        os.makedirs(self.folder("tables"))
        table = self.folder("tables/a.csv")
        with open(table, "w") as file:
            file.write("angle_deg,height_m\n1,2\n")
        absent, before = self.folder("absent"), self.files()
        no_such, of_run, of_study = "found no such folder", "found the folder of a run", \
            "found the folder of a study; give one of its runs"
        damaged = "damaged or another file"
        for script, *cases in (
                ("plot_run.py", (absent, no_such), (study, of_study),
                 (self.folder("damaged"), damaged)),
                ("render_run.py", (absent, no_such), (study, of_study),
                 (self.folder("damaged"), damaged)),
                ("stress_maps.py", (absent, no_such), (study, of_study),
                 (run, "found none; run it"),
                 (self.folder("tables"), "found none of its columns traction_Pa, hoop_stress_Pa")),
                ("plot_path.py", (absent, "found no such file"), (run, "found a folder"),
                 (table, "found none of its columns time_s")),
                ("plot_trade.py", (absent, no_such), (run, of_run), (study, "found none yet"),
                 (self.folder("damaged_study"), damaged)),
                ("plot_densification.py", (absent, no_such), (self.folder("damaged"), damaged),
                 (self.folder("begun"), "found none; go on by trade"),
                 (self.folder("damaged_study"), damaged)),
                ("plot_paper.py", (absent, no_such), (run, of_run),
                 (study, "expected a study of the paper's mixes"))):
            for given, words in cases:
                refused = run_script(script, given)
                self.assertEqual(refused.returncode, 2, (script, given, refused.stderr))
                self.assertRegex(refused.stderr, 
                                 r"^(\S+: left out, .*\n)?\S+: expected .*, found .*; .*\n$")
                self.assertIn(words, refused.stderr)
        self.assertEqual(self.files(), before)

    def test_tables_are_drawn(self):
        os.makedirs(self.out)
        face, path = os.path.join(self.out, "face.csv"), self.folder("path.csv")
        with open(face, "w") as file:
            file.write("angle_deg,height_m,traction_Pa,hoop_stress_Pa\n")
            for angle, height in itertools.product(range(0, 360, 90), (0, 0.1)):
                file.write(f"{angle},{height},{1e3 * angle},{1e3 * height}\n")
        with open(path, "w") as file:
            file.write("time_s,overlap_m,shear_m,force_N,binder_N,stone_N,shear_N,bonded,broken\n")
            file.writelines(f"{k},{k}e-6,0,{k},1,{k},0,{int(k < 5)},{int(k > 7)}\n" for k in range(9))
        for script, given, picture in (("stress_maps.py", self.out, "out/face.png"),
                                       ("plot_path.py", path, "path.png")):
            answer = run_script(script, given)
            self.assertEqual((answer.returncode, answer.stderr), (0, ""))
            self.assertTrue(os.path.exists(self.folder(picture)))

    def files(self):
        return sorted(os.path.join(folder, name) for folder, _, names in os.walk(self.place.name)
                      for name in names)

    def test_a_study_is_drawn_as_far_as_it_is_judged(self):
        os.makedirs(self.out)
        study = os.path.join(self.out, "study.h5")
        with h5py.File(study, "w") as file:
            file["study/seeds"] = numpy.arange(3)
            for name, seeds, seconds, error in (("whole", 3, 9, 0.2), ("in_part", 2, 5, 0.1),
                                                ("unknown", 1, 1, None)):
                file[f"settings/{name}/seeds"] = numpy.arange(seeds)
                file[f"settings/{name}/seconds"] = numpy.full(seeds, seconds)
                if error:
                    file[f"settings/{name}/height/error"] = [error]
                    file[f"settings/{name}/height/noise"] = [0.05]
        answer = run_script("plot_trade.py", self.out)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stderr, r"^unknown \(1 of 3 runs\): left out .*\n$")
        # What study.h5 is not made of is told.
        for setting, seed in ("new", 1), ("whole", 1), *(("in_part", seed) for seed in (1, 2, 3)):
            self.write_run("out", setting, seed, {})
        answer = run_script("plot_trade.py", self.out)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        told = answer.stderr.splitlines()[:-1]
        self.assertEqual(len(told), 3)
        for line, seed in zip(told, (2, 3)):
            self.assertRegex(line, f"runs/in_part/seed_{seed}: left out, no seed of study.h5, which")
        self.assertRegex(told[2], "runs/new: left out, no setting of study.h5, which trade writes")
        with open(os.path.join(self.out, "trade.svg")) as file:
            self.assertIn("in part (2 of 3 runs)", file.read())
        sys.path.insert(0, os.path.join(SCENES, ".."))
        from plot_trade import Setting, front
        with h5py.File(study, "a") as file:
            drawn = [Setting(name, file["settings"][name], 3) for name in ("whole", "in_part")]
            self.assertEqual([setting.name for setting in front(drawn)], ["whole"])
            for setting in file["settings"].values():
                setting.pop("height", None)
        refused = run_script("plot_trade.py", self.out)
        self.assertEqual(refused.returncode, 2)
        self.assertEqual(len(refused.stderr.splitlines()), 1)

    def test_the_paper_is_held_against_its_study(self):
        # By construction: cold mixes rise a millimetre higher under half the pressure, which grows
        # evenly, and lose 0.7 of the voids that warm ones lose; the binder content changes nothing.
        time = numpy.linspace(0, 1, 50)
        for mix, content in itertools.product(("SMA 11", "AC 11"), (0, 1)):
            for degrees, seed in itertools.product((110, 150), (1, 2)):
                binder = {"SMA 11": ("6.6", "7.8"), "AC 11": ("5.4", "6.6")}[mix][content]
                name = f"{mix}_{degrees}_degC_{binder}__".replace(" ", "_")
                cold = degrees == 110
                self.write_run("flow", name, seed, {
                    "displacement": 0.05 * time, "fractured": 0 * time,
                    "uplift": time * ((1 + cold + 0.1 * seed) * 1e-3) - 2e-3 * (time > 0.1)
                    + 2e-3 * (time > 0.5),
                    "pressure": time * 2e5 * (1 - 0.5 * cold)})
                gyratory = {"gyration": 2 * time, "fractured": 0 * time,
                            "air_voids": 0.3 - 0.01 * time,
                            "air_voids_decrease": 0.01 * time * (1 - 0.3 * cold),
                            "internal_angle": 1 + 0 * time, "mould_traction": 1e5 + 0 * time}
                self.write_run("gyratory", name, seed, gyratory, 4 + 4 * cold)
                if name.startswith("SMA_11_150_degC_6.6"):
                    self.write_run("gyratory", name + "_rigid_steel", seed, gyratory, 4)
        # Of one mix a run stopped: left out, and told.
        stopped = os.path.join(self.folder("flow"), "runs", "AC_11_110_degC_5.4__", "seed_2")
        os.remove(os.path.join(stopped, "summary.json"))
        with open(stopped + ".stopped", "w") as file:
            file.write("stopped: stone 3\n")
        page = os.path.join(self.out, "paper.md")
        os.makedirs(self.out)
        with open(page, "w") as file:
            file.write("# Ours\n\n## Flow test, 7 stones\n\nas before\n\n## Another study\n\nkept\n")
        answer = run_script("plot_paper.py", self.folder("flow"), self.folder("gyratory"),
                            "--page", page)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stdout, r"decreasing temperature .* apart by 1 .* agrees")
        self.assertRegex(answer.stdout, r"decreasing binder .* apart by 0 .* not told apart")
        self.assertRegex(answer.stdout, r"A stiffer sample .* against \|")
        self.assertRegex(answer.stdout, r"Initially .* \| agrees \| down: until a quarter")
        self.assertRegex(answer.stdout, r"up to 5 mm .* \+2.20 mm, .* \| against")
        self.assertRegex(answer.stdout, r"noisy.* is 0.0 % .* \| against")
        self.assertIn("Of the 30 broken stones 50 % are of the largest fifth, 23 % of the smallest",
                      answer.stdout)
        self.assertIn("67 % of the contacts between stones are stretched bonds, 50 % of these by "
                      "more than the film of both shells, the longest by 3.0 mm", answer.stdout)
        self.assertRegex(answer.stdout, r"stiffer response .*1 against 0.7 %, .* \| agrees")
        self.assertRegex(answer.stdout, r"contact forces .*8 against 4 N, .* \| agrees")
        self.assertRegex(answer.stdout, r"internal angle .* \| not told apart")
        self.assertRegex(answer.stdout, r"AC 11, 110 degC, 6.6 % .* 2.15 \+- 0.05 ")
        self.assertIn("In a box of 150 x 100 mm; 2 seeds, `draft` with mass scale 1e4. Left out, "
                      "AC 11, 110 degC, 5.4 %, seed_2: stopped: stone 3.", answer.stdout)
        # The flow test takes its old place, the gyrations come last, the other section stays.
        with open(page) as file:
            headings = [line for line in file if line.startswith("#") or "as before" in line]
        self.assertEqual(headings, ["# Ours\n", "## Flow test, 7 stones\n", "## Another study\n",
                                    "## Gyratory compaction, 7 stones\n"])
        for picture in ("paper_flow_7.png", "paper_gyratory_7.png"):
            self.assertTrue(os.path.exists(os.path.join(self.out, picture)))

    def write_run(self, study, setting, seed, columns, force=1):
        folder = os.path.join(self.folder(study), "runs", setting, f"seed_{seed}")
        os.makedirs(folder)
        with h5py.File(os.path.join(folder, "results.h5"), "w") as file:
            for name, values in {"time": numpy.arange(50.0), **columns}.items():
                file["history/" + name] = values
                file["history/" + name].attrs["unit"] = "1"
            file["contacts/normal_force"] = [-3, force - 0.1 * seed, force + 0.1 * seed]
            # In a row: the shells of the first two overlap, the next are 1 and 3 mm apart.
            file["contacts/first"], file["contacts/second"] = [0, 1, 2], [1, 2, 3]
            file["stones/radius"] = 1e-3 * numpy.arange(1, 8)
            file["stones/shell_thickness"] = [1e-3]
            file["stones/x"] = 1e-3 * numpy.array([0, 4.5, 12.5, 24.5, 50, 70, 90])
            file["stones/y"] = file["stones/z"] = numpy.zeros(7)
            file["fractures/stone"] = [6, 3 if seed == 1 else 0]
            file.create_group("provenance")
        with open(os.path.join(folder, "summary.json"), "w") as file:
            json.dump({"stones": 7, "air_voids_start": 0.3, "bed_height_m": 0.1}, file)
        with open(os.path.join(folder, "scene.toml"), "w") as file:
            file.write('[run]\nfidelity = "draft"\n[numerics]\nmass_scale = 1e4\n')
            if study == "flow":
                file.write("[flow]\nlength = 0.15\nwidth = 0.1\n")


if __name__ == "__main__":
    run_named_test(StudyPlots)
