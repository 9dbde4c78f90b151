# SPDX-License-Identifier: MIT
"""Evaluations, searches and comparisons find what the command line finds."""
import csv
import json
import signal
import tempfile
import threading
import time
import tracemalloc
import unittest
from pathlib import Path

import numpy as np
from repository import ROOT, command_line

import gaitsmith


def synthesized(*words: str) -> dict:
    return json.loads(command_line("synthesize", *words, "--threads", "1", "--out", "-"))


class Evaluating(unittest.TestCase):
    def setUp(self):
        self.problem = gaitsmith.Problem(gaitsmith.read("star-man-travel"))

    def test_threads_change_no_bit(self):
        genomes = self.problem.random_genomes(41, seed=3)
        one, two = (self.problem.evaluate(genomes, threads=threads, hashes=True) for threads in (1, 2))
        self.assertEqual(list(one), ["fitness", "travel", "max_cm_height", "slip_sum", "rotations", "void", "hash"])
        for name in one:
            np.testing.assert_array_equal(one[name], two[name])
        self.assertEqual(one["fitness"].dtype, np.float32)
        self.assertEqual(one["hash"].dtype, np.uint64)
        np.testing.assert_array_equal(one["void"], one["fitness"] == -1e9)

    def test_hash_is_that_of_the_document(self):
        genomes = self.problem.random_genomes(3)
        found = gaitsmith.evaluate(self.problem, genomes, hashes=True)
        for i in range(3):
            document = self.problem.document_with(genomes[i])
            self.assertEqual(document["hash"], f"{found['hash'][i]:016x}")
            self.assertEqual(gaitsmith.simulate(document).hash, document["hash"])
            np.testing.assert_array_equal(self.problem.genome_in(document)[0], genomes[i])

    def test_weighted_terms_are_measured(self):
        document = gaitsmith.document(problem="star-man-travel", weight={"upright": 5})
        found = gaitsmith.evaluate(document, gaitsmith.Problem(document).random_genomes(4))
        self.assertIn("upright", found)
        fine = ~found["void"]
        np.testing.assert_allclose(found["fitness"][fine], np.abs(found["travel"][fine]) + 5 * found["upright"][fine], rtol=1e-6)

    def test_parts_of_arrays_give_their_rows(self):
        genomes = self.problem.random_genomes(8)
        np.testing.assert_array_equal(self.problem.evaluate(genomes[2:5])["fitness"], self.problem.evaluate(genomes)["fitness"][2:5])
        self.assertEqual(len(self.problem.evaluate(genomes[:0])["fitness"]), 0)

    def test_genomes_are_not_copied(self):
        genomes = self.problem.random_genomes(2000)
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        found = self.problem.evaluate(genomes)
        most = tracemalloc.get_traced_memory()[1] - sum(column.nbytes for column in found.values())
        self.assertLess(most, genomes.nbytes / 4)
        tracemalloc.reset_peak()
        copy = genomes.copy()  # what the limit would notice
        self.assertGreater(tracemalloc.get_traced_memory()[1], copy.nbytes)

    def test_wrong_arrays_are_named(self):
        genomes, genes = self.problem.random_genomes(4), self.problem.genes
        for wrong, words in [
            (genomes.astype(float), rf"shape \(n, {genes}\), is float64 with shape \(4, {genes}\)"),
            (genomes.astype(np.int16), "is int16"),
            (genomes.astype(">u2"), "is >u2"),
            (genomes[:, :-1], f"with shape \\(4, {genes - 1}\\)"),
            (genomes[0], "with shape"),
            (genomes[::2], "in another order"),
            (np.asfortranarray(genomes), "in another order"),
            (genomes.tolist(), "is a list"),
            (None, "is a NoneType"),
        ]:
            with self.subTest(words), self.assertRaisesRegex(gaitsmith.Error, words):
                self.problem.evaluate(wrong)
        for threads in (0, 257, -1, 1 << 70, 1.5, "2"):
            with self.subTest(threads), self.assertRaisesRegex(gaitsmith.Error, "threads"):
                self.problem.evaluate(genomes, threads=threads)
        with self.assertRaisesRegex(gaitsmith.Error, "count"):
            self.problem.random_genomes(0)
        with self.assertRaisesRegex(gaitsmith.Error, "seed"):
            self.problem.random_genomes(1, seed=-1)
        with self.assertRaisesRegex(gaitsmith.Error, "has another kind"):
            self.problem.genome_in(gaitsmith.read("star-man-network"))

    def test_lock_is_released(self):
        genomes = self.problem.random_genomes(1000)
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(time.monotonic())

        ticker = threading.Thread(target=tick)
        ticker.start()
        self.problem.evaluate(genomes)
        done.set()
        ticker.join()
        self.assertGreater(len(ticks), 5)

    def test_interrupts_end_it(self):
        def raise_interrupt(number, frame):
            raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, raise_interrupt)
        try:
            for call in (
                lambda: self.problem.evaluate(np.tile(self.problem.random_genomes(1000), (100, 1)), threads=2),
                lambda: gaitsmith.Search("sphc", self.problem, evaluations=10_000_000).run(),
                lambda: gaitsmith.compare({"a": self.problem.document}, ["rgt"], trials=3, evaluations=10_000_000),
            ):
                signal.setitimer(signal.ITIMER_REAL, 0.3)
                with self.assertRaises(KeyboardInterrupt):
                    call()
        finally:
            signal.signal(signal.SIGALRM, before)


