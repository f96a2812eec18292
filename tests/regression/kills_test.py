#!/usr/bin/python3
"""Kills and signals at random moments: kills_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

The history of a run that was resumed must be that of an unbroken one, bit by bit. Every bed is
small enough for a run of seconds."""
import os
import random
import shutil
import signal
import subprocess

import h5py
import small_runs
from broken_runs import OFTEN, RIGID, STEEL, BrokenRuns
from small_runs import command, run_named_test

# A whole gyration with everything that a run can write: ledger, gauge and map beside the rest.
OUTPUTS = STEEL + ["stones.count=40", "fill.rest_energy=0.1", "gyration.ramp=0.05 s",
                   "gyration.speed=5 rev/s", "gyration.count=1", "output.energy_ledger=true",
                   "output.maps=true", 'output.gauge=[{angle="30 deg", height="12 mm"}]']
FLOW = small_runs.FLOW + ["output.picture_interval=0.2 s"] + OFTEN


class Kills(BrokenRuns):
    def setUp(self):
        super().setUp()
        self.random = random.Random(2019)

    def break_off(self, line, signals, patience):
        """Runs `line` for so many seconds; False if it came to its end before."""
        process = subprocess.Popen(line, stderr=subprocess.PIPE, text=True)
        try:
            _, errors = process.communicate(timeout=patience)
        except subprocess.TimeoutExpired:
            which = self.random.choice(signals)
            process.send_signal(which)
            _, errors = process.communicate()
            if process.returncode != 0:
                # Before it listens to signals, the system ends it.
                ends = [-which] if which == signal.SIGKILL else [128 + which, -which]
                self.assertIn(process.returncode, ends, errors)
                return True
        self.assertEqual(process.returncode, 0, errors)
        self.assertNotIn("were not what the run had found", errors)
        return False

    def break_and_resume(self, signals, overrides, kills, program="gyratory"):
        """Kills runs at random moments of their first seconds, again and again, until they end."""
        unbroken, length = self.unbroken(overrides, program)
        done = 0
        while done < kills:
            folder = self.folder("broken")
            line = command(program, folder, overrides)
            reached = 0
            # The short ones first: a run must be broken in every stage, and come to its end.
            while self.break_off(line, signals, None if done >= kills else self.random.uniform(
                    0, length * min(1, 0.3 + done / max(4, kills)))):
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
        self.break_and_resume([signal.SIGKILL], RIGID, 60)
        unbroken = self.break_and_resume([signal.SIGKILL], STEEL, 25)
        with h5py.File(os.path.join(unbroken, "results.h5")) as file:
            self.assertGreater(len(file["fractures/stone"]), 0)
        self.break_and_resume([signal.SIGKILL], OUTPUTS, 15)

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
        line = command("gyratory", folder, overrides)
        for _ in range(8):
            self.stop_after_a_checkpoint(folder, line)
            line = self.resume(folder)
        self.run_to_end(line)
        self.assert_same(folder, unbroken)


if __name__ == "__main__":
    run_named_test(Kills)
