# SPDX-License-Identifier: MIT
"""The playground's page in a notebook, which a program controls and listens to."""
from __future__ import annotations

import json
import queue
import secrets
import threading
import time
import webbrowser
from collections.abc import Callable, Mapping
from functools import partial
from html import escape
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Optional
from urllib.parse import quote

from . import _core
from .border import Name, json_of, text

HERE = Path(__file__).parent
MOST_BYTES = 64 << 20  # of a message from the page
POLL_S = 10.0          # how long the page's request for the next call waits
SILENT_S = 45.0        # a page that has not asked for so long is gone
LONG_CALLS = ("synthesize", "lab")  # may take as long as they like
EVENTS = ("progress", "done", "error", "changed", "goal")


class Playground:
    """The playground in a frame of a notebook. Show it as a cell's last value, or with ``show()``; then call it.

    site:   folder of the built site (``./dev site`` makes build/site), or the address of a hosted one
    panels: as in the page's address: "all", "none" or names such as "style,search"; None: the page's own choice
    height: of the frame [pixels]

    A server of this process, on this machine only, passes messages between the page and Python. So notebook and browser must be
    on one machine. Its addresses have a secret part, without which it answers nothing. ``close()`` ends it.
    Raises Error if the site is not there.

    >>> playground = Playground()
    >>> playground.show()
    >>> playground.open(gaitsmith.read("star-man-shuffle"))
    >>> playground.measures()["travel"]
    """

    def __init__(self, site: Name = "build/site", panels: Optional[str] = None, height: int = 640) -> None:
        hosted = str(site).startswith(("http://", "https://"))
        if not hosted and not (Path(site) / "index.html").is_file():
            raise _core.Error(f"site: {site} has no index.html; ./dev site builds the page")
        self.height = height
        self._secret = secrets.token_urlsafe(16)
        self._query = "" if panels is None else f"?panels={quote(text('panels', panels))}"
        self._frame = f"{str(site).rstrip('/')}/{self._query}" if hosted else f"site/index.html{self._query}"
        self._lock = threading.Condition()
        self._calls: queue.Queue[dict[str, Any]] = queue.Queue()
        self._answers: dict[int, Optional[dict[str, Any]]] = {}  # of the calls that wait; None: not there yet
        self._number = 0
        self._page: Optional[str] = None  # the newest page that said it is ready
        self._heard = 0.0                 # when it last asked
        self._listeners: dict[str, list[Callable[[Any], None]]] = {}
        handler = partial(_Handler, self, directory=None if hosted else str(Path(site).resolve()))
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self._server.daemon_threads = True
        self._thread = threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.1}, daemon=True)
        self._thread.start()

    @property
    def url(self) -> str:
        """The address of the page, for a browser on this machine. It contains the secret."""
        return f"http://127.0.0.1:{self._server.server_address[1]}/{self._secret}/"

    def show(self) -> None:
        """Shows the page in the notebook's cell, or outside of notebooks in a browser."""
        try:
            from IPython import get_ipython
            from IPython.display import display
        except ImportError:
            webbrowser.open(self.url)
            return
        if get_ipython() is None:
            webbrowser.open(self.url)
        else:
            display(self)

    def _repr_html_(self) -> str:
        return (f'<iframe src="{escape(self.url)}" width="100%" height="{int(self.height)}" style="border: 0" '
                'allow="clipboard-write" title="Gaitsmith playground"></iframe>')

    def call(self, name: str, *args: Any, timeout: Optional[float] = 60.0) -> Any:
        """Calls one of the page's calls (docs/embedding.md) and returns its result. The first call waits for the page to start.

        timeout: seconds; None: as long as the page is there. ``synthesize`` and ``lab`` take what they need.
        Raises Error with the page's sentence, or if no page shows this playground.
        """
        limit = time.monotonic() + (SILENT_S if timeout is None else timeout)
        with self._lock:
            if not self._lock.wait_for(lambda: self._page is not None or not self._open(), limit - time.monotonic()) or not self._open():
                raise _core.Error("playground: no page shows it; show() it first" if self._open() else "playground: is closed")
            self._number += 1
            number, page = self._number, self._page
            call = {"id": number, "call": text("call", name), "args": json.loads(json.dumps(args, default=_plain))}
            self._answers[number] = None
            self._calls.put(call)
            patient = timeout is None or name in LONG_CALLS
            try:
                while (answer := self._answers[number]) is None:
                    if not self._open() or self._page != page or time.monotonic() - self._heard > SILENT_S:
                        raise _core.Error(f"{name}: the page is gone, or has started again")
                    if not patient and time.monotonic() > limit:
                        raise _core.Error(f"{name}: the page has not answered within {timeout} seconds")
                    self._lock.wait(0.2)
            finally:
                del self._answers[number]
        if "error" in answer:
            raise _core.Error(str(answer["error"]))
        return answer.get("result")

    def open(self, document: Any) -> None:
        """Shows a document, or the document of a Search or Problem, or a link's text."""
        self.call("open", document if isinstance(document, str) else json.loads(json_of(document)))

    def document(self) -> dict[str, Any]:
        """The present document, with all that was changed by hand."""
        return dict(self.call("document"))

    def measures(self) -> dict[str, Any]:
        """The shown motion in numbers, by the names of goals."""
        return dict(self.call("measures"))

    def synthesize(self, **options: Any) -> dict[str, Any]:
        """Searches in the page, with the options of its ``synthesize``, and returns {report, hash, link} when it is done."""
        return dict(self.call("synthesize", options))

    def on(self, event: str, listener: Callable[[Any], None]) -> None:
        """Calls back with the detail of each ``progress``, ``done``, ``error``, ``changed`` or ``goal``, from the server's thread."""
        if event not in EVENTS:
            raise _core.Error(f"event: must be one of {', '.join(EVENTS)}, is {event!r}")
        with self._lock:
            self._listeners.setdefault(event, []).append(listener)

    def close(self) -> None:
        """Ends the server. The page stays as it is, and is not heard any more."""
        if not self._open():
            return
        with self._lock:
            self._secret = ""
            self._lock.notify_all()
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()

    def __enter__(self) -> Playground:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _open(self) -> bool:
        return self._secret != ""

    # What the server's threads call.

    def _next(self, page: str) -> Optional[list[dict[str, Any]]]:
        """The next call for a page, none after a while; None for a page that another one has followed."""
        with self._lock:
            if page != self._page:
                return None
            self._heard = time.monotonic()
        try:
            return [self._calls.get(timeout=POLL_S)]
        except queue.Empty:
            return []

    def _said(self, page: str, said: Mapping[str, Any]) -> None:
        """An answer, an event, or that a page is ready."""
        if said.get("event") == "ready":
            with self._lock:
                self._page, self._heard = page, time.monotonic()
                self._calls = queue.Queue()
                self._lock.notify_all()
            return
        with self._lock:
            if page != self._page:
                return
            if isinstance(said.get("id"), int):
                if said["id"] in self._answers:  # or nobody waits any more
                    self._answers[said["id"]] = dict(said)
                    self._lock.notify_all()
                return
            listeners = list(self._listeners.get(str(said.get("event")), ()))
        for listener in listeners:
            listener(said.get("detail"))


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise _core.Error(f"args: a {type(value).__name__} is neither text nor number")


