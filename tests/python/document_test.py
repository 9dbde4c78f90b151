# SPDX-License-Identifier: MIT
"""Every code block of docs/python.md runs, one after another, as a reader would run them."""
import contextlib
import io
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from repository import ROOT

try:
    import matplotlib
except ImportError:
    matplotlib = None

BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", (ROOT / "docs/python.md").read_text(encoding="utf-8"), re.M | re.S)
# A cell of Figure 6 takes minutes; in a test it is a small one.
SMALL = ("trials=20, evaluations=40000", "trials=2, evaluations=400")


class Document(unittest.TestCase):
    def test_blocks_are_of_known_languages(self):
        self.assertEqual({language for language, _ in BLOCKS}, {"sh", "python"})

    def test_commands(self):
        commands = [line for language, code in BLOCKS if language == "sh" for line in code.splitlines()]
        self.assertEqual(commands[0], "./dev python")  # which runs this test
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(ROOT / "build", os.path.join(folder, "build"))
            path = os.pathsep.join(["/usr/bin", os.environ["PATH"]])  # not the virtual environment's python3
            subprocess.run("\n".join(["set -e", *commands[1:]]), shell=True, check=True, cwd=folder, capture_output=True, env={**os.environ, "PATH": path})
            found = subprocess.run(["walking/bin/python", "-c", "import gaitsmith; print(gaitsmith.__file__)"], check=True, cwd=folder, capture_output=True, text=True)
            self.assertIn(os.path.join("walking", "lib"), found.stdout)

    @unittest.skipIf(matplotlib is None, "Matplotlib is not installed")
    def test_programs(self):
        programs = [code for language, code in BLOCKS if language == "python" and "Playground(" not in code]
        figure = next(code for code in programs if "matplotlib" in code)
        self.assertIn(SMALL[0], figure)
        self.assertLessEqual(len([line for line in figure.splitlines() if line]), 20)
        names: dict = {}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for code in programs:
                    with self.subTest(code), contextlib.redirect_stdout(io.StringIO()) as printed:
                        exec(compile(code.replace(*SMALL), "docs/python.md", "exec"), names)
                    self.assertTrue(printed.getvalue().strip(), code)
                self.assertIn("<svg", Path("figure-6.svg").read_text(encoding="utf-8"))
            finally:
                os.chdir(before)


    def test_the_playground_is_as_in_the_notebook(self):  # whose cells playground_test.py runs
        shown = next(code for _, code in BLOCKS if "Playground(" in code)
        notebook = json.loads((ROOT / "examples/notebooks/playground.ipynb").read_text(encoding="utf-8"))
        first = next("".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code")
        self.assertIn(shown.strip(), first)


if __name__ == "__main__":
    unittest.main()
