#!/usr/bin/python3
"""What one gets to see of a run: looks_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

Pictures for ParaView, plots, the page, and renderings, of beds small enough to take seconds."""
import fcntl
import os
import re
import signal
import subprocess
import sys
import time

import h5py
from small_runs import FLOW, RIGID, SCENES, SmallRuns, command, run_named_test, run_script

TINY = ["stones.count=40", "mould.diameter=32 mm", "fill.rest_energy=0.1", "gyration.ramp=0.05 s",
        "gyration.speed=5 rev/s", "gyration.count=1", "output.picture_interval=0.02 s"]
STEEL = ["head.elastic.modes=6", "mould.elastic.modes=6", "mould.elastic.height=60 mm",
         "head.elastic.shaft_diameter=14 mm"]


class Looks(SmallRuns):
    def run_scene(self, name, overrides, program="gyratory"):
        folder = self.folder(name)
        subprocess.run(command(program, folder, overrides), check=True)
        return folder

    def script(self, name, *arguments):
        done = run_script(name, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.split()

    def page(self, *folders):
        with open(self.script("plot_run.py", *folders)[-1]) as file:
            page = file.read()
        # Needs no other file.
        self.assertEqual(re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', page), [])
        return page, set(re.findall(r'<h2 id="([a-z]+)">', page))

    def test_vtk_reads_the_pictures_of_a_run(self):
        import vtk

        folder = self.run_scene("run", TINY + STEEL + ["gyration.count=0.1"])
        arrays = {"stones": {"diameter [m]", "radius [m]", "id [1]", "broken [1]",
                             "coordination [1]", "shell thickness [m]", "velocity [m/s]"},
                  "head": {"displacement [m]", "von Mises stress [Pa]"},
                  "mould": {"displacement [m]", "von Mises stress [Pa]"}}
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            radius = sorted(file["stones/radius"][:])
        for series, names in arrays.items():
            with open(os.path.join(folder, series + ".pvd")) as file:
                files = re.findall(r'file="([^"]+)"', file.read())
            self.assertGreater(len(files), 1)
            for name in files:
                poly = name.endswith(".vtp")
                reader = vtk.vtkXMLPolyDataReader() if poly else vtk.vtkXMLUnstructuredGridReader()
                reader.SetFileName(os.path.join(folder, name))
                reader.Update()
                self.assertEqual(reader.GetErrorCode(), 0, name)
                data = reader.GetOutput().GetPointData()
                found = {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}
                self.assertLessEqual(names, found, name)
                for array in found:
                    self.assertRegex(array, r" \[.+\]$")
                if series == "stones":
                    values = data.GetArray("radius [m]")
                    drawn = sorted(values.GetValue(k) for k in range(values.GetNumberOfTuples()))
                    self.assertEqual(drawn, radius)

    def test_a_page_shows_everything_of_a_gyratory_run(self):
        folder = self.run_scene("run", TINY + STEEL + [
            "output.energy_ledger=true", "output.maps=true",
            'output.gauge=[{angle="0 deg", height="12 mm"}]'])
        page, parts = self.page(folder)
        self.assertEqual(parts, {"compaction", "head", "stones", "voids", "walls", "gauges",
                                 "gradation", "energy", "filling", "budget"})
        self.assertEqual(page.count("<svg"), len(parts))
        self.assertTrue("air_voids_end" in page and "seed = 1" in page)
        for part in parts:
            for ending in ("png", "svg"):
                self.assertTrue(os.path.exists(os.path.join(folder, "plots", f"{part}.{ending}")))
        # A finished run is drawn once and not watched any longer.
        self.script("plot_run.py", folder, "--live", "1")
        self.assertTrue(os.path.exists(os.path.join(folder, "run.png")))

    def test_void_profiles_have_the_mean_of_the_run(self):
        # The same spheres in the same room: 0.5 % is that of points instead of spheres.
        sys.path.insert(0, os.path.join(SCENES, ".."))
        import pathlib

        import numpy as np
        from plots.run import Run
        from plots.stones import void_profiles

        run = Run(pathlib.Path(self.run_scene("run", TINY + RIGID)))
        (_, over_height), (ring, over_radius) = void_profiles(run)
        mean = 100 * run.columns["air_voids"][-1]
        self.assertAlmostEqual(np.mean(over_height), mean, delta=0.5)
        self.assertAlmostEqual(np.average(over_radius, weights=np.diff(ring**2)), mean, delta=0.5)

    def test_pages_lay_runs_over_each_other(self):
        flows = [self.run_scene("flow" + seed, FLOW + ["run.seed=" + seed], "flow_test")
                 for seed in ("1", "2")]
        page, parts = self.page(*flows)
        self.assertEqual(parts, {"flow", "stones", "gradation", "filling", "budget"})
        self.assertTrue("uplift_lowest_m" in page and "seed = 2" in page)
        self.assertNotIn("the head", page)
        gyratory = [self.run_scene("gyratory" + seed, TINY + RIGID + ["run.seed=" + seed])
                    for seed in ("1", "2")]
        _, parts = self.page(*gyratory)
        self.assertEqual(parts, {"compaction", "head", "stones", "voids", "gradation", "filling",
                                 "budget"})
        mixed = run_script("plot_run.py", flows[0], gyratory[0])
        self.assertEqual(mixed.returncode, 2)
        self.assertIn("runs of one program", mixed.stderr)

    def test_a_run_can_be_watched_while_it_fills(self):
        folder = self.folder("run")
        process = subprocess.Popen(command("gyratory", folder, RIGID + ["fill.rest_energy=1e-9"]),
                                   stderr=subprocess.DEVNULL)
        while not os.path.exists(os.path.join(folder, "results.h5")):
            time.sleep(0.01)
        time.sleep(2)
        process.terminate()
        self.assertEqual(process.wait(), 128 + signal.SIGTERM)
        with h5py.File(os.path.join(folder, "results.h5")) as file:
            self.assertEqual(len(file["history/time"]), 0)
            self.assertGreater(len(file["filling/time"]), 1)
        _, parts = self.page(folder)
        self.assertEqual(parts, {"filling"})

    def test_a_watch_ends_with_its_run(self):
        # Whoever holds the lock is a run, here one whose first results are still empty.
        folder = self.folder("run")
        os.makedirs(folder)
        open(os.path.join(folder, "results.h5"), "w").close()
        with open(os.path.join(folder, "lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            script = os.path.join(SCENES, "..", "plot_run.py")
            watch = subprocess.Popen(["/usr/bin/python3", script, folder, "--live", "0.1"],
                                     stderr=subprocess.PIPE, text=True)
            with self.assertRaises(subprocess.TimeoutExpired):
                watch.wait(3)
        words = watch.communicate(timeout=60)[1]
        self.assertEqual(watch.returncode, 2)
        self.assertIn("expected a run that goes on or has finished, found neither", words)
        for folders, words in (([folder + "1"], "expected the folder of a run"),
                               ([folder, folder], "expected one folder, found 2")):
            refused = run_script("plot_run.py", *folders, "--live")
            self.assertEqual(refused.returncode, 2)
            self.assertIn(words, refused.stderr)

    def test_an_interrupted_watch_says_nothing(self):
        sys.path.insert(0, os.path.join(SCENES, ".."))
        from plots.errors import exit_status_of

        def interrupted():
            raise KeyboardInterrupt

        self.assertEqual(exit_status_of(interrupted), 128 + signal.SIGINT)

    def test_classes_of_size_hold_the_stones_of_all_runs(self):
        sys.path.insert(0, os.path.join(SCENES, ".."))
        from types import SimpleNamespace

        import numpy as np
        from plots.stones import size_classes

        def run(sieves, diameters):
            return SimpleNamespace(sieves=lambda: (1e-3 * np.array(sieves), None),
                                   table=lambda _: {"radius": 5e-4 * np.array(diameters)})

        runs = [run([1, 4, 8, 16, 32], [9, 15]), run([1, 2, 4, 8], [3, 7])]
        self.assertEqual(list(size_classes(runs[:1])), [8, 16])
        self.assertEqual(list(size_classes(runs)), [2, 4, 8, 16])

    def test_a_run_is_rendered(self):
        from PIL import Image

        folder = self.run_scene("run", TINY + RIGID + ["output.picture_interval=0 s",
                                                       "output.movie=true"])
        self.script("render_run.py", folder)
        for name in ("packing.png", "forces.png", "fractures.png", "slices.png", "gyration.gif"):
            with Image.open(os.path.join(folder, "renders", name)) as image:
                used = image.convert("RGB").getcolors(1 << 24)
                self.assertGreater(len(used), 20, name)  # not an empty stage
                if name.endswith(".gif"):
                    self.assertGreaterEqual(image.n_frames, 16)

    def test_a_run_without_a_movie_says_what_to_set(self):
        # A sixteenth of a gyration at 5 rev/s is 12.5 ms.
        folder = self.run_scene("run", TINY + RIGID + ["output.movie=false"])
        done = run_script("render_run.py", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('with output.movie = true or output.picture_interval = "0.0125 s"',
                      done.stderr)
        self.assertFalse(os.path.exists(os.path.join(folder, "renders", "gyration.gif")))


if __name__ == "__main__":
    run_named_test(Looks)
