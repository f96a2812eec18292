"""Slices through the stones at the end of a run, as a computed tomograph would see them."""
import matplotlib.pyplot as plt
import numpy as np

AIR, BINDER, STONE = 0.0, 0.45, 0.9  # shown as brightness; outside the mould: nothing


def slice_image(place, radius, shell, axis, at, extent, pixels=420):
    """Densities on the plane coordinate[axis] = at; extent: (x0, x1, y0, y1) in that plane [m]."""
    x0, x1, y0, y1 = extent
    step = max(x1 - x0, y1 - y0) / pixels
    x, y = np.arange(x0 + step / 2, x1, step), np.arange(y0 + step / 2, y1, step)
    image = np.full((len(y), len(x)), AIR)
    across = [k for k in range(3) if k != axis]
    for grown, density in ((shell, BINDER), (0, STONE)):
        away = np.abs(place[:, axis] - at)
        for k in np.flatnonzero(away < radius + grown):
            disc = np.sqrt((radius[k] + grown)**2 - away[k]**2)
            cx, cy = place[k, across[0]], place[k, across[1]]
            columns = slice(np.searchsorted(x, cx - disc), np.searchsorted(x, cx + disc))
            rows = slice(np.searchsorted(y, cy - disc), np.searchsorted(y, cy + disc))
            inside = (x[None, columns] - cx)**2 + (y[rows, None] - cy)**2 < disc**2
            part = image[rows, columns]
            part[inside] = density
    return image


def leave_out_corners(image):
    """Of a square picture around a round mould."""
    rows, columns = (np.linspace(-1, 1, count) for count in image.shape)
    image[rows[:, None]**2 + columns[None, :]**2 > 1] = np.nan


def draw(run, extent):
    """Three level slices above two upright ones; extent: of the room, ((x0, y0, z0), (x1, ...))."""
    table = run.table("stones")
    place = np.stack([table["x"], table["y"], table["z"]], axis=1)
    shell = table["shell_thickness"][0]
    low, high = np.array(extent)
    middle = (low + high) / 2
    figure = plt.figure(figsize=(10, 7.5), layout="constrained")
    cells = figure.add_gridspec(2, 6)
    views = [(2, low[2] + share * (high[2] - low[2]), cells[0, 2 * k:2 * k + 2])
             for k, share in enumerate((0.25, 0.5, 0.75))]
    views += [(1, middle[1], cells[1, :3]), (0, middle[0], cells[1, 3:])]
    for axis, at, cell in views:
        across = [k for k in range(3) if k != axis]
        span = [low[across[0]], high[across[0]], low[across[1]], high[across[1]]]
        image = slice_image(place, table["radius"], shell, axis, at, span)
        if axis == 2 and run.gyratory:
            leave_out_corners(image)
        axes = figure.add_subplot(cell)
        axes.imshow(image, cmap="gray", vmin=0, vmax=1, origin="lower",
                    extent=[1e3 * value for value in span], interpolation="bilinear")
        axes.set_title(f"{'xyz'[axis]} = {1e3 * at:.0f} mm")
        axes.set_xlabel(f"{'xyz'[across[0]]} [mm]")
        axes.set_ylabel(f"{'xyz'[across[1]]} [mm]")
        axes.grid(False)
    figure.suptitle(f"{run.name}: stone bright, binder grey, air black", x=0.01, ha="left")
    return figure
