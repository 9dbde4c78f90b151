# SPDX-License-Identifier: MIT
"""Comparisons of searches on problems (Figure 6 of the paper)."""
from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional

import numpy as np

from . import _core
from .border import Document, json_of, text, threads_or_cores, whole

_TEXT = ("problem", "search", "hash")
_WHOLE = ("seed", "evaluations", "evaluation", "bearers")


class Ranks(NamedTuple):
    u: float  # number of pairs in which the first value is greater [Mann Whitney 1947]
    a12: float  # probability that one of the first sample beats one of the second [Vargha Delaney 2000]
    p: float  # two-sided


class Study:
    """The trials of ``compare``.

    results, curves: the columns of ``gaitsmith compare``'s two files, as arrays by name; the file's text is in
    ``results_csv`` and ``curves_csv``, byte for byte
    """

    def __init__(self, results_csv: str, curves_csv: str) -> None:
        self.results_csv = results_csv
        self.curves_csv = curves_csv
        self.results = _columns(results_csv)
        self.curves = _columns(curves_csv)

    def best(self, problem: str, search: str) -> np.ndarray:
        """The best fitness of each seed (trials,)."""
        chosen = (self.results["problem"] == problem) & (self.results["search"] == search)
        if not chosen.any():
            raise _core.Error(f"study: has no trials of {search!r} on {problem!r}")
        return self.results["best"][chosen]

    def curve(self, problem: str, search: str) -> tuple[np.ndarray, np.ndarray]:
        """Numbers of evaluations (points,), and the best so far of each seed there (trials, points). NaN before the
        first motion that counts."""
        chosen = (self.curves["problem"] == problem) & (self.curves["search"] == search)
        if not chosen.any():
            raise _core.Error(f"study: has no trials of {search!r} on {problem!r}")
        points, column = np.unique(self.curves["evaluation"][chosen], return_inverse=True)
        seeds, row = np.unique(self.curves["seed"][chosen], return_inverse=True)
        best = np.full((len(seeds), len(points)), np.nan)
        best[row, column] = self.curves["best"][chosen]
        return points, best


def _columns(file: str) -> dict[str, np.ndarray]:
    rows = list(csv.reader(io.StringIO(file.split("\n", 1)[1])))
    columns = {}
    for name, values in zip(rows[0], zip(*rows[1:]) if len(rows) > 1 else [()] * len(rows[0])):
        kind = str if name in _TEXT else np.int64 if name in _WHOLE else np.float64
        columns[name] = np.array(values, dtype=kind)
    return columns


def compare(
    problems: Mapping[str, Document],
    searches: Sequence[str],
    trials: int,
    evaluations: int,
    first_seed: int = 1,
    points: Optional[int] = None,
    threads: Optional[int] = None,
) -> Study:
    """Every search on every problem with every seed. The interpreter's lock is released; Ctrl-C stops it.

    problems:    documents by label. Their controllers, timeline and search are not used, but ``search.start``
    searches:    "ALG" or "ALG:OPTION=VALUE:OPTION=VALUE", which are also their labels
    trials:      seeds of each search on each problem, from first_seed on
    evaluations: simulations that each trial may spend
    points:      of each curve, evenly spaced; None: 100, or all if there are fewer evaluations
    threads:     trials at a time; None for all cores. Affects the time, never the results
    """
    if not isinstance(problems, Mapping):
        raise _core.Error(f"problems: must be a dictionary of documents by label, is a {type(problems).__name__}")
    if isinstance(searches, str) or not isinstance(searches, Sequence):
        raise _core.Error("searches: must be a list of texts")
    return Study(
        *_core.compare(
            [(text("problems", label), json_of(document)) for label, document in problems.items()],
            [text("searches", label) for label in searches],
            whole("trials", trials),
            whole("evaluations", evaluations),
            whole("first_seed", first_seed),
            None if points is None else whole("points", points),
            threads_or_cores(threads),
        )
    )


def _numbers(name: str, values: Any) -> list[float]:
    try:
        return [float(value) for value in values]
    except (TypeError, ValueError):
        raise _core.Error(f"{name}: must be numbers") from None


def compare_ranks(first: Any, second: Any) -> Ranks:
    """Compares two samples by ranks, as ``gaitsmith compare --summary`` does. Neither may be empty or have NaN."""
    return Ranks(*_core.compare_ranks(_numbers("first", first), _numbers("second", second)))


def holm_adjusted(p: Any) -> list[float]:
    """p values of one family of comparisons, corrected for testing all of them together [Holm 1979]."""
    return _core.holm_adjusted(_numbers("p", p))