class Searching(unittest.TestCase):
    WORDS = {
        "sphc": {}, "cma-es": {}, "ssga": {"genetic.population": 50}, "rgt": {}, "shc": {}, "map-elites": {}, "pose-cycle": {},
        "mpga": {"torus.side": 8}, "nelder-mead": {}, "two-stage": {"two_stage.random": 100},
        "de": {"difference.population": 20}, "nsga-ii": {"genetic.population": 50}, "cma-mae": {},
    }

    def test_children_differ_and_are_the_same_for_a_seed(self):
        problem = gaitsmith.Problem(gaitsmith.document(problem="star-man-travel"))
        genomes = problem.random_genomes(50, seed=3)
        children = problem.perturbed(genomes, seed=9)
        self.assertEqual((children.shape, children.dtype), (genomes.shape, genomes.dtype))
        self.assertTrue((children != genomes).any(axis=1).all())
        np.testing.assert_array_equal(children, problem.perturbed(genomes, seed=9))
        self.assertFalse((children == problem.perturbed(genomes, seed=10)).all())
        # About gene_chance of the genes that act on a target move; ignored senses mostly stay ignored.
        self.assertLess((children != genomes).mean(), 0.25)
        with self.assertRaisesRegex(gaitsmith.Error, "seed"):
            problem.perturbed(genomes, seed=-1)

    def test_asking_and_telling_finds_what_synthesize_finds(self):
        for algorithm, options in self.WORDS.items():
            words = [word for option in options.items() for word in ("--search-option", "=".join(map(str, option)))]
            expected = synthesized("--problem", "inchworm-travel", "--search", algorithm, "--evaluations", "600", "--seed", "5", *words)
            for wanted, threads in ((64, 1), (7, 2)):
                with self.subTest(algorithm=algorithm, wanted=wanted):
                    search = gaitsmith.Search(algorithm, gaitsmith.document(problem="inchworm-travel"), seed=5, evaluations=600, options=options)
                    while not search.done:
                        search.tell(search.problem.evaluate(search.ask(wanted), threads=threads))
                    self.assertEqual(search.document(), expected)
                    self.assertEqual(search.ask().shape, (0, search.problem.genes))

    def test_running_finds_the_same_with_any_threads(self):
        expected = synthesized("--problem", "star-man-travel", "--evaluations", "400")
        for threads in (1, 2):
            document = gaitsmith.document(problem="star-man-travel", evaluations=400)
            self.assertEqual(gaitsmith.synthesize(document, threads), expected)

    def test_limited_joints_worlds_bodies_and_starts(self):
        with tempfile.TemporaryDirectory() as folder:
            start = Path(folder) / "start.json"
            start.write_text(json.dumps(synthesized("--problem", "star-man-travel", "--evaluations", "50")))
            for options in (
                {"problem": "star-man-travel", "joints": "limited"},
                {"problem": "star-man-travel", "search_option": {"worlds": 3}},
                {"problem": "star-man-travel", "search_option": {"body": "little"}},
                {"from_": start},
                {"problem": "star-man-travel", "handover": f"{start}@1.5"},
            ):
                with self.subTest(options):
                    words = []
                    for name, value in options.items():
                        value = "=".join(map(str, *value.items())) if isinstance(value, dict) else str(value)
                        words += ["--" + name.rstrip("_").replace("_", "-"), value]
                    expected = synthesized(*words, "--evaluations", "120")
                    search = gaitsmith.Search(None, gaitsmith.document(**options), evaluations=120)
                    while not search.done:
                        search.tell(search.problem.evaluate(search.ask()))
                    self.assertEqual(search.document(), expected)

    def test_curve_and_best(self):
        search = gaitsmith.Search("cma-es", gaitsmith.read("hopper-jump"), evaluations=300)
        self.assertIsNone(search.best_genome)
        with self.assertRaisesRegex(gaitsmith.Error, "has found nothing yet"):
            search.document()
        search.run(threads=2)
        self.assertEqual(search.evaluations, 300)
        self.assertEqual(search.curve["best"][-1], np.float32(search.best_fitness))
        self.assertEqual(search.problem.evaluate(search.best_genome[np.newaxis])["fitness"][0], np.float32(search.best_fitness))

    def test_saved_searches_go_on(self):
        document = gaitsmith.read("inchworm-travel")
        whole, first, second = (gaitsmith.Search("sphc", document, evaluations=300) for _ in range(3))
        whole.run()
        first.tell(first.problem.evaluate(first.ask(10)))
        second.load(first.save())
        second.run()
        self.assertEqual(second.document(), whole.document())
        state = first.save()
        for damaged in (b"", state[: len(state) // 2], bytes(200)):
            with self.subTest(len(damaged)):
                try:
                    first.load(damaged)
                except gaitsmith.Error:
                    pass
                self.assertIsInstance(first.evaluations, int)
        with self.assertRaisesRegex(gaitsmith.Error, "state: must be bytes"):
            first.load("text")

    def test_wrong_order_and_numbers_are_named(self):
        document = gaitsmith.read("inchworm-travel")
        search = gaitsmith.Search("sphc", document)
        genomes = search.ask(5)
        for call, words in [
            (lambda: search.ask(), "to tell first"),
            (lambda: search.run(), "to tell first"),
            (lambda: search.save(), "to tell first"),
            (lambda: search.tell([1.0]), f"fitness: must be {len(genomes)} numbers"),
            (lambda: search.tell("abc"), "fitness: must be numbers"),
            (lambda: search.tell(np.zeros((2, 2))), "has shape"),
            (lambda: search.tell({}), "have no fitness"),
            (lambda: search.ask(0), "wanted: must be from 1"),
            (lambda: gaitsmith.Search("sphd", document), "sphc"),
            (lambda: gaitsmith.Search("sphc", document, seed=-1), "seed: must be from 0"),
            (lambda: gaitsmith.Search("sphc", document, evaluations=0), "evaluations: must be from 1"),
            (lambda: gaitsmith.Search("sphc", document, options={"cma.stp": 1}), "cma.stp"),
            (lambda: gaitsmith.Search("sphc", document, options=["a"]), "must be a dictionary"),
            (lambda: gaitsmith.Search("gga", document, evaluations=10), "population"),
        ]:
            with self.subTest(words), self.assertRaisesRegex(gaitsmith.Error, words):
                call()
        search.tell(np.full(len(genomes), np.nan))
        with self.assertRaisesRegex(gaitsmith.Error, "no genomes have been asked for"):
            search.tell([])

    def test_threads_may_share_a_search(self):
        search = gaitsmith.Search("rgt", gaitsmith.read("inchworm-travel"), evaluations=200)
        problem = search.problem

        def work():
            while not search.done:
                try:
                    search.tell(problem.evaluate(search.ask(8)))
                except gaitsmith.Error:  # another thread has asked
                    pass

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(search.done)


class Comparing(unittest.TestCase):
    def test_files_are_those_of_the_command_line(self):
        labels = ["sphc", "ssga:genetic.population=20"]
        study = gaitsmith.compare(
            {name: gaitsmith.read(name) for name in ("inchworm-travel", "hopper-jump")}, labels, trials=3, evaluations=60, points=6
        )
        with tempfile.TemporaryDirectory() as folder:
            out, curves = Path(folder) / "r.csv", Path(folder) / "c.csv"
            command_line(
                "compare", "--problem", "inchworm-travel", "--problem", "hopper-jump", "--search", labels[0], "--search", labels[1],
                "--trials", "3", "--evaluations", "60", "--points", "6", "--out", str(out), "--curves", str(curves),
            )
            self.assertEqual(study.results_csv, out.read_text())
            self.assertEqual(study.curves_csv, curves.read_text())
        points, best = study.curve("hopper-jump", "sphc")
        self.assertEqual(best.shape, (3, 6))
        np.testing.assert_array_equal(points, [10, 20, 30, 40, 50, 60])
        np.testing.assert_array_equal(best[:, -1], study.best("hopper-jump", "sphc"))
        with self.assertRaisesRegex(gaitsmith.Error, "has no trials"):
            study.best("hopper-jump", "cma-es")

    def test_a_cell_of_figure_6_is_that_of_the_study(self):
        with (ROOT / "docs/studies/searches/hopper-jump-physical.csv").open(encoding="utf-8") as table:
            rows = csv.DictReader(line for line in table if not line.startswith("#"))
            reported = next(row["best"] for row in rows if (row["search"], row["seed"]) == ("sphc", "1"))
        study = gaitsmith.compare({"hopper-jump": gaitsmith.read("hopper-jump")}, ["sphc"], trials=1, evaluations=40000)
        self.assertEqual(f"{study.best('hopper-jump', 'sphc')[0]:.9g}", reported)

    def test_ranks(self):
        self.assertEqual(gaitsmith.compare_ranks([3, 4], [1, 2])[:2], (4.0, 1.0))
        self.assertEqual(gaitsmith.compare_ranks([1], [1]).p, 1.0)
        self.assertEqual(gaitsmith.holm_adjusted([0.01, 0.04]), [0.02, 0.04])
        for first in ([], [float("nan")], ["a"], 3):
            with self.subTest(first), self.assertRaisesRegex(gaitsmith.Error, "first"):
                gaitsmith.compare_ranks(first, [1])

    def test_wrong_studies_are_named(self):
        problem = gaitsmith.read("hopper-jump")
        for problems, searches, numbers, words in [
            ({}, ["rgt"], {}, "problems: must have at least one"),
            ([problem], ["rgt"], {}, "must be a dictionary"),
            ({"a b": problem}, ["rgt"], {}, "cannot be a label"),
            ({"a": problem}, [], {}, "searches"),
            ({"a": problem}, "rgt", {}, "must be a list"),
            ({"a": problem}, ["rgt", "rgt"], {}, "is there twice"),
            ({"a": problem}, ["rgd"], {}, "rgt"),
            ({"a": problem}, ["rgt"], {"trials": 0}, "trials"),
            ({"a": problem}, ["rgt"], {"points": 11}, "points"),
            ({"a": problem}, ["rgt"], {"first_seed": 1 << 32}, "first_seed"),
        ]:
            with self.subTest(words), self.assertRaisesRegex(gaitsmith.Error, words):
                gaitsmith.compare(problems, searches, **{"trials": 1, "evaluations": 10, **numbers})


if __name__ == "__main__":
    unittest.main()
