"""Runs that are broken off and go on: what the tests of kills and of faults share."""
import json
import os
import shutil
import signal
import subprocess
import time

import h5py
import small_runs
from small_runs import BIN, command

OFTEN = ["output.checkpoint_interval=0.05 s"]
# Settling, ramp and gyration; head and mould elastic; eight of the stones break.
STEEL = ["stones.count=80", "mould.diameter=32 mm", "gyration.ramp=0.1 s", "gyration.count=0.1",
         "head.elastic.shaft_diameter=14 mm", "head.elastic.modes=6", "mould.elastic.modes=6",
         "mould.elastic.height=60 mm", "output.picture_interval=0.03 s"] + OFTEN
RIGID = STEEL + small_runs.RIGID
# Of a summary, what tells of the clock and not of the run.
CLOCK = "seconds_", "wall_seconds", "processor_seconds", "particle_steps_per_second"


class BrokenRuns(small_runs.SmallRuns):
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
        shutil.rmtree(folder, ignore_errors=True)
        began = time.monotonic()
        self.run_to_end(command(program, folder, overrides))
        return folder, time.monotonic() - began

    def stop_after_a_checkpoint(self, folder, line):
        path = os.path.join(folder, "checkpoint")

        def age():
            try:
                return os.stat(path).st_mtime_ns
            except FileNotFoundError:  # none yet, or the last one steps aside for the next
                return 0

        before = age()
        process = subprocess.Popen(line, stderr=subprocess.PIPE, text=True)
        while age() == before and process.poll() is None:
            time.sleep(0.001)
        process.terminate()
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, errors)
        self.assertIn("--resume", errors)
