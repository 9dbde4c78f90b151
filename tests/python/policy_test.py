# SPDX-License-Identifier: MIT
"""Rows of docs/studies/policy, computed again: without PyTorch, since a policy's best actions are kept."""
import csv
import sys
import unittest

import numpy as np

import gaitsmith
from repository import ROOT

STUDY = ROOT / "docs/studies/policy"
FIRST = 3201


def row(side, seconds):
    with (STUDY / "report.csv").open(encoding="utf-8") as table:
        return next(one for one in csv.DictReader(table) if one["side"] == side and int(one["seed"]) == FIRST and int(one["seconds"]) == seconds)


@unittest.skipUnless((STUDY / "report.csv").is_file(), "the study has not ended")
class Policy(unittest.TestCase):
    def test_actions_of_the_best_policy_go_as_far_as_reported(self):
        path = STUDY / f"actions-{FIRST}.csv"
        frame_skip = int(path.read_text(encoding="utf-8").split("frame_skip ")[1].split("\n")[0])
        problem = gaitsmith.read("star-man-travel")
        env = gaitsmith.Env(problem, observation="state", frame_skip=frame_skip, tau=problem["senses"]["tau_min_s"])
        env.reset()
        way = 0.0
        for action in np.loadtxt(path, delimiter=",", dtype=np.float32):
            _, reward, terminated, truncated, _ = env.step(action)
            way += reward
        self.assertFalse(terminated)
        self.assertTrue(truncated)
        self.assertEqual(f"{way:.4f}", row("policy", 400000)["metres"])

    def test_rules_get_as_far_as_reported(self):
        sys.path.insert(0, str(STUDY))
        self.addCleanup(sys.path.remove, str(STUDY))
        from configurations import RULES, configurations

        reported = row("rules", 25000)
        search = gaitsmith.Search("sphc", gaitsmith.read("star-man-travel"), seed=FIRST, evaluations=2500, options=configurations(RULES)[int(reported["configuration"])])
        self.assertEqual(f"{search.run().best_fitness:.4f}", reported["metres"])


if __name__ == "__main__":
    unittest.main()
