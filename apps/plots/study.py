"""What trade left in the folder of a study: runs/SETTING/seed_N, and study.h5, which it writes anew
whenever all runs are over."""
import contextlib
import sys

import h5py

from .errors import InputError, reading
from .folders import STUDY, expect


WRITTEN = "which trade writes when all runs are over"


def as_word(name):
    """The name of a setting as part of a path, as apps/study.h has it."""
    return "".join(c if c.isalnum() or c in ".-" else "_" for c in name.replace(",", ""))


@contextlib.contextmanager
def results(folder):
    """study.h5 of a study that came to its end."""
    expect(folder, STUDY)
    path = folder / "study.h5"
    if not path.exists():
        raise InputError(f"{path}: expected the results of a study, found none yet, as its runs "
                         f"are not over; go on by trade STUDY.toml --out {folder}")
    with reading(path, "the results of a study", "run trade again"), h5py.File(path) as file:
        yield file


def runs_by_setting(folder):
    """Folders of the runs that came to their end, by the word of their setting, where it is one of
    study.h5, if that is there. Says which are left out."""
    expect(folder, STUDY)
    known = None
    if (folder / "study.h5").exists():
        with results(folder) as file:
            known = set(file.get("settings", {}))
    found, unknown = {}, {}
    for run in sorted(path for path in folder.glob("runs/*/seed_*") if path.is_dir()):
        word = run.parent.name
        if known is not None and word not in known:
            unknown[word] = run.parent
        elif (run / "summary.json").exists():
            found.setdefault(word, []).append(run)
        else:
            print(f"{run}: left out, not at its end", file=sys.stderr)
    for setting in unknown.values():
        print(f"{setting}: left out, no setting of study.h5, {WRITTEN}", file=sys.stderr)
    return found
