# SPDX-License-Identifier: MIT
"""The playground in a notebook: what its server answers and refuses, and the shipped notebook with a real page."""
import contextlib
import io
import json
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

import gaitsmith
from repository import ROOT

try:
    import matplotlib
except ImportError:
    matplotlib = None

SITE = ROOT / "build/site"
BROWSER = next((found for found in map(shutil.which, ("chromium-headless-shell", "chromium", "google-chrome")) if found), None)
HOSTED = "https://example.org/gaitsmith"  # no site is needed where no page is opened


class FakePage:
    """A page that answers each call with its own arguments; but "bad" with an error, and "silent" not at all."""

    def __init__(self, playground, name="page"):
        self.url, self.name, self.calls, self.status = playground.url, name, [], 200
        self.say({"event": "ready"})
        self.thread = threading.Thread(target=self.listen, daemon=True)
        self.thread.start()

    def say(self, message):
        urllib.request.urlopen(self.url + f"said/{self.name}", json.dumps(message).encode()).close()

    def listen(self):
        while True:
            try:
                with urllib.request.urlopen(self.url + f"next/{self.name}") as answer:
                    calls = json.loads(answer.read())
            except urllib.error.HTTPError as fault:
                self.status = fault.code
                fault.close()
                return
            except (OSError, ValueError):
                return
            for call in calls:
                self.calls.append(call)
                if call["call"] == "bad":
                    self.say({"id": call["id"], "error": "no such thing"})
                elif call["call"] != "silent":
                    self.say({"id": call["id"], "result": call["args"]})


def status_of(url, body=None, headers=None):
    try:
        with urllib.request.urlopen(urllib.request.Request(url, body, headers or {})) as answer:
            return answer.status
    except urllib.error.HTTPError as fault:
        fault.close()
        return fault.code


class Messages(unittest.TestCase):
    def setUp(self):
        self.playground = gaitsmith.Playground(HOSTED, panels="style,search")
        self.addCleanup(self.playground.close)

    def test_calls_and_answers(self):
        FakePage(self.playground)
        self.assertEqual(self.playground.call("echo", 1, "two", {"three": [3]}), [1, "two", {"three": [3]}])
        document = gaitsmith.read("star-man-shuffle")
        self.assertEqual(self.playground.call("echo", document)[0]["title"], document["title"])

    def test_an_error_of_the_page_is_an_error_here(self):
        FakePage(self.playground)
        with self.assertRaisesRegex(gaitsmith.Error, "no such thing"):
            self.playground.call("bad")

    def test_a_document_that_is_none_is_refused_before_it_is_sent(self):
        page = FakePage(self.playground)
        with self.assertRaisesRegex(gaitsmith.Error, "document"):
            self.playground.open(7)
        self.assertEqual(page.calls, [])

    def test_events(self):
        page = FakePage(self.playground)
        heard = []
        self.playground.on("changed", heard.append)
        page.say({"event": "changed", "detail": {"title": "A title"}})
        page.say({"event": "done", "detail": {}})
        self.assertEqual(heard, [{"title": "A title"}])
        with self.assertRaisesRegex(gaitsmith.Error, "event"):
            self.playground.on("sneeze", heard.append)

    def test_a_listener_may_call(self):
        page = FakePage(self.playground)
        heard = []
        self.playground.on("changed", lambda _: heard.append(self.playground.call("echo", 4)))
        page.say({"event": "changed"})
        self.assertEqual(heard, [[4]])

    def test_nobody_there_and_no_answer(self):
        with self.assertRaisesRegex(gaitsmith.Error, "no page"):
            self.playground.call("echo", timeout=0.2)
        FakePage(self.playground)
        with self.assertRaisesRegex(gaitsmith.Error, "not answered"):
            self.playground.call("silent", timeout=0.3)

    def test_the_newest_page_takes_over(self):
        first = FakePage(self.playground, "first")
        second = FakePage(self.playground, "second")
        self.assertEqual(self.playground.call("echo", 5), [5])
        self.assertEqual([call["args"] for call in second.calls], [[5]])
        first.thread.join(30.0)
        self.assertEqual(first.status, 410)

    def test_a_page_that_starts_again_ends_calls(self):
        FakePage(self.playground)
        threading.Timer(0.2, FakePage, (self.playground, "again")).start()
        with self.assertRaisesRegex(gaitsmith.Error, "gone, or has started again"):
            self.playground.call("silent", timeout=20.0)

    def test_without_the_secret_nothing(self):
        port = self.playground.url.split("/")[2]
        self.assertEqual(status_of(self.playground.url), 200)
        self.assertEqual(status_of(f"http://{port}/"), 404)
        self.assertEqual(status_of(f"http://{port}/site/index.html"), 404)
        self.assertEqual(status_of(f"http://{port}/said/page", b'{"event": "ready"}'), 404)
        self.assertEqual(status_of(self.playground.url, headers={"host": "elsewhere.example"}), 404)

    def test_wrong_messages(self):
        url = self.playground.url
        self.assertEqual(status_of(url + "said/page", b"{"), 400)
        self.assertEqual(status_of(url + "said/page", b"[1]"), 400)
        self.assertEqual(status_of(url + "other/page", b"{}"), 404)
        self.assertEqual(status_of(url + "next/unknown"), 410)
        self.assertEqual(status_of(url + "site/index.html"), 404)  # hosted elsewhere
        self.assertEqual(status_of(url + "said/unknown", b'{"id": 1, "result": 2}'), 200)

    def test_frame(self):
        self.assertIn(self.playground.url, self.playground._repr_html_())
        with urllib.request.urlopen(self.playground.url) as answer:
            self.assertIn(f'src="{HOSTED}/?panels=style%2Csearch"', answer.read().decode())

    def test_closed(self):
        self.playground.close()
        self.playground.close()
        with self.assertRaisesRegex(gaitsmith.Error, "closed"):
            self.playground.call("echo")


