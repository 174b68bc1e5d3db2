#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The live page of a run, as a browser asks for it.

    serve_test.py PROGRAM [unittest options]

Templates of its own stand in for the pages, so that no page has to be built.
"""
import http.client
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
DECK = os.path.abspath("examples/04_square_tube/square_tube.k")
END = "3"


def environment(folder):
    (folder / "report.html").write_text("<body><!-- crumple-data --></body>")
    (folder / "live.html").write_text("<body>the page around</body>")
    return {**os.environ, "CRUMPLE_REPORT_TEMPLATE": str(folder / "report.html"), "CRUMPLE_LIVE_TEMPLATE": str(folder / "live.html")}


class Serve(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="crumple_serve_"))
        self.addCleanup(shutil.rmtree, self.root, True)
        self.environment = environment(self.root)
        self.port = 0
        self.token = ""

    def start(self, *arguments):
        """Starts the program and waits for its port."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], env=self.environment, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        line = ""
        while "Live page" not in line:
            line = process.stdout.readline()
            self.assertNotEqual(line, "", "no address was printed")
        found = re.fullmatch(r"Live page: http://127\.0\.0\.1:(\d+)(|/[0-9a-f]{32})/\n", line)
        self.assertTrue(found, line)
        self.port = int(found[1])
        self.token = found[2]
        return process

    def start_run(self, *more):
        return self.start("run", DECK, "-q", "-o", self.root / "out", "--end", END, "--precision", "mixed", *more)

    def get(self, path, method="GET", headers=None, token=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        try:
            connection.request(method, (self.token if token is None else token) + path, headers=headers or {})
            answer = connection.getresponse()
            return answer.status, answer.getheader("Content-Type"), answer.read().decode()
        finally:
            connection.close()

    def status(self):
        code, kind, text = self.get("/status")
        self.assertEqual((code, kind), (200, "application/json"))
        return json.loads(text)

    def wait_for(self, condition):
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            status = self.status()
            if condition(status):
                return status
            time.sleep(0.01)
        self.fail(f"still {status}")

    def report(self):
        """Description of the run in the report."""
        code, kind, text = self.get("/report")
        self.assertEqual((code, kind), (200, "text/html; charset=utf-8"), text[:200])
        found = re.search(r'id="crumple-meta">(.*?)</script>', text, re.DOTALL)
        self.assertIn('id="crumple-data-position_0"', text)
        return json.loads(found[1])

    def test_run_is_followed_to_its_end_and_stays_the_same(self):
        alone = self.root / "alone"
        subprocess.run([PROGRAM, "run", DECK, "-q", "-o", alone, "--end", END, "--precision", "mixed"], check=True, stdout=subprocess.DEVNULL)
        process = self.start_run("--serve", 0)
        self.assertEqual(self.get("/")[2], "<body>the page around</body>")
        first = self.wait_for(lambda status: status["frames"] > 0)
        self.assertEqual(first["state"], "running")
        self.assertEqual(first["end_time"], float(END))
        seen = len(self.report()["times"])
        self.assertGreaterEqual(seen, first["frames"])
        later = self.wait_for(lambda status: status["frames"] > seen)
        self.assertGreater(later["time"], first["time"])
        self.assertGreater(later["cycle"], first["cycle"])
        self.assertGreater(later["seconds_to_go"], 0)
        self.assertGreater(later["ns_per_element_cycle"], 0)
        report = self.report()
        self.assertGreaterEqual(len(report["times"]), later["frames"])
        self.assertIsNone(report["run"])
        # Whoever asks again and again gets the last state before the program ends.
        self.assertEqual(self.wait_for(lambda status: status["state"] == "ended")["termination"], "normal")
        last = self.report()
        self.assertEqual(last["run"]["termination"], "normal")
        self.assertEqual(last["times"][-1], last["run"]["end_time"])
        self.assertEqual(process.wait(timeout=30), 0)
        records = [json.loads((folder / "run.json").read_text()) for folder in (alone, self.root / "out")]
        self.assertEqual(records[0]["state_hash"], records[1]["state_hash"])
        for table in alone.glob("*.csv"):
            self.assertEqual(table.read_bytes(), (self.root / "out" / table.name).read_bytes(), table.name)

    def test_refuses_what_does_not_come_from_this_machine(self):
        self.start_run("--serve", 0)
        self.wait_for(lambda status: status["frames"] > 0)
        for host in ("crumple.example", f"crumple.example:{self.port}", "127.0.0.1.crumple.example", ""):
            for path in ("/", "/status", "/report"):
                self.assertEqual(self.get(path, headers={"Host": host})[0], 403, host)
        self.assertEqual(self.get("/status", headers={"Host": f"localhost:{self.port}"})[0], 200)
        for method in ("POST", "PUT", "DELETE", "HEAD", "OPTIONS"):
            self.assertEqual(self.get("/status", method=method)[0], 405, method)
        for path in ("/run.json", "/vtu/", "/../../../../etc/passwd", "/%2e%2e/run.json"):
            self.assertEqual(self.get(path)[0], 404, path)
        for address in self.other_addresses():
            with self.assertRaises(OSError, msg=address), socket.create_connection((address, self.port), timeout=2):
                pass

    @staticmethod
    def other_addresses():
        """Of this machine, by which others could reach it; 127.0.0.2 stands for them where there is no network."""
        addresses = {"127.0.0.2"}
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            try:
                probe.connect(("192.0.2.1", 9))  # sends nothing
                addresses.add(probe.getsockname()[0])
            except OSError:
                pass
        return addresses - {"127.0.0.1"}

    def test_port_in_use_stops_the_run_before_it_begins(self):
        self.start_run("--serve", 0)
        again = subprocess.run([PROGRAM, "run", DECK, "-q", "-o", self.root / "other", "--serve", str(self.port)], env=self.environment,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(again.returncode, 2)
        self.assertIn(f"Port {self.port} cannot be listened at", again.stderr)
        self.assertIn("--serve 0", again.stderr)
        self.assertFalse((self.root / "other").exists())

    def test_interrupt_ends_a_served_run_as_any_other(self):
        process = self.start_run("--serve", 0)
        self.wait_for(lambda status: status["frames"] > 1)
        process.send_signal(signal.SIGINT)
        self.assertEqual(self.wait_for(lambda status: status["state"] == "ended")["termination"], "interrupted")
        self.assertEqual(process.wait(timeout=30), 130)
        self.assertTrue((self.root / "out" / "restart" / "latest.restart").exists())

    def test_program_does_not_wait_where_no_page_is_open(self):
        process = self.start_run("--serve", 0)
        process.wait(timeout=60)
        ended = (self.root / "out" / "run.json").stat().st_mtime
        self.assertLess(time.time() - ended, 2)

    def test_readers_that_hang_up_do_no_harm(self):
        process = self.start_run("--serve", 0)
        self.wait_for(lambda status: status["frames"] > 0)
        for _ in range(20):
            with socket.create_connection(("127.0.0.1", self.port)) as caller:
                caller.sendall(f"GET {self.token}/report HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())
        self.assertEqual(process.wait(timeout=60), 0)

    def start_folder(self, *more):
        subprocess.run([PROGRAM, "run", DECK, "-q", "-o", self.root / "out", "--end", "0.5"], check=True, stdout=subprocess.DEVNULL)
        return self.start("report", self.root / "out", "--serve", 0, *more)

    def test_who_does_not_know_the_token_gets_nothing(self):
        self.start_folder()
        self.assertEqual(len(self.token), 33)
        wrong = "/" + ("0" if self.token[1] != "0" else "1") + self.token[2:]
        for token in ("", "/", "/0", wrong, self.token[:-1], self.token + "0", self.token.upper() + "x"):
            for path in ("/", "/status", "/report", "status"):
                code, _, text = self.get(path, token=token)
                self.assertIn(code, (400, 403), token + path)
                self.assertNotIn("page around", text)
        self.assertEqual(self.get("/")[0], 200)
        self.assertEqual(self.get("/../status")[0], 404)

    def test_without_a_token_if_asked_for(self):
        self.start_folder("--no-token")
        self.assertEqual(self.token, "")
        self.assertEqual(self.get("/status")[0], 200)

    def raw(self, sent, timeout=10):
        """What comes for some bytes, until the connection is closed."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=timeout) as caller:
            caller.sendall(sent)
            answer = b""
            while True:
                piece = caller.recv(65536)
                if not piece:
                    return answer
                answer += piece

    def test_requests_that_are_none_are_refused(self):
        self.start_folder()
        for sent in (b"\r\n\r\n", b"GET\r\n\r\n", b"GET / HTTP/2\r\n\r\n", b"GET  HTTP/1.1\r\n\r\n", b"\x16\x03\x01\n\n",
                     b"GET http://other/ HTTP/1.1\r\nHost: localhost\r\n\r\n", b"get / HTTP/1.1\r\n\r\n"):
            self.assertIn(b" 400 ", self.raw(sent).split(b"\r\n")[0], sent)
        self.assertIn(b" 431 ", self.raw(b"GET / HTTP/1.1\r\nX: " + b"x" * 9000).split(b"\r\n")[0])
        two = b"GET / HTTP/1.1\r\nHost: localhost\r\nhost: localhost\r\n\r\n"
        self.assertIn(b" 403 ", self.raw(two).split(b"\r\n")[0])
        self.assertEqual(self.get("/status")[0], 200)

    def test_clients_that_say_nothing_do_not_block_others(self):
        self.start_folder()
        silent = [socket.create_connection(("127.0.0.1", self.port)) for _ in range(200)]
        try:
            started = time.monotonic()
            self.assertEqual(self.get("/status")[0], 200)
            self.assertLess(time.monotonic() - started, 4)  # a silent client has 5
        finally:
            for caller in silent:
                caller.close()

    def test_a_request_that_drips_is_given_up(self):
        self.start_folder()
        started = time.monotonic()
        with socket.create_connection(("127.0.0.1", self.port)) as caller, self.assertRaises(OSError):
            while time.monotonic() - started < 20:
                caller.sendall(b"G")
                time.sleep(0.2)
        self.assertLess(time.monotonic() - started, 8)

    def test_ends_within_two_seconds_whatever_clients_do(self):
        process = self.start_folder()
        request = f"GET {self.token}/report HTTP/1.1\r\nHost: localhost\r\n\r\n".encode()
        callers = []
        for sent in (b"", b"GET / HT", request, request):
            callers.append(socket.create_connection(("127.0.0.1", self.port)))
            callers[-1].sendall(sent)
        time.sleep(0.3)
        started = time.monotonic()
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=10), 0)
        self.assertLess(time.monotonic() - started, 2)
        for caller in callers:
            caller.close()

    def test_a_run_ends_soon_after_a_signal_although_pages_are_open(self):
        process = self.start_run("--serve", 0)
        self.wait_for(lambda status: status["frames"] > 0)
        process.send_signal(signal.SIGTERM)
        started = time.monotonic()
        while process.poll() is None and time.monotonic() - started < 30:
            try:
                self.get("/status")
            except OSError:
                pass
            time.sleep(0.01)
        self.assertEqual(process.poll(), 143)
        self.assertLess(time.monotonic() - started, 10)  # a restart file goes to the disk; without haste it is 30

    def test_folder_is_shown_until_interrupt(self):
        process = self.start_folder()
        status = self.status()
        record = json.loads((self.root / "out" / "run.json").read_text())
        self.assertEqual((status["state"], status["termination"], status["time"]), ("ended", "normal", record["end_time"]))
        self.assertEqual(len(self.report()["times"]), status["frames"])
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=10), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
