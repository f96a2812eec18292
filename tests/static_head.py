"""What a run's recorded means of force and moment bend the full FE head by, statically."""
import numpy as np


def angle_lost(history, summary):
    """Of a head that gyrates at 0.5 rev/s with rows every 10 ms [rad]."""
    angle = np.radians(history["commanded_angle"])
    # A row's means belong to the middle of its interval, half of 10 ms before its end.
    phase = 2 * np.pi * (history["gyration"] - 0.5 * 0.01 * 0.5)
    # Forces in the tilted frame of the head: the axial force bends the shaft too.
    force_x = history["head_lateral_x"] - history["head_force"] * angle * np.cos(phase)
    force_y = history["head_lateral_y"] - history["head_force"] * angle * np.sin(phase)
    per_moment = summary["head_tilt_per_moment_rad_per_Nm"]
    per_force = summary["head_tilt_per_force_rad_per_N"]
    about_x = per_moment * history["head_moment_x"] - per_force * force_y
    about_y = per_moment * history["head_moment_y"] + per_force * force_x
    return angle - np.hypot(-angle * np.sin(phase) + about_x, angle * np.cos(phase) + about_y)
