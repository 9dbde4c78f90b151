# SPDX-License-Identifier: MIT
"""Problems, and evaluations of many genomes at once."""
from __future__ import annotations

import json
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .border import Document, json_of, threads_or_cores, whole


class Evaluations(dict[str, np.ndarray]):
    """Arrays (n,) by name, one number for each genome.

    ``fitness`` (-1e9 if the motion breaks physics), ``travel`` [m], ``max_cm_height`` [m], ``slip_sum`` [m],
    ``rotations``, and the further terms to which the task gives a weight, all float32; where the search is ``nsga-ii``
    its ``cost``, by second and in sizes of the figure or for each joint; ``void`` (bool); and if asked
    for ``hash`` (uint64) of the trajectories. With several worlds or handovers, numbers are means [section 6].
    """


class Problem:
    """A motion-synthesis problem: all that determines a genome's fitness [Fukunaga 1994, sections 2 to 4].

    document: its figure, surroundings, start, pushes, task, senses, rules and search settings define the problem
    Raises Error if the document is not valid.
    """

    def __init__(self, document: Document) -> None:
        self._problem = _core.Problem(json_of(document))

    @property
    def document(self) -> dict[str, Any]:
        """The document, with every field."""
        return json.loads(self._problem.json())

    @property
    def genes(self) -> int:
        """Number of genes of a genome. Each is a uint16 that spans its parameter's range."""
        return self._problem.genes

    def random_genomes(self, count: int, seed: int = 0) -> np.ndarray:
        """Random genomes (count, genes), uint16, as a search would draw them first. seed: 0 to 4294967295."""
        return self._problem.random_genomes(whole("count", count), whole("seed", seed))

    def perturbed(self, genomes: np.ndarray, seed: int = 0) -> np.ndarray:
        """A child (n, genes) of each genome, which differs from it, as hill climbers make them [Fukunaga 1994, section 3]:
        with the document's ``gene_chance``, ``creep``, ``redraw`` and ``dont_care``. seed: 0 to 4294967295, of all."""
        return self._problem.perturbed(genomes, whole("seed", seed))

    def genome_in(self, document: Document, controller: int = 0) -> np.ndarray:
        """The genome (1, genes) of one of a document's controllers, which must fit the problem."""
        return self._problem.genome_in(json_of(document), whole("controller", controller))

    def document_with(self, genome: np.ndarray) -> dict[str, Any]:
        """The document whose motion is this genome's (genes,) or (1, genes)."""
        if isinstance(genome, np.ndarray) and genome.ndim == 1:
            genome = genome[np.newaxis]
        return json.loads(self._problem.document_of(genome))

    def evaluate(self, genomes: np.ndarray, threads: Optional[int] = 1, hashes: bool = False) -> Evaluations:
        """Simulates and scores genomes, without the interpreter's lock and without copying them.

        genomes: C-contiguous uint16 array (n, genes). Do not change it meanwhile
        threads: 1 to 256, None for all cores; affects the time, never the results
        hashes:  whether to compute the trajectories' hashes
        Raises Error if the array has another type, shape or order.
        """
        names, numbers, void, hash_numbers = self._problem.evaluate(genomes, threads_or_cores(threads), bool(hashes))
        result = Evaluations(zip(names, numbers))
        result["void"] = void
        if hashes:
            result["hash"] = hash_numbers
        return result


def as_problem(problem: Union[Problem, Document]) -> Problem:
    return problem if isinstance(problem, Problem) else Problem(problem)


def evaluate(
    problem: Union[Problem, Document], genomes: np.ndarray, threads: Optional[int] = 1, hashes: bool = False
) -> Evaluations:
    """Scores genomes: see Problem.evaluate. A Problem need not be read again at each call, a document must."""
    return as_problem(problem).evaluate(genomes, threads, hashes)
