#!/usr/bin/env python3
"""What can befall a run: faults_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

Kills, signals, full disks and damaged files; the history of a run that was resumed must be that of
an unbroken one, bit by bit. Every bed is small enough for a run of seconds."""
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py

BIN, SCENES = sys.argv[1], sys.argv[2]
os.environ["OMP_WAIT_POLICY"] = "passive"  # tests run side by side: waiting threads must not spin

OFTEN = ["output.checkpoint_interval=0.05 s"]
# Settling, ramp and gyration; head and mould elastic; eight of the stones break.
STEEL = ["stones.count=80", "mould.diameter=32 mm", "gyration.ramp=0.1 s", "gyration.count=0.1",
         "head.elastic.shaft_diameter=14 mm", "head.elastic.modes=6", "mould.elastic.modes=6",
         "mould.elastic.height=60 mm", "output.picture_interval=0.03 s"] + OFTEN
RIGID = STEEL + ["head.elastic=none", "mould.elastic=none"]
# A whole gyration with everything that a run can write: ledger, gauge and map beside the rest.
OUTPUTS = STEEL + ["stones.count=40", "fill.rest_energy=0.1", "gyration.ramp=0.05 s",
                   "gyration.speed=5 rev/s", "gyration.count=1", "output.energy_ledger=true",
                   "output.maps=true", 'output.gauge=[{angle="30 deg", height="12 mm"}]']
FLOW = ["stones.count=130", "flow.length=50 mm", "flow.width=35 mm", "flow.height=30 mm",
        "flow.strip_length=15 mm", "flow.displacement=0.15 mm",
        "output.picture_interval=0.2 s"] + OFTEN
# Of a summary, what tells of the clock and not of the run.
CLOCK = "seconds_", "wall_seconds", "particle_steps_per_second"


