"""What the tests of whole runs share; each is called FILE_test.py BIN_FOLDER SCENES_FOLDER NAME."""
import os
import subprocess
import sys
import tempfile
import unittest

BIN, SCENES = sys.argv[1], os.path.abspath(sys.argv[2])
os.environ["OMP_WAIT_POLICY"] = "passive"  # tests run side by side: waiting threads must not spin

SCENE_OF = {"gyratory": "gyratory_sma11_150C.toml", "flow_test": "flow_sma11_150C.toml"}
SMALL = ["stones.count=150", "mould.diameter=36 mm", "gyration.ramp=0.5 s", "gyration.count=2"]
RIGID = ["head.elastic=none", "mould.elastic=none"]
FLOW = ["stones.count=130", "flow.length=50 mm", "flow.width=35 mm", "flow.height=30 mm",
        "flow.strip_length=15 mm", "flow.displacement=0.15 mm"]


def command(program, folder, overrides, *options, scene=None):
    scene = os.path.join(SCENES, scene or SCENE_OF[program])
    line = [os.path.join(BIN, program), scene, "--out", folder, "--quiet"]
    for override in overrides:
        line += ["--set", override]
    return line + list(options)


def run_script(name, *arguments):
    """One of apps/."""
    return subprocess.run(["/usr/bin/python3", os.path.join(SCENES, "..", name), *arguments],
                          capture_output=True, text=True)


class SmallRuns(unittest.TestCase):
    """Tests that leave nothing behind."""

    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)

    def folder(self, name):
        return os.path.join(self.place.name, name)


def run_named_test(tests):
    unittest.main(argv=[sys.argv[0], f"{tests.__name__}.test_{sys.argv[3]}"])
