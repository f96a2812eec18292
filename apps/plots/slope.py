"""How fast a mix densifies."""
import numpy as np


def per_decade(gyration, density, first):
    """Slope of the density over the logarithm of the gyrations from the first one on, by least
    squares over points as far apart in decades; nan where the run ends before."""
    if gyration[-1] <= first:
        return np.nan
    decades = np.linspace(np.log10(first), np.log10(gyration[-1]), 200)
    return np.polyfit(decades, np.interp(10**decades, gyration, density), 1)[0]
