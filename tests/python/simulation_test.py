# SPDX-License-Identifier: BSD-3-Clause
"""Runs from Python: the bits of `crumple run`, views of the state, errors, Ctrl-C."""
import json
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy

import crumple
from small_deck import write_plate
from support import ROOT, FolderTest


class SimulationTest(FolderTest):
    def reference(self, path, *options):
        """run.json of the program."""
        code, _, console = self.program("run", path, "-o", self.folder / "reference", "-q", *options)
        self.assertEqual(code, 0, console)
        return json.loads((self.folder / "reference/run.json").read_text())

    def test_the_same_bits_as_the_program(self):
        path = write_plate(self.folder)
        for precision in ("double", "mixed"):
            for threads in (1, 2):
                with self.subTest(precision=precision, threads=threads):
                    run = self.reference(path, "--precision", precision)
                    simulation = crumple.Simulation(path, threads=threads, precision=precision).run()
                    self.assertEqual(simulation.termination, "normal")
                    self.assertEqual(simulation.reason, run["reason"])
                    self.assertEqual((simulation.cycle, simulation.time), (run["cycles"], run["end_time"]))
                    self.assertEqual(simulation.state_hash, run["state_hash"])

    def test_the_same_files_as_the_program(self):
        path = write_plate(self.folder)
        run = self.reference(path)
        with crumple.Simulation(path, output=self.folder / "out") as simulation:
            simulation.step(7)
            simulation.run(until=0.02)
            simulation.run()
        self.assertEqual(simulation.result.record["state_hash"], run["state_hash"])
        ours = sorted(str(p.relative_to(self.folder / "out")) for p in (self.folder / "out").rglob("*"))
        theirs = sorted(str(p.relative_to(self.folder / "reference")) for p in (self.folder / "reference").rglob("*"))
        self.assertEqual(ours, theirs)
        for name in ours:
            if name.endswith((".csv", ".vtu", ".pvd")):
                self.assertEqual((self.folder / "out" / name).read_bytes(), (self.folder / "reference" / name).read_bytes())

    def test_a_car_like_model_has_the_same_bits(self):
        path = ROOT / "examples/00_first_deck/tube.k"
        run = self.reference(path, "--end", "0.2")
        simulation = crumple.Simulation(crumple.Deck(path, end_time=0.2)).run()
        self.assertEqual(simulation.state_hash, run["state_hash"])

    def test_views_show_the_state_without_a_copy(self):
        simulation = crumple.Simulation(write_plate(self.folder))
        positions, velocities, masses = simulation.positions, simulation.velocities, simulation.masses
        before = positions.copy()
        step = simulation.next_step
        simulation.step()
        self.assertTrue(numpy.shares_memory(positions, simulation.positions))
        numpy.testing.assert_array_equal(simulation.displacements, positions - before)
        # Nothing has touched the wall yet, so all fall with the initial velocity.
        numpy.testing.assert_allclose(positions[:, 2] - before[:, 2], -10.0 * step, rtol=1e-9)
        self.assertEqual(velocities.shape, (25, 3))
        for view in (positions, velocities, masses, simulation.accelerations, simulation.contact_forces):
            self.assertFalse(view.flags.writeable)
        # density x thickness x area of the plate, which rises 0.3 mm in 5 mm
        self.assertAlmostEqual(masses.sum() / (7.83e-6 * 1.0 * 20.0 * 4 * numpy.hypot(5.0, 0.3)), 1.0, 9)

    def test_order_of_nodes(self):
        deck = crumple.Deck(write_plate(self.folder, cells=6))
        simulation = crumple.Simulation(deck)
        order = simulation.deck_order
        numpy.testing.assert_array_equal(simulation.node_ids[order], deck.node_ids)
        numpy.testing.assert_array_equal(simulation.positions[order], deck.positions)

    def test_forces_change_the_momentum_of_each_node(self):
        simulation = crumple.Simulation(write_plate(self.folder))
        simulation.run(until=0.02)
        momentum = simulation.masses[:, None] * simulation.velocities
        step = simulation.next_step
        simulation.step()
        change = (simulation.masses[:, None] * simulation.velocities - momentum)[:, :2]
        impulse = (simulation.forces * 0.5 * (step + simulation.next_step))[:, :2]
        # Along x and y the wall does nothing, and what elements do to nodes sums to zero.
        scale = numpy.abs(impulse).max()
        self.assertGreater(scale, 1e-9 * numpy.abs(momentum).max())
        round_off = 1e-13 * numpy.abs(momentum).max()
        numpy.testing.assert_allclose(change, impulse, rtol=1e-9, atol=round_off)
        numpy.testing.assert_allclose(impulse.sum(axis=0), 0, atol=1e-11 * scale)

    def test_views_outlive_the_simulation(self):
        positions = crumple.Simulation(write_plate(self.folder)).positions
        numpy.testing.assert_allclose(positions[:, 2].min(), 0.1)

    def test_energies(self):
        simulation = crumple.Simulation(write_plate(self.folder), history_every=0.01).run()
        rows = simulation.energy_history
        self.assertEqual(rows["time"][0], 0.0)
        self.assertEqual(len(rows), 6)
        self.assertEqual(rows["total"][-1], simulation.energies["total"])
        mass = simulation.masses.sum()
        self.assertAlmostEqual(rows["kinetic"][0] / (0.5 * mass * 100.0), 1.0, 9)

    def test_frames_come_at_even_times(self):
        times = []
        simulation = crumple.Simulation(write_plate(self.folder))
        simulation.run(on_frame=lambda state: times.append(state.time), every=0.01)
        self.assertEqual(len(times), 6)
        for k, moment in enumerate(times[:-1]):
            self.assertGreaterEqual(moment, 0.01 * k)
            self.assertLess(moment - 0.01 * k, 2 * simulation.next_step)

    def test_a_callback_may_end_the_run(self):
        with crumple.Simulation(write_plate(self.folder), output=self.folder / "out") as simulation:
            simulation.run(on_frame=lambda state: state.time < 0.02, every=0.01)
        self.assertEqual(simulation.termination, "interrupted")
        self.assertEqual(crumple.Result(self.folder / "out").termination, "interrupted")
        self.assertEqual(simulation.step(), 0)

    def test_errors_have_the_words_of_the_console(self):
        # DTMIN ends the run when a step is shorter than so many of the first one.
        path = write_plate(self.folder, **{"      0.05\n*": "      0.05         0       1.0\n*"})
        code, _, console = self.program("run", path, "-o", self.folder / "reference", "-q")
        self.assertEqual(code, 3, console)
        simulation = crumple.Simulation(path)
        with self.assertRaises(crumple.NumericalError) as raised:
            simulation.run()
        self.assertIn(str(raised.exception), console.splitlines())
        self.assertIsInstance(raised.exception, crumple.Error)
        with self.assertRaises(crumple.NumericalError):
            simulation.step()

    def test_a_folder_has_one_run_at_a_time(self):
        path = write_plate(self.folder)
        with crumple.Simulation(path, output=self.folder / "out") as first:
            with self.assertRaises(crumple.OutputError):
                crumple.Simulation(path, output=self.folder / "out")
            first.run()
        crumple.Simulation(path, output=self.folder / "out").close()

    def test_wrong_arguments(self):
        path = write_plate(self.folder)
        with self.assertRaises(ValueError):
            crumple.Simulation(path, threads=0)
        with self.assertRaises(crumple.DeckError) as raised:
            crumple.Simulation(path, precision="half")
        self.assertEqual(str(raised.exception), f'{path}: error: Precision "half" does not exist: mixed and double do.')
        with self.assertRaises(ValueError):
            crumple.Simulation(path).run(on_frame=print, every=0)

    def test_other_threads_run_meanwhile_and_may_not_step(self):
        simulation = crumple.Simulation(crumple.Deck(write_plate(self.folder, cells=30), end_time=1e9))
        refused = []

        def disturb():
            time.sleep(0.2)
            try:
                simulation.step()
            except crumple.Error as fault:
                refused.append(str(fault))
            os.kill(os.getpid(), signal.SIGINT)

        other = threading.Thread(target=disturb)
        other.start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.run()
        other.join()
        self.assertEqual(len(refused), 1)
        self.assertIn("one thread at a time", refused[0])
        cycle = simulation.cycle
        self.assertGreater(cycle, 0)
        self.assertEqual(simulation.step(3), 3)  # it may go on
        self.assertEqual(simulation.cycle, cycle + 3)

    def test_interrupted_and_continued_has_the_same_bits(self):
        path = write_plate(self.folder, cells=30)
        whole = crumple.Simulation(crumple.Deck(path, end_time=1e9))
        simulation = crumple.Simulation(crumple.Deck(path, end_time=1e9))
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.run()
        whole.step(simulation.cycle)
        self.assertEqual(whole.state_hash, simulation.state_hash)

    def test_ctrl_c_with_output_leaves_whole_results(self):
        path = write_plate(self.folder, cells=30)
        script = (f"import crumple\n"
                  f"s = crumple.Simulation(crumple.Deck({str(path)!r}, end_time=1e9), output={str(self.folder / 'out')!r})\n"
                  f"print('ready', flush=True)\n"
                  f"with s: s.run()\n")
        process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "ready\n")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertEqual(crumple.Result(self.folder / "out").termination, "interrupted")
        self.assertTrue((self.folder / "out/restart/latest.restart").exists())


if __name__ == "__main__":
    unittest.main()
