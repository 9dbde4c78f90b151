# SPDX-License-Identifier: MIT
"""The runs of question.md. Resumable: rows that are there are left out. Needs PyTorch (Debian: python3-torch).

    ./dev python && build/python-venv/bin/python docs/studies/policy/run.py [processes]
"""
from __future__ import annotations

import csv
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from configurations import POLICY, RULES, configurations

HERE = Path(__file__).parent
EPISODE = 10.0                           # s
TUNED, WHOLE = 100_000.0, 400_000.0      # s
TUNING, REPORT = 3101, range(3201, 3206)
WORLDS, PENDULUMS = 64, 32
MOMENTS = (25_000, 50_000, 100_000, 200_000, 400_000)
PENDULUM = {"learning_rate": 3e-4, "discount": 0.95, "entropy": 0.0, "clip": 0.2, "epochs": 10, "horizon": 64, "minibatch": 64, "spread": 1.0}


def written(name: str) -> list[dict[str, str]]:
    path = HERE / name
    return list(csv.DictReader(path.open())) if path.exists() else []


def keep(name: str, rows: list[dict[str, Any]]) -> None:
    path = HERE / name
    fresh = not path.exists()
    with path.open("a", newline="") as out:
        table = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
        if fresh:
            table.writeheader()
        table.writerows(rows)


def pendulum(seed: int) -> list[dict[str, Any]]:
    from pendulum import Pendulums, mean_return
    from ppo import train
    task = Pendulums(PENDULUMS, seed)
    policy = train(task, PENDULUM, seed, 300_000 * task.seconds_per_step, lambda *_: 0.0)
    return [{"seed": seed, "steps": 300_000, "mean_return": f"{mean_return(policy, 100, 1000 + seed):.1f}"}]


def policy(number: int, seed: int, seconds: float) -> list[dict[str, Any]]:
    """Trains one policy. Rows at the moments: best of the mean action so far, best of all episodes, and the mean action's own."""
    from ppo import train
    from walking import Walk
    settings = configurations(POLICY)[number]
    task = Walk(WORLDS, settings["frame_skip"])
    alone = Walk(1, settings["frame_skip"])
    rows: list[dict[str, Any]] = []
    best, best_actions = -np.inf, np.zeros((0, 0), dtype=np.float32)

    def after_update(trained: Any, simulated: float) -> float:
        nonlocal best, best_actions
        way, actions, took = alone.trial(trained)
        if way > best:
            best, best_actions = way, actions
        for moment in MOMENTS:
            if simulated + took >= moment and moment <= seconds and len(rows) <= MOMENTS.index(moment):
                rows.append({"side": "policy", "configuration": number, "seed": seed, "seconds": moment, "metres": f"{best:.4f}", "explored": f"{task.best:.4f}",
                             "now": f"{way:.4f}"})
        return took

    train(task, settings, seed, seconds, after_update)
    if seconds == WHOLE:
        np.savetxt(HERE / f"actions-{seed}.csv", best_actions, fmt="%.9g", delimiter=",", header=f"frame_skip {settings['frame_skip']}")
    return rows


def rules(number: int, seed: int, seconds: float) -> list[dict[str, Any]]:
    """One search. Its metres are those of its best motion so far, so the three columns are equal."""
    import gaitsmith
    search = gaitsmith.Search("sphc", gaitsmith.read("star-man-travel"), seed=seed, evaluations=int(seconds / EPISODE), options=configurations(RULES)[number])
    search.run(threads=1)
    rows = []
    for moment in (each for each in MOMENTS if each <= seconds):
        metres = f"{search.curve['best'][search.curve['evaluation'] * EPISODE <= moment].max():.4f}"
        rows.append({"side": "rules", "configuration": number, "seed": seed, "seconds": moment, "metres": metres, "explored": metres, "now": metres})
    return rows


def timed(side: Any, number: int, seed: int, seconds: float) -> tuple[list[dict[str, Any]], float]:
    """A run and its processor seconds, which no run repeats exactly."""
    start = time.process_time()
    return side(number, seed, seconds), time.process_time() - start


def best_of(rows: list[dict[str, str]], side: str) -> int:
    """The configuration with the most metres at the end of its tuning run."""
    ends = [row for row in rows if row["side"] == side and float(row["seconds"]) == TUNED]
    return int(max(ends, key=lambda row: float(row["metres"]))["configuration"])


def missing(name: str, jobs: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    there = {(row["side"], int(row["configuration"]), int(row["seed"])) for row in written(name)}
    return [job for job in jobs if (job[0].__name__, *job[1:3]) not in there]


def run_all(name: str, jobs: list[tuple[Any, ...]], processes: int) -> None:
    """Runs what is missing, and writes the rows of each run when it ends, in the order of the jobs."""
    left = missing(name, jobs)
    with ProcessPoolExecutor(processes) as pool:
        waiting = [pool.submit(timed, *job) for job in left]
        for job, one in zip(left, waiting):
            rows, took = one.result()
            keep(name, rows)
            keep("processor.csv", [{"table": name.removesuffix(".csv"), "side": job[0].__name__, "configuration": job[1], "seed": job[2], "processor_s": f"{took:.0f}"}])
            print(name, *job[1:], flush=True)


def main() -> None:
    processes = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    known = {int(row["seed"]) for row in written("pendulum.csv")}
    for seed in range(1, 6):
        if seed not in known:
            keep("pendulum.csv", pendulum(seed))
    run_all("tuning.csv", [(side, number, TUNING, TUNED) for side in (rules, policy) for number in range(20)], processes)
    chosen = written("tuning.csv")
    run_all("report.csv", [(side, best_of(chosen, side.__name__), seed, WHOLE) for side in (rules, policy) for seed in REPORT], processes)


if __name__ == "__main__":
    main()