class _Handler(SimpleHTTPRequestHandler):
    """Serves the page around the playground, the site's files, and the messages."""

    extensions_map = {**SimpleHTTPRequestHandler.extensions_map, ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm"}

    def __init__(self, playground: Playground, *args: Any, directory: Optional[str], **kwargs: Any) -> None:
        self._playground = playground
        self._has_site = directory is not None
        super().__init__(*args, directory=directory, **kwargs)

    def do_GET(self) -> None:
        kind, _, rest = self._place().partition("/")
        if kind == "":
            page = (HERE / "playground.html").read_text(encoding="utf-8")
            self._answer("text/html; charset=utf-8", page.replace("PLAYGROUND", escape(self._playground._frame)).replace("EVENTS", " ".join(EVENTS)).encode())
        elif kind == "player.js":
            self._answer("text/javascript", (HERE / "player.js").read_bytes())
        elif kind == "next":
            calls = self._playground._next(rest)
            if calls is None:
                self.send_error(410)
            else:
                self._answer("application/json", json.dumps(calls).encode())
        elif kind == "site" and self._has_site:
            self.path = "/" + rest
            super().do_GET()
        else:
            self.send_error(404)

    def do_HEAD(self) -> None:
        self.send_error(405)

    def do_POST(self) -> None:
        kind, _, page = self._place().partition("/")
        length = self.headers.get("content-length", "")
        if kind != "said" or not length.isdigit() or int(length) > MOST_BYTES:
            self.send_error(404)
            return
        try:
            said = json.loads(self.rfile.read(int(length)))
        except ValueError:
            said = None
        if not isinstance(said, dict):
            self.send_error(400)
            return
        self._playground._said(page, said)
        self._answer("application/json", b"{}")

    def list_directory(self, path: Any) -> None:
        self.send_error(404)

    def log_message(self, *_: Any) -> None:
        pass

    def _place(self) -> str:
        """What follows the secret in the path; another path is none that exists. Another name for this machine than its number could
        be a page that has made its own name point here."""
        secret = self._playground._secret
        host = self.headers.get("host", "").partition(":")[0]
        start = f"/{secret}/"
        return self.path.partition("?")[0][len(start):] if secret and host == "127.0.0.1" and self.path.startswith(start) else "?"

    def _answer(self, kind: str, body: bytes) -> None:
        self.send_response(200)
        self.send_header("content-type", kind)
        self.send_header("content-length", str(len(body)))
        self.send_header("cache-control", "no-store")
        self.end_headers()
        self.wfile.write(body)