class Faults(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.random = random.Random(2019)

    def folder(self, name):
        return os.path.join(self.place.name, name)

    def begin(self, folder, overrides, *options, program="gyratory"):
        scene = {"gyratory": "gyratory_sma11_150C.toml", "flow_test": "flow_sma11_150C.toml"}
        line = [os.path.join(BIN, program), os.path.join(SCENES, scene[program]), "--quiet",
                "--out", folder]
        for override in overrides:
            line += ["--set", override]
        return line + list(options)

    def resume(self, folder, *options, program="gyratory"):
        return [os.path.join(BIN, program), "--quiet", "--resume", folder] + list(options)

    def run_to_end(self, line, status=0, **settings):
        done = subprocess.run(line, capture_output=True, text=True, **settings)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    def rows(self, folder):
        path = os.path.join(folder, "results.h5")
        if not os.path.exists(path) or os.path.getsize(path) == 0:
            return 0
        with h5py.File(path) as file:
            return len(file["history/time"])

    def datasets(self, file):
        """Everything that results.h5 holds: histories, stones, contacts, maps, filling."""
        found = {}
        file.visititems(lambda name, item: found.update({name: item[:]})
                        if isinstance(item, h5py.Dataset) else None)
        return found

    def assert_same(self, folder, unbroken):
        with h5py.File(os.path.join(folder, "results.h5")) as one, \
                h5py.File(os.path.join(unbroken, "results.h5")) as two:
            found, expected = self.datasets(one), self.datasets(two)
            self.assertEqual(set(found), set(expected))
            for key, values in expected.items():
                self.assertEqual(found[key].tobytes(), values.tobytes(), key)
        summaries = []
        for place in (folder, unbroken):
            with open(os.path.join(place, "summary.json")) as file:
                summary = json.load(file)
            summaries.append({key: summary[key] for key in summary if not key.startswith(CLOCK)})
        self.assertEqual(*summaries)
        pictures = [sorted(name for name in os.listdir(place) if ".vt" in name or ".pvd" in name)
                    for place in (folder, unbroken)]
        self.assertEqual(*pictures)
        for name in pictures[0]:
            with open(os.path.join(folder, name), "rb") as one, \
                    open(os.path.join(unbroken, name), "rb") as two:
                self.assertTrue(one.read() == two.read(), name)

    def unbroken(self, overrides, program="gyratory"):
        """The folder of a run that nothing befell, and how long it took."""
        folder = self.folder("unbroken")
        began = time.monotonic()
        self.run_to_end(self.begin(folder, overrides, program=program))
        return folder, time.monotonic() - began

    def break_and_resume(self, signals, overrides, kills, program="gyratory"):
        """Kills runs at random moments of their first seconds, again and again, until they end."""
        unbroken, length = self.unbroken(overrides, program)
        done = 0
        run = 0
        while done < kills:
            run += 1
            folder = self.folder(f"broken{run}")
            reached = 0
            line = self.begin(folder, overrides, program=program)
            while True:
                # The short ones first: a run must be broken in every stage, and come to its end.
                patience = self.random.uniform(0, length * min(1, 0.3 + done / max(4, kills)))
                if done >= kills:
                    patience = None
                process = subprocess.Popen(line, stderr=subprocess.PIPE, text=True)
                try:
                    _, errors = process.communicate(timeout=patience)
                    self.assertEqual(process.returncode, 0, errors)
                    self.assertNotIn("were not what the run had found", errors)
                    break
                except subprocess.TimeoutExpired:
                    which = self.random.choice(signals)
                    process.send_signal(which)
                    _, errors = process.communicate()
                    status = process.returncode
                    if status == 0:
                        break
                    if which == signal.SIGKILL:
                        self.assertEqual(status, -signal.SIGKILL)
                    else:  # before it listens to signals, the system ends it
                        self.assertIn(status, (128 + which, -which), errors)
                    done += 1
                rows = self.rows(folder)
                self.assertGreaterEqual(rows, reached)  # a history loses nothing
                reached = rows
                if os.path.exists(os.path.join(folder, "scene.toml")):
                    line = self.resume(folder, "--threads", self.random.choice("12"),
                                       program=program)
            self.assert_same(folder, unbroken)
            shutil.rmtree(folder)
        return unbroken

    def test_kills_do_not_change_a_bit(self):
        self.break_and_resume([signal.SIGKILL], STEEL, 4)

    def test_a_hundred_kills_do_not_change_a_bit(self):
        # With rigid walls for most of them: a run in elastic steel is mostly its preparation.
        self.break_and_resume([signal.SIGKILL], RIGID, 85)
        self.place.cleanup()
        os.mkdir(self.place.name)
        self.break_and_resume([signal.SIGKILL], STEEL, 15)

    def test_kills_do_not_change_a_bit_of_any_output(self):
        unbroken = self.break_and_resume([signal.SIGKILL, signal.SIGTERM], OUTPUTS, 3)
        with h5py.File(os.path.join(unbroken, "results.h5")) as file:
            self.assertEqual(set(file["walls/mould/gyration"][:]), {1})
            self.assertIn("history/energy_residual", file)
            self.assertGreater(abs(file["history/gauge_1_hoop_strain"][-1]), 0)

    def test_being_asked_to_stop_does_not_change_a_bit(self):
        self.break_and_resume([signal.SIGTERM, signal.SIGINT], RIGID, 5)

    def test_kills_do_not_change_a_bit_of_a_flow_test(self):
        self.break_and_resume([signal.SIGKILL, signal.SIGTERM], FLOW, 5, "flow_test")

    def test_stops_while_checkpoints_are_written_do_not_change_a_bit(self):
        # Two milliseconds between checkpoints: most signals arrive during a write.
        overrides = RIGID + ["output.checkpoint_interval=2 ms", "output.picture_interval=0 s",
                             "gyration.ramp=0.02 s", "gyration.count=0.01"]
        unbroken, _ = self.unbroken(overrides + ["output.checkpoint_interval=1 h"])
        folder = self.folder("broken")
        line = self.begin(folder, overrides)
        for _ in range(8):
            self.stop_after_a_checkpoint(folder, line)
            line = self.resume(folder)
        self.run_to_end(line)
        self.assert_same(folder, unbroken)

    def stop_after_a_checkpoint(self, folder, line):
        path = os.path.join(folder, "checkpoint")
        age = lambda: os.stat(path).st_mtime_ns if os.path.exists(path) else 0
        before = age()
        process = subprocess.Popen(line, stderr=subprocess.PIPE, text=True)
        while age() == before and process.poll() is None:
            time.sleep(0.001)
        process.terminate()
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, errors)
        self.assertIn("--resume", errors)

    def stopped_run(self, name, overrides=RIGID):
        """The folder of a run that was asked to stop twice: it holds two checkpoints."""
        folder = self.folder(name)
        line = self.begin(folder, overrides)
        for _ in range(2):
            self.stop_after_a_checkpoint(folder, line)
            line = self.resume(folder)
        self.assertTrue(os.path.exists(os.path.join(folder, "checkpoint.older")))
        return folder

    def test_a_damaged_checkpoint_is_refused_and_the_older_one_used(self):
        unbroken, _ = self.unbroken(RIGID)

        def flip(data):
            middle = len(data) // 2
            return data[:middle] + bytes([data[middle] ^ 4]) + data[middle + 1:]

        def cut(data):
            return data[:len(data) // 3]

        for name, damage, reason in (("flipped", flip, "checksum"), ("cut", cut, "bytes of")):
            folder = self.stopped_run(name)
            path = os.path.join(folder, "checkpoint")
            with open(path, "rb") as file:
                data = file.read()
            with open(path, "wb") as file:
                file.write(damage(data))
            errors = self.run_to_end(self.resume(folder))
            self.assertIn("checkpoint: not taken", errors)
            self.assertIn(reason, errors)
            self.assert_same(folder, unbroken)

    def test_without_a_sound_checkpoint_a_run_begins_anew(self):
        unbroken, _ = self.unbroken(RIGID)
        folder = self.stopped_run("broken")
        for name in ("checkpoint", "checkpoint.older"):
            with open(os.path.join(folder, name), "wb") as file:
                file.write(b"gyratory checkpoint 1\n")
        errors = self.run_to_end(self.resume(folder))
        self.assertEqual(errors.count("not taken"), 2)
        self.assert_same(folder, unbroken)

    def test_a_checkpoint_of_another_scene_is_refused(self):
        folder = self.stopped_run("one")
        path = os.path.join(folder, "scene.toml")
        with open(path) as file:
            scene = file.read()
        with open(path, "w") as file:
            file.write(scene.replace("seed = 1", "seed = 2"))
        errors = self.run_to_end(self.resume(folder), 4)
        self.assertIn("another scene, with \"seed = 1\"", errors)
        with open(path, "w") as file:
            file.write(scene)
        self.run_to_end(self.resume(folder))

    def test_a_folder_that_holds_a_run_is_not_written_over(self):
        folder = self.stopped_run("kept")
        before = self.rows(folder)
        errors = self.run_to_end(self.begin(folder, RIGID), 4)
        self.assertIn("--resume", errors)
        self.assertIn("--overwrite", errors)
        self.assertEqual(self.rows(folder), before)
        with open(os.path.join(folder, "notes.txt"), "w") as file:
            file.write("somebody's")
        self.run_to_end(self.begin(folder, RIGID, "--overwrite"))
        self.assertFalse(os.path.exists(os.path.join(folder, "checkpoint.older.part")))
        self.assertTrue(os.path.exists(os.path.join(folder, "notes.txt")))
        unbroken, _ = self.unbroken(RIGID)
        self.assert_same(folder, unbroken)
        # A finished run has nothing left to do.
        self.run_to_end(self.resume(folder))
        self.run_to_end(self.resume(folder, "--overwrite"), 2)

    def test_two_runs_do_not_share_a_folder(self):
        folder = self.folder("shared")
        long = RIGID + ["gyration.count=50"]
        first = subprocess.Popen(self.begin(folder, long), stderr=subprocess.PIPE)
        while not os.path.exists(os.path.join(folder, "results.h5")):
            time.sleep(0.01)
        for line in (self.begin(folder, RIGID), self.resume(folder),
                     self.begin(folder, RIGID, "--overwrite")):
            self.assertIn("another process runs here", self.run_to_end(line, 4))
        first.terminate()
        first.communicate()
        self.assertEqual(first.returncode, 128 + signal.SIGTERM)

    def test_a_folder_that_cannot_be_written_ends_with_status_4(self):
        self.run_to_end(self.begin("/proc/run", RIGID), 4)
        self.run_to_end(self.begin("/dev/null/run", RIGID), 4)
        self.assertIn("scene", self.run_to_end(self.resume(self.folder("nothing")), 2))
        if os.geteuid() == 0:
            return  # nothing is unwritable for root
        folder = self.folder("locked")
        os.mkdir(folder, 0o500)
        self.run_to_end(self.begin(folder, RIGID), 4)

    def test_a_full_disk_ends_with_status_4_and_the_run_goes_on_when_there_is_space(self):
        unbroken, _ = self.unbroken(RIGID)
        folder = self.folder("full")
        # The limit lets the first small files through, and no checkpoint of this bed.
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (60000, -1))
        errors = self.run_to_end(self.begin(folder, RIGID), 4, preexec_fn=limit)
        self.assertIn("cannot write", errors)
        self.assertFalse([name for name in os.listdir(folder) if name.endswith(".part")])
        self.run_to_end(self.resume(folder), 4, preexec_fn=limit)
        self.run_to_end(self.resume(folder))
        self.assert_same(folder, unbroken)

    def test_a_small_disk_that_is_full_ends_with_status_4(self):
        disk = self.folder("disk")
        os.mkdir(disk)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", disk],
                                 capture_output=True, text=True)
        if mounted.returncode != 0:
            self.skipTest("no tmpfs can be mounted here: " + mounted.stderr.strip())
        try:
            folder = os.path.join(disk, "run")
            errors = self.run_to_end(self.begin(folder, RIGID), 4)
            self.assertIn("No space left", errors)
            subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
            self.run_to_end(self.resume(folder))
            unbroken, _ = self.unbroken(RIGID)
            self.assert_same(folder, unbroken)
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_numerical_trouble_keeps_the_last_checkpoint(self):
        folder = self.folder("crushed")
        crushed = RIGID + ["gyration.pressure=40 MPa", "numerics.largest_overlap=1e-3"]
        first = self.run_to_end(self.begin(folder, crushed), 3)
        self.assertRegex(first, r"stopped: stone \d+, time .* s: stone overlap")
        self.assertTrue(os.path.exists(os.path.join(folder, "checkpoint")))
        again = self.run_to_end(self.resume(folder), 3)
        self.assertEqual(first.splitlines()[-1], again.splitlines()[-1])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "Faults.test_" + sys.argv[3]])
