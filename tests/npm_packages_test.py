#!/usr/bin/env python3
"""tests/npm_packages.py against a registry of our own: what fits is unpacked once, anything else is a sentence and leaves nothing."""
import base64
import hashlib
import http.server
import io
import os
import pathlib
import sys
import tarfile
import tempfile
import threading
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import npm_packages


def packed(files):
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w:gz") as archive:
        for name, data in files.items():
            info = tarfile.TarInfo(name)
            info.size = len(data)
            archive.addfile(info, io.BytesIO(data))
    return out.getvalue()


class Registry(http.server.BaseHTTPRequestHandler):
    answers, asked = {}, []

    def do_GET(self):
        Registry.asked.append(self.path)
        data = Registry.answers.get(self.path)
        self.send_response(200 if data else 404)
        self.end_headers()
        self.wfile.write(data or b"")

    def log_message(self, *_):
        pass


class Install(unittest.TestCase):
    def setUp(self):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Registry)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.here = pathlib.Path(self.folder.name)
        data = packed({"package/index.js": b"yes", "package/lib/a.js": b"a", "package/../../out.js": b"no", "package": b""})
        Registry.answers, Registry.asked = {"/mirror/tool/-/tool-1.0.0.tgz": data}, []
        self.patch(mock.patch.dict(npm_packages.LOCK, {"tool": self.entry(data)}))
        environment = {key: value for key, value in os.environ.items() if not key.lower().startswith(("npm_config", "http_proxy", "no_proxy"))}
        environment |= {"HOME": str(self.here), "PATH": "/nonexistent", "no_proxy": "*"}
        self.patch(mock.patch.dict(os.environ, environment, clear=True))
        self.address = f"http://127.0.0.1:{server.server_port}/mirror/"
        (self.here / ".npmrc").write_text(f"# mine\nregistry = {self.address}\nfund=false\n")

    def patch(self, one):
        one.start()
        self.addCleanup(one.stop)

    def entry(self, data):
        return {"version": "1.0.0", "integrity": "sha512-" + base64.b64encode(hashlib.sha512(data).digest()).decode()}

    def refused(self, words):
        with self.assertRaises(npm_packages.Missing) as refusal:
            npm_packages.install("tool", self.here / "tools")
        self.assertIn(words, str(refusal.exception))
        self.assertFalse(list((self.here / "tools").glob("*")))

    def test_is_unpacked_once(self):
        for _ in range(2):
            place = npm_packages.install("tool", self.here / "tools")
            self.assertEqual((place / "index.js").read_bytes(), b"yes")
            self.assertEqual((place / "lib/a.js").read_bytes(), b"a")
        self.assertEqual(len(Registry.asked), 1)
        self.assertEqual([path for path in self.here.rglob("out.js")], [])

    def test_what_was_changed_since_is_fetched_again(self):
        place = npm_packages.install("tool", self.here / "tools")
        (place / "archive.tgz").write_bytes(b"half")
        (place / "index.js").write_bytes(b"half")
        self.assertEqual((npm_packages.install("tool", self.here / "tools") / "index.js").read_bytes(), b"yes")

    def test_the_environment_comes_first(self):
        (self.here / ".npmrc").write_text("registry=http://127.0.0.1:9/\n")
        os.environ["NPM_CONFIG_REGISTRY"] = self.address.rstrip("/")
        npm_packages.install("tool", self.here / "tools")

    def test_nobody_set_a_registry(self):
        (self.here / ".npmrc").unlink()
        self.patch(mock.patch.object(npm_packages.pathlib.Path, "read_text", side_effect=FileNotFoundError))
        self.assertIsNone(npm_packages.setting("registry"))

    def test_other_bytes_are_refused(self):
        Registry.answers = {path: packed({"package/index.js": b"evil"}) for path in Registry.answers}
        self.refused("checksum")

    def test_what_is_not_there_or_cannot_be_reached_is_a_sentence(self):
        Registry.answers = {}
        self.refused("Not Found")
        for wrong in ("http://127.0.0.1:9/", "no address"):
            (self.here / ".npmrc").write_text(f"registry={wrong}\n")
            self.refused("could not be fetched")


class Lock(unittest.TestCase):
    def test_all_is_pinned(self):
        for name, entry in npm_packages.LOCK.items():
            with self.subTest(name):
                self.assertRegex(entry["integrity"], r"^sha512-[\w+/]{86}==$")
                self.assertRegex(entry["version"], r"^\d+\.\d+\.\d+")


unittest.main(verbosity=1)
