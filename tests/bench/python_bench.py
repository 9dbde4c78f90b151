# SPDX-License-Identifier: MIT
"""Evaluations per second from Python against the native evaluator_bench, in turn in one run, on one core. The same 64
genomes: random controllers of Mr. Star-Man. Counts processor time, so that other programs matter less. Writes
build/bench-python.json, which report.mjs judges. ./dev bench runs it once the wheel is there.

    ./dev python && cmake --build --preset release --target evaluator_bench
    build/python-venv/bin/python tests/bench/python_bench.py [rounds]
"""
import json
import statistics
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import gaitsmith

ROOT = Path(__file__).parents[2]
SECONDS = 0.5  # of each measurement


def native() -> float:
    words = ["--benchmark_filter=^Evaluate/physical / random/lanes:4$", f"--benchmark_min_time={SECONDS}", "--benchmark_format=json"]
    found = subprocess.run([str(ROOT / "build/release/tests/bench/evaluator_bench"), *words], check=True, capture_output=True, text=True)
    return json.loads(found.stdout)["benchmarks"][0]["items_per_second"]


def rate(call, items: int) -> float:
    """Items for each second of this process."""
    start, calls = time.process_time(), 0
    while time.process_time() - start < SECONDS:
        call()
        calls += 1
    return calls * items / (time.process_time() - start)


def main(rounds: int) -> None:
    problem = gaitsmith.Problem(gaitsmith.document(figure="mr-star-man"))
    genomes = gaitsmith.Search("rgt", problem, seed=1).ask(64)
    env = gaitsmith.VectorEnv(problem, 64, "state")
    env.reset()
    action = env.action_space.sample()
    rows = []
    for _ in range(rounds):
        rows.append((native(), rate(lambda: problem.evaluate(genomes), 64), rate(lambda: env.step(action), 64)))
    one, other, steps = (statistics.median(column) for column in zip(*rows))
    ratios = np.array([row[1] / row[0] for row in rows])
    print(f"native {one:.0f}/s, Python {other:.0f}/s: {statistics.median(ratios):.3f} of it ({ratios.min():.3f} to {ratios.max():.3f})")
    print(f"VectorEnv of 64 worlds: {steps:.0f} steps/s")
    found = {"native": one, "python": other, "overNative": statistics.median(ratios), "rounds": ratios.tolist(), "worldStepsPerSecond": steps}
    (ROOT / "build/bench-python.json").write_text(json.dumps(found) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 7)
