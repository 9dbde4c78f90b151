# SPDX-License-Identifier: MIT
"""The tables of question.md, with the Python module; pictures.py draws them. Resumable: a problem that has its rows is left out.

    ./dev python && build/python-venv/bin/python docs/studies/landscapes/run.py
"""
import csv
from pathlib import Path

import numpy as np

import gaitsmith

HERE = Path(__file__).parent
PROBLEMS = ("star-man-travel", "beryl-travel", "fred-travel", "inchworm-travel", "hopper-jump")
RANDOM, CHILDREN, WALKS, CLIMBS, GENES = 2301, 2302, 2303, 2301, 2304
LAGS = (1, 2, 5, 10)
TABLE = HERE / "landscapes.csv"
ENDS = HERE / "ends.csv"


def senses_of(document, kind):
    """The problem's document with these senses: a timer keeps the problem's period."""
    changed = dict(document)
    changed["senses"] = {**document["senses"], "kind": kind}
    changed.pop("hash", None)
    return changed


def middle(values):
    """Median and quartiles."""
    return [float(q) for q in np.quantile(np.asarray(values, dtype=float), (0.5, 0.25, 0.75))]


def hashes(problem, genomes):
    return problem.evaluate(genomes, threads=None, hashes=True)["hash"]


def neutrality(problem, parents):
    """For each parent the share of its 20 children that move as it does."""
    own = hashes(problem, parents)
    same = np.zeros((20, len(parents)), dtype=bool)
    for child in range(20):
        same[child] = hashes(problem, problem.perturbed(parents, seed=CHILDREN + 1000 * child)) == own
    return same.mean(axis=0)


def autocorrelations(problem):
    """Of the scores along walks, by lag; void motions count as 0."""
    genomes = problem.random_genomes(40, seed=WALKS)
    scores = []
    for step in range(100):
        found = problem.evaluate(genomes, threads=None)
        scores.append(np.where(found["void"], 0.0, found["fitness"]))
        genomes = problem.perturbed(genomes, seed=WALKS + 1000 * (step + 1))
    walks = np.array(scores).T
    walks = walks - walks.mean()
    variance = (walks**2).mean()
    return [float((walks[:, lag:] * walks[:, :-lag]).mean() / variance) for lag in LAGS]


def climbs(document, problem):
    """The ends of the climbs, best first: genomes and scores."""
    ends = []
    for seed in range(CLIMBS, CLIMBS + 40):
        search = gaitsmith.Search("shc", document, seed=seed, evaluations=4000).run()
        ends.append((search.best_fitness, search.best_genome))
    ends.sort(key=lambda end: -end[0])
    return np.array([genome for _, genome in ends], dtype=np.uint16), np.array([score for score, _ in ends])


def ranks(values):
    order = np.argsort(values, kind="stable")
    place = np.empty(len(values))
    place[order] = np.arange(len(values))
    for value in np.unique(values):
        equal = values == value
        place[equal] = place[equal].mean()
    return place


def spearman(first, second):
    a, b = ranks(first), ranks(second)
    if a.std() == 0.0 or b.std() == 0.0:
        return 0.0
    return float(np.corrcoef(a, b)[0, 1])


def with_interval(scores, distances):
    """Spearman's correlation of scores and distances to the best, without the best, and its bootstrap interval."""
    scores, distances = scores[1:], distances[1:]
    draw = np.random.default_rng(1)
    resampled = []
    for _ in range(1000):
        chosen = draw.integers(0, len(scores), len(scores))
        resampled.append(spearman(scores[chosen], distances[chosen]))
    low, high = np.quantile(resampled, (0.025, 0.975))
    return [spearman(scores, distances), float(low), float(high)]


def behaviour(problem, genomes):
    found = problem.evaluate(genomes, threads=None)
    terms = np.stack([found[name] for name in ("travel", "max_cm_height", "slip_sum", "rotations")], axis=1)
    spread = terms.std(axis=0)
    return terms / np.where(spread > 0.0, spread, 1.0)


def acting(document, problem, genomes):
    """How many rules of each ever decide."""
    counts = []
    for genome in genomes:
        decided = gaitsmith.decisions(problem.document_with(genome))["rule"]
        counts.append(len(set(decided[decided >= 0].tolist())))
    return counts


def mattering(problem, genomes):
    """For each genome the shares of its genes that, drawn again alone, change the motion, and that cost a tenth of the score."""
    draw = np.random.default_rng(GENES)
    changes, costs = [], []
    for genome in genomes:
        genes = len(genome)
        own = problem.evaluate(genome[np.newaxis], hashes=True)
        tried = np.repeat(genome[np.newaxis], 3 * genes, axis=0)
        for i in range(3 * genes):
            tried[i, i // 3] = draw.integers(0, 65536)
        found = problem.evaluate(tried, threads=None, hashes=True)
        changed = (found["hash"] != own["hash"][0]).reshape(genes, 3).any(axis=1)
        worse = (found["fitness"] < 0.9 * own["fitness"][0]).reshape(genes, 3).any(axis=1)
        changes.append(changed.mean())
        costs.append(worse.mean())
    return changes, costs


def rows_of(name, kind):
    document = senses_of(gaitsmith.read(name), kind)
    problem = gaitsmith.Problem(document)
    genomes = problem.random_genomes(200, seed=RANDOM)
    ends, scores = climbs(document, problem)
    good = ends[:20]
    by_genes = np.abs(ends.astype(float) - ends[0].astype(float)).mean(axis=1) / 65535.0
    moves = behaviour(problem, ends)
    by_behaviour = np.sqrt(((moves - moves[0]) ** 2).sum(axis=1))
    with ENDS.open("a", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(
            [name, kind, f"{score:.6g}", f"{near:.6g}", f"{like:.6g}"] for score, near, like in zip(scores, by_genes, by_behaviour)
        )
    changes, costs = mattering(problem, good)
    measures = {
        "neutral children, random": middle(neutrality(problem, genomes)),
        "neutral children, good": middle(neutrality(problem, good)),
        **{f"autocorrelation, {lag} apart": [value, "", ""] for lag, value in zip(LAGS, autocorrelations(problem))},
        "score and distance by genes": with_interval(scores, by_genes),
        "score and distance by behaviour": with_interval(scores, by_behaviour),
        "rules that act, random": middle(acting(document, problem, genomes)),
        "rules that act, good": middle(acting(document, problem, good)),
        "genes that change the motion": middle(changes),
        "genes that cost a tenth": middle(costs),
    }
    return [[name, kind, what, *(f"{number:.4g}" if number != "" else "" for number in numbers)] for what, numbers in measures.items()]


def main():
    done = set()
    if TABLE.exists():
        with TABLE.open() as file:
            done = {(row["problem"], row["senses"]) for row in csv.DictReader(file)}
    else:
        TABLE.write_text("problem,senses,measure,value,low,high\n")
        ENDS.write_text("problem,senses,score,by_genes,by_behaviour\n")
    for name in PROBLEMS:
        for kind in ("physical", "timer"):
            if (name, kind) in done:
                continue
            rows = rows_of(name, kind)
            with TABLE.open("a", newline="") as file:
                csv.writer(file, lineterminator="\n").writerows(rows)
            print(name, kind)


if __name__ == "__main__":
    main()
