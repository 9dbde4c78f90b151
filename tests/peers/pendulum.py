# SPDX-License-Identifier: MIT
"""Does the code that trains the policies of docs/studies/policy still learn a known task? Its first row again, with PyTorch:

    python3 tests/peers/pendulum.py
"""
import csv
import sys
from pathlib import Path

import torch

STUDY = Path(__file__).parents[2] / "docs/studies/policy"
GOAL = -200.0  # question.md
sys.dont_write_bytecode = True
sys.path.insert(0, str(STUDY))
from run import pendulum  # noqa: E402

with (STUDY / "pendulum.csv").open(encoding="utf-8") as table:
    reported = next(csv.DictReader(table))["mean_return"]
found = pendulum(1)[0]["mean_return"]
print(f"PyTorch {torch.__version__}: a mean return of {found}, reported {reported}, goal {GOAL:g}")
sys.exit(float(found) < GOAL)
