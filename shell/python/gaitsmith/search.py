# SPDX-License-Identifier: MIT
"""Searches with an ask/tell interface."""
from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .border import Document, json_of, option_values, text, threads_or_cores, whole
from .problem import Evaluations, Problem


class Search:
    """A search for a document's controller. Its result depends on its settings alone, neither on how many genomes are
    asked for at a time nor on threads. Threads may share it.

    algorithm:   such as "sphc" [Fukunaga 1994, Figure 5] or "cma-es"; None: the document's
    problem:     a Problem or a document; its ``search`` holds the settings that are not given here
    seed:        0 to 4294967295; None: the document's
    evaluations: simulations that it may spend; None: the document's
    options:     by the names of --search-option, such as {"cma.step": 0.2}
    Raises Error for names and numbers that are wrong.

    >>> search = Search("cma-es", problem, seed=1)
    >>> while not search.done:
    ...     search.tell(search.problem.evaluate(search.ask()))
    """

    def __init__(
        self,
        algorithm: Optional[str],
        problem: Union[Problem, Document],
        seed: Optional[int] = None,
        evaluations: Optional[int] = None,
        options: Optional[Mapping[str, Any]] = None,
    ) -> None:
        if options is not None and not isinstance(options, Mapping):
            raise _core.Error(f"options: must be a dictionary, is a {type(options).__name__}")
        self._search = _core.Search(
            json_of(problem),
            None if algorithm is None else text("algorithm", algorithm),
            None if seed is None else whole("seed", seed),
            None if evaluations is None else whole("evaluations", evaluations),
            option_values("options", options or {}),
        )
        self._problem: Optional[Problem] = None

    @property
    def problem(self) -> Problem:
        """The problem with these settings. Some, such as ``worlds`` and ``body``, change what genomes mean."""
        if self._problem is None:
            self._problem = Problem(json.loads(self._search.json()))
        return self._problem

    def ask(self, wanted: int = 64) -> np.ndarray:
        """The next genomes to evaluate, uint16 (n, genes): about ``wanted``, fewer where later ones depend on scores that
        are missing, none (0, genes) once the budget is spent. Raises Error until the last ones have their scores."""
        return self._search.ask(whole("wanted", wanted))

    def tell(self, scores: Union[Evaluations, np.ndarray, list]) -> None:
        """Passes the scores of the last ask, in its order.

        scores: what ``evaluate`` returned, or fitness (n,). MAP-Elites, CMA-MAE and NSGA-II need the former. NaN ranks below all
        """
        if isinstance(scores, Mapping):
            style = [scores.get(name) for name in ("max_cm_height", "slip_sum", "rotations")]
            if "fitness" not in scores:
                raise _core.Error("scores: have no fitness")
            have_style = all(term is not None for term in style)
            self._search.tell(scores["fitness"], np.stack(style, axis=1) if have_style else None, scores.get("cost"))
        else:
            self._search.tell(scores, None, None)

    def run(self, threads: Optional[int] = None) -> Search:
        """Runs the search to its end natively. threads: None for all cores. Ctrl-C ends it early; it can go on."""
        self._search.run(threads_or_cores(threads))
        return self

    def document(self) -> dict[str, Any]:
        """The document with the best controller as its motion, as ``gaitsmith synthesize`` writes it."""
        return json.loads(self._search.found())

    def save(self) -> bytes:
        """The state between a tell and an ask."""
        return self._search.save()

    def load(self, state: bytes) -> None:
        """Goes on from a saved state of a search with the same settings. Raises Error if it is damaged."""
        if not isinstance(state, bytes):
            raise _core.Error(f"state: must be bytes, is a {type(state).__name__}")
        self._search.load(state)

    @property
    def done(self) -> bool:
        return self._search.done()

    @property
    def evaluations(self) -> int:
        """Evaluations that the serial algorithm would have made by now."""
        return self._search.evaluations()

    @property
    def best_fitness(self) -> float:
        return self._search.best_fitness()

    @property
    def best_genome(self) -> Optional[np.ndarray]:
        """The best genome so far (genes,), or None before the first tell."""
        return self._search.best_genome()

    @property
    def curve(self) -> dict[str, np.ndarray]:
        """``evaluation`` (from 1) and ``best``: a point for every improvement."""
        evaluation, best = self._search.curve()
        return {"evaluation": evaluation, "best": best}

    @property
    def population(self) -> np.ndarray:
        """Fitness of the present population, for display. Empty where an algorithm has none."""
        return np.array(self._search.population(), dtype=np.float32)


def synthesize(document: Union[Problem, Document], threads: Optional[int] = None) -> dict[str, Any]:
    """Runs the search of a document, and returns the document that ``gaitsmith synthesize`` would write."""
    return Search(None, document).run(threads).document()
