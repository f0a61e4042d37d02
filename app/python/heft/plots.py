"""Plots by matplotlib, which is imported only here."""
from __future__ import annotations

import numpy as np


def wrenches(time: np.ndarray, curves: list, axes=None):
    """Forces above torques: `curves` of names and (K, 6) arrays, the first in full colour, the others thin and dark."""
    if axes is None:
        import matplotlib.pyplot as plt
        _, axes = plt.subplots(2, 1, sharex=True, constrained_layout=True)
    colours = ("tab:red", "tab:green", "tab:blue")
    for axis, first, unit in zip(axes, (0, 3), ("force [N]", "torque [N m]")):
        for number, (name, values) in enumerate(curves):
            for channel in range(3):
                label = f"{'xyz'[channel]}, {name}" if channel == 0 or number == 0 else None
                style = {"color": colours[channel], "linewidth": 0.8} if number == 0 else {
                    "color": "black", "linewidth": 0.6, "alpha": 0.7}
                axis.plot(time, values[:, first + channel], label=label, **style)
        axis.set_ylabel(unit)
        axis.grid(alpha=0.3)
    axes[0].legend(loc="upper right", fontsize="small")
    axes[-1].set_xlabel("time [s]")
    return axes