class Site(unittest.TestCase):
    def test_no_site(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(gaitsmith.Error, "no index.html"):
            gaitsmith.Playground(folder)

    def test_only_files_of_the_site(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "secret.txt").write_text("no")
            site = Path(folder, "site")
            site.mkdir()
            (site / "index.html").write_text("yes")
            with gaitsmith.Playground(site) as playground:
                self.assertEqual(status_of(playground.url + "site/index.html?panels=none"), 200)
                self.assertEqual(status_of(playground.url + "site/"), 200)
                for path in ("site/../secret.txt", "site/%2e%2e/secret.txt", "site//../secret.txt", "site/none.txt"):
                    self.assertEqual(status_of(playground.url + path), 404, path)


@unittest.skipIf(BROWSER is None, "no Chromium is installed")
@unittest.skipIf(matplotlib is None, "Matplotlib is not installed")
@unittest.skipUnless((SITE / "index.html").is_file(), "the site is not built")
class Notebook(unittest.TestCase):
    """Runs the cells of the shipped notebook in order. Where a notebook would show the page, a browser opens it."""

    def test_cells(self):
        notebook = json.loads((ROOT / "examples/notebooks/playground.ipynb").read_text(encoding="utf-8"))
        cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertIn("../../build/site", cells[0])
        names, printed, before = {}, io.StringIO(), os.getcwd()
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile, contextlib.ExitStack() as after:
            os.chdir(ROOT / "examples/notebooks")
            after.callback(os.chdir, before)
            after.enter_context(contextlib.redirect_stdout(printed))
            exec(compile(cells[0].replace("playground.show()", ""), "cell 1", "exec"), names)
            playground = names["playground"]
            after.callback(playground.close)
            browser = subprocess.Popen([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-port=0", f"--user-data-dir={profile}",
                                        playground.url], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            after.callback(browser.wait)
            # What Debian installs is a script that waits for the browser: killed alone, it would leave it behind.
            after.callback(os.killpg, browser.pid, signal.SIGKILL)
            for number, code in enumerate(cells[1:], 2):
                exec(compile(code, f"cell {number}", "exec"), names)
            self.assertEqual(printed.getvalue().count("True"), 2, printed.getvalue())  # the page's bits are Python's, twice
            self.assertGreater(len(names["seen"]), 0)
            playground.open(gaitsmith.read("there-and-back"))
            limit = time.monotonic() + 30.0
            while not names["ways"] and time.monotonic() < limit:
                time.sleep(0.1)
            self.assertEqual(names["ways"][-1:], [playground.measures()["travel"]])
            with self.assertRaisesRegex(gaitsmith.Error, "."):
                playground.open("no link")


if __name__ == "__main__":
    unittest.main()
