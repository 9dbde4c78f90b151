# SPDX-License-Identifier: MIT
"""The pictures of docs/landscapes.md from the tables beside this file.

    build/python-venv/bin/python docs/studies/landscapes/pictures.py
"""
import csv
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "landscapes", "svg.fonttype": "none", "font.family": "sans-serif", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
import matplotlib.pyplot as plt  # noqa: E402

HERE = Path(__file__).parent
OUT = HERE.parent.parent / "pictures"
NAMES = {"star-man-travel": "Mr. Star-Man", "beryl-travel": "Beryl Biped", "fred-travel": "Fred", "inchworm-travel": "inchworm", "hopper-jump": "hopper, jump"}
INK, BLUE = "#1f2733", "#2f5fd0"


def rows(name):
    with (HERE / name).open() as file:
        return list(csv.DictReader(file))


def save(figure, name):
    figure.savefig(OUT / name, metadata={"Date": None}, bbox_inches="tight")
    plt.close(figure)


def ends():
    found = rows("ends.csv")
    figure, axes = plt.subplots(2, 5, figsize=(9.5, 3.8), sharex=True)
    for row, kind in zip(axes, ("physical", "timer")):
        for axis, problem in zip(row, NAMES):
            points = [(float(one["by_genes"]), float(one["score"])) for one in found if one["problem"] == problem and one["senses"] == kind]
            axis.scatter(*zip(*points[1:]), s=9, color=INK, linewidths=0)
            axis.scatter(*zip(*points[:1]), s=28, color=BLUE, linewidths=0)
            axis.set_title(f"{NAMES[problem]}, {kind}", fontsize=8)
            axis.set_ylim(bottom=0)
    axes[0][0].set_ylabel("score [m]")
    axes[1][0].set_ylabel("score [m]")
    axes[1][2].set_xlabel("mean difference of genes from the best end (blue)")
    figure.tight_layout()
    save(figure, "landscape-ends.svg")


def measures():
    found = rows("landscapes.csv")
    chosen = ["neutral children, random", "neutral children, good", "autocorrelation, 1 apart", "genes that change the motion", "genes that cost a tenth"]
    figure, axes = plt.subplots(1, len(chosen), figsize=(9.5, 2.6), sharey=True)
    places = [(problem, kind) for problem in NAMES for kind in ("physical", "timer")]
    for axis, measure in zip(axes, chosen):
        for place, (problem, kind) in enumerate(places):
            row = next(one for one in found if (one["problem"], one["senses"], one["measure"]) == (problem, kind, measure))
            colour = BLUE if kind == "timer" else INK
            if row["low"]:
                axis.plot([float(row["low"]), float(row["high"])], [place, place], color=colour, linewidth=2, alpha=0.35)
            axis.plot(float(row["value"]), place, "o", color=colour, markersize=4)
        axis.set_title(measure, fontsize=8)
        axis.set_xlim(0, 1)
    axes[0].set_yticks(range(len(places)), [f"{NAMES[problem]}, {kind}" for problem, kind in places])
    axes[0].invert_yaxis()
    figure.tight_layout()
    save(figure, "landscape-measures.svg")


ends()
measures()
