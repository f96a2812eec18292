"""What a run left in its folder, in the units that are shown."""
import json
import tomllib

import h5py
import numpy as np

from .errors import reading
from .folders import RUN, expect

# Stored unit: the unit that is shown, and the factor between them.
SHOWN_AS = {"Pa": ("kPa", 1e-3), "m": ("mm", 1e3), "1": ("-", 1)}
PERCENT = ("air_voids", "air_voids_decrease", "energy_residual_share")


class Run:
    """A run, finished or not; its histories may still be empty."""

    def __init__(self, folder):
        expect(folder, RUN)
        self.folder = folder
        self.name = folder.resolve().name
        with self.reading("results.h5"), h5py.File(folder / "results.h5") as file:
            self.columns = {name: column[:] for name, column in file["history"].items()}
            self.units = {name: column.attrs["unit"] for name, column in file["history"].items()}
            self.provenance = dict(file["provenance"].attrs)
            self.tables = {}
            for group in ("stones", "contacts", "wall_contacts", "fractures", "filling",
                          "walls/mould", "head", "mould", "box", "strip"):
                if group in file:
                    self.tables[group] = {name: data[:] for name, data in file[group].items()}
            self.began = len(self.columns["time"]) > 0
        summary = folder / "summary.json"
        with self.reading("summary.json"):
            self.summary = json.loads(summary.read_text()) if summary.exists() else {}
        self.gyratory = "gyration" in self.columns

    def reading(self, name):
        return reading(self.folder / name, "a file of a run", "run it again")

    def scene_text(self):
        stored = self.folder / "scene.toml"
        return stored.read_text() if stored.exists() else self.provenance["scene"]

    def scene(self):
        with self.reading("scene.toml"):
            return tomllib.loads(self.scene_text())

    def sieves(self):
        """Sieve openings [m] and the mass share that passes them, as the scene asked for."""
        with self.reading("gradation.csv"):
            text = (self.folder / "gradation.csv").read_bytes().decode("utf-8-sig", "replace")
            lines = [line.strip() for line in text.split("\n")]
            rows = [line for line in lines if line and not line.startswith("#")]
            table = np.loadtxt(rows[1:], delimiter=",", ndmin=2)  # below its heading
            return 1e-3 * table[:, 0], 1e-2 * table[:, 1]

    def table(self, group):
        """A group of results.h5, or None where the run has not come so far."""
        return self.tables.get(group)

    def shown(self, name):
        return self.columns[name] * self.factor(name)

    def factor(self, name):
        return 100 if name in PERCENT else SHOWN_AS.get(self.units[name], (None, 1))[1]

    def unit(self, name):
        return "%" if name in PERCENT else SHOWN_AS.get(self.units[name], (self.units[name],))[0]

    def label(self, words, name):
        return f"{words} [{self.unit(name)}]"

    def gyrating(self):
        """Which rows belong to gyrations: those behind the row that ends where they begin, a little
        above zero, whose means are of the time before; the last in any case."""
        begin = np.count_nonzero(self.columns["gyration"] <= 0)
        return slice(max(0, min(begin + 1, len(self.columns["gyration"]) - 1)), None)

    def mean_gyrating(self, name):
        """Of a column over the gyrations, each row weighing as much as it is long."""
        rows = self.gyrating()
        return np.average(self.columns[name][rows],
                          weights=np.diff(self.columns["time"], prepend=0)[rows])

    def gyration_at(self, time):
        return np.interp(time, self.columns["time"], self.columns["gyration"])
