# SPDX-License-Identifier: MIT
"""Motions and documents have the bits of the command line."""
import csv
import io
import json
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
from repository import ROOT, command_line, motions

import gaitsmith


class Motions(unittest.TestCase):
    def test_module_is_that_of_the_wheel(self):
        self.assertNotIn(ROOT / "shell", Path(gaitsmith.__file__).parents)
        self.assertEqual(gaitsmith.__version__, command_line("version").split()[1])

    def test_hashes_are_those_of_the_documents(self):
        for path in motions():
            with self.subTest(path.name):
                document = json.loads(path.read_text())
                self.assertEqual(gaitsmith.simulate(document).hash, document["hash"])

    def test_columns_are_those_of_the_command_line(self):
        for name in ("star-man-composite", "star-man-network", "fred-falls"):
            path = ROOT / f"tests/golden/motions/{name}.json"
            rows = list(csv.reader(io.StringIO(command_line("simulate", str(path)))))
            motion = gaitsmith.simulate(gaitsmith.read(path))
            self.assertEqual(list(motion), rows[0])
            numbers = np.array(rows[1:], dtype=np.float64)
            for i, column in enumerate(rows[0]):
                single = not (column in ("x", "y") or column.startswith("node"))
                with self.subTest(name=name, column=column):
                    if single and column not in ("t", "phi", "rule"):
                        np.testing.assert_array_equal(motion[column].astype(np.float32), numbers[:, i].astype(np.float32))
                    else:
                        np.testing.assert_allclose(motion[column], numbers[:, i], rtol=1e-8 if single else 0, atol=0)

    def test_terms_are_those_of_measure(self):
        path = ROOT / "tests/golden/motions/hopper-jump.json"
        names, values = csv.reader(io.StringIO(command_line("measure", str(path))))
        terms = gaitsmith.measure(gaitsmith.read(path))
        self.assertEqual(set(terms) | {"hash"}, set(names))
        for name, value in zip(names, values):
            if name != "hash":
                self.assertEqual(np.float32(terms[name]), np.float32(value), name)

    def test_decisions_are_those_of_senses(self):
        path = ROOT / "tests/golden/motions/star-man-physical.json"
        rows = list(csv.reader(io.StringIO(command_line("senses", str(path)))))
        numbers = np.array(rows[1:], dtype=np.float32)
        found = gaitsmith.decisions(gaitsmith.read(path))
        joined = np.hstack([found[name] for name in ("senses", "target", "inverse_tau", "decay")])
        np.testing.assert_array_equal(joined, numbers[:, 3:])
        np.testing.assert_array_equal(found["step"], numbers[:, 0])
        np.testing.assert_array_equal(found["rule"], numbers[:, 2])

    def test_threads_may_simulate_together(self):
        document = gaitsmith.read("star-man-shuffle")
        hashes = []
        threads = [threading.Thread(target=lambda: hashes.append(gaitsmith.simulate(document).hash)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(hashes, [document["hash"]] * 4)


class Documents(unittest.TestCase):
    def test_files_and_links_come_back(self):
        document = gaitsmith.read(ROOT / "examples/star-man-shuffle.json")
        self.assertEqual(gaitsmith.decode_link(gaitsmith.encode_link(document)), document)
        self.assertEqual(gaitsmith.complete(document), document)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "motion.json"
            gaitsmith.write(document, path)
            self.assertEqual(path.read_bytes(), (ROOT / "examples/star-man-shuffle.json").read_bytes())

    def test_link_is_that_of_the_command_line(self):
        document = gaitsmith.read("star-man-shuffle")
        self.assertEqual(gaitsmith.encode_link(document), command_line("link", "encode", "star-man-shuffle").strip())

    def test_short_documents_are_completed(self):
        short = {"figure": {"name": "Tail", "rods": [{"parent": -1}, {"parent": 0, "rest_rad": np.float32(0.3)}]}}
        try:
            document = gaitsmith.complete(short)
        except gaitsmith.Error as fault:
            self.assertNotIn("parent", str(fault))  # whatever it lacks, it says what
        else:
            self.assertEqual(np.float32(document["figure"]["rods"][1]["rest_rad"]), np.float32(0.3))

    def test_options_are_those_of_synthesize(self):
        document = gaitsmith.document(
            figure="ostrich", task="jump", sense="timer=0.6", duration=4, joints="limited", weight={"slip_sum": "usual"},
            search="cma-es", search_option={"cma.step": 0.2, "worlds": 2}, seed=7, evaluations=10,
        )
        found = json.loads(command_line(
            "synthesize", "--figure", "ostrich", "--task", "jump", "--sense", "timer=0.6", "--duration", "4", "--joints", "limited",
            "--weight", "slip_sum=usual", "--search", "cma-es", "--search-option", "cma.step=0.2", "--search-option", "worlds=2",
            "--seed", "7", "--evaluations", "10", "--out", "-",
        ))
        self.assertEqual(gaitsmith.synthesize(document), found)

    def test_tables(self):
        self.assertEqual(gaitsmith.catalogue(), json.loads(command_line("catalogue")))
        self.assertEqual(gaitsmith.style_terms()[0]["name"], "max_cm_height")

    def test_faults_are_sentences(self):
        document = gaitsmith.read("star-man-shuffle")
        document["figure"]["rods"][2]["length_m"] = -1
        for call, words in [
            (lambda: gaitsmith.simulate(document), "figure.rods[2].length_m: must be from"),
            (lambda: gaitsmith.simulate({"figur": 1}), "figur"),
            (lambda: gaitsmith.simulate([]), "document: must be a dictionary, is a list"),
            (lambda: gaitsmith.simulate({"title": {1, 2}}), "cannot be written as JSON"),
            (lambda: gaitsmith.simulate({"title": float("nan")}), ""),
            (lambda: gaitsmith.read("no-such-motion"), "no-such-motion"),
            (lambda: gaitsmith.read(3), "name: must be text"),
            (lambda: gaitsmith.read("-"), "command line only"),
            (lambda: gaitsmith.read("\ud800"), "not well-formed"),
            (lambda: gaitsmith.decode_link("AAAA"), ""),
            (lambda: gaitsmith.document(figure="no-such-figure"), "no-such-figure"),
            (lambda: gaitsmith.document(out="-"), "out"),
            (lambda: gaitsmith.document(seed=True), "seed"),
            (lambda: gaitsmith.decisions(gaitsmith.read("star-man-travel")), "has no clip"),
            (lambda: gaitsmith.decisions(gaitsmith.read("star-man-shuffle"), 1), "clip: must be from 0 to 0, is 1"),
        ]:
            with self.subTest(words), self.assertRaisesRegex(ValueError, words.replace("[", r"\[").replace("]", r"\]")) as caught:
                call()
            self.assertIsInstance(caught.exception, gaitsmith.Error)


if __name__ == "__main__":
    unittest.main()
