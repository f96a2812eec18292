"""Tables of numbers, as wall_stress and contact_path leave them."""
import warnings

import numpy as np

from .errors import InputError, reading


def read_table(path, names, program):
    """Columns by name."""
    expected, advice = f"a table of {program}", f"correct the path, or run {program} again"
    with reading(path, expected, advice), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of an empty file
        table = np.genfromtxt(path, delimiter=",", names=True, ndmin=1)
    missing = [name for name in names if name not in (table.dtype.names or ())]
    if missing:
        raise InputError(f"{path}: expected {expected}, found none of its columns "
                         f"{', '.join(missing)}; {advice}")
    columns = {name: table[name] for name in names}
    if not all(len(column) and np.isfinite(column).all() for column in columns.values()):
        raise InputError(f"{path}: expected {expected}, found a row without numbers or no row; "
                         f"{advice}")
    return columns
