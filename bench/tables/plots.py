# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Line plots as SVG, readable in print, without colour, and by the colour-blind."""

import sys

try:
    import matplotlib
except ImportError:
    sys.exit("python3-matplotlib is missing: install it by scripts/install_packages.sh tables and "
             "run the tables with /usr/bin/python3")

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "isomatch", "svg.fonttype": "none", "font.size": 10,
                            "font.family": "sans-serif", "axes.spines.top": False,
                            "axes.spines.right": False, "legend.frameon": False})

from matplotlib import pyplot  # noqa: E402, after the choice of a backend.

# Okabe and Ito's colours, and a marker for each, so that neither needs the other.
STYLES = (("#D55E00", "o"), ("#0072B2", "s"), ("#009E73", "^"), ("#CC79A7", "D"), ("#E69F00", "v"),
          ("#56B4E9", "P"))


def line_plot(path, lines, x_label, y_label, title, limits=None, markers=10):
    """`lines`: title to (x, y, dash), where lines of the same title before " (" share a style;
    `limits`: keyword arguments of `Axes.set`; `markers`: about how many on each line."""
    figure, axes = pyplot.subplots(figsize=(7, 4.2))
    names = list(dict.fromkeys(name.split(" (")[0] for name in lines))
    for name, (x, y, dash) in lines.items():
        color, marker = STYLES[names.index(name.split(" (")[0]) % len(STYLES)]
        axes.plot(x, y, dash, color=color, marker=marker, markersize=5, linewidth=1.6, label=name,
                  markevery=max(1, len(x) // markers))
    axes.set(xlabel=x_label, ylabel=y_label, title=title, **(limits or {}))
    axes.grid(color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)
