#!/usr/bin/python3
"""Full disks, damaged files, folders in use: faults_test.py BIN_FOLDER SCENES_FOLDER TEST_NAME

What goes on after trouble must end as an unbroken run, bit by bit."""
import os
import resource
import shutil
import signal
import subprocess
import time

from broken_runs import RIGID, BrokenRuns
from small_runs import BIN, command, run_named_test


class Faults(BrokenRuns):
    def stopped_run(self, name, overrides=RIGID):
        """The folder of a run that was asked to stop twice: it holds two checkpoints."""
        folder = self.folder(name)
        line = command("gyratory", folder, overrides)
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

    def test_another_build_goes_on_and_says_so(self):
        folder = self.stopped_run("begun")
        other = self.folder("gyratory")
        shutil.copy(os.path.join(BIN, "gyratory"), other)
        with open(other, "ab") as file:
            file.write(b" ")
        words = "begun by another build of the program"
        self.assertIn(words, self.run_to_end([other] + self.resume(folder)[1:]))
        self.assertNotIn(words, self.run_to_end(self.resume(self.stopped_run("own"))))

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
        errors = self.run_to_end(command("gyratory", folder, RIGID), 4)
        self.assertIn("--resume", errors)
        self.assertIn("--overwrite", errors)
        self.assertEqual(self.rows(folder), before)
        with open(os.path.join(folder, "notes.txt"), "w") as file:
            file.write("somebody's")
        self.run_to_end(command("gyratory", folder, RIGID, "--overwrite"))
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
        first = subprocess.Popen(command("gyratory", folder, long), stderr=subprocess.PIPE)
        while not os.path.exists(os.path.join(folder, "results.h5")):
            time.sleep(0.01)
        for line in (command("gyratory", folder, RIGID), self.resume(folder),
                     command("gyratory", folder, RIGID, "--overwrite")):
            self.assertIn("another process runs here", self.run_to_end(line, 4))
        first.terminate()
        first.communicate()
        self.assertEqual(first.returncode, 128 + signal.SIGTERM)

    def test_a_folder_that_cannot_be_written_ends_with_status_4(self):
        self.run_to_end(command("gyratory", "/proc/run", RIGID), 4)
        self.run_to_end(command("gyratory", "/dev/null/run", RIGID), 4)
        self.assertIn("scene", self.run_to_end(self.resume(self.folder("nothing")), 2))
        if os.geteuid() == 0:
            return  # nothing is unwritable for root
        folder = self.folder("locked")
        os.mkdir(folder, 0o500)
        self.run_to_end(command("gyratory", folder, RIGID), 4)

    def test_a_full_disk_ends_with_status_4_and_the_run_goes_on_when_there_is_space(self):
        unbroken, _ = self.unbroken(RIGID)
        folder = self.folder("full")
        # The limit lets the first small files through, and no checkpoint of this bed.
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (60000, -1))
        errors = self.run_to_end(command("gyratory", folder, RIGID), 4, preexec_fn=limit)
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
            errors = self.run_to_end(command("gyratory", folder, RIGID), 4)
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
        first = self.run_to_end(command("gyratory", folder, crushed), 3)
        self.assertRegex(first, r"stopped: stone \d+, time .* s: stone overlap")
        self.assertTrue(os.path.exists(os.path.join(folder, "checkpoint")))
        again = self.run_to_end(self.resume(folder), 3)
        self.assertEqual(first.splitlines()[-1], again.splitlines()[-1])


if __name__ == "__main__":
    run_named_test(Faults)
