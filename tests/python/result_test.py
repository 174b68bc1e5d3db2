# SPDX-License-Identifier: BSD-3-Clause
"""Results from Python: run.json, histories with units, frames, comparison, responses."""
import json
import math
import unittest

import numpy

import crumple
from crumple.units import Units
from small_deck import write_plate
from support import FolderTest


class ResultTest(FolderTest):
    def result(self):
        crumple.Simulation(write_plate(self.folder), output=self.folder / "out").run()
        return crumple.Result(self.folder / "out")

    def test_histories_are_those_of_the_files(self):
        result = self.result()
        self.assertEqual(result.termination, "normal")
        self.assertIn("rwforc", result.history_names)
        walls = result.history("rwforc")
        reference = numpy.genfromtxt(self.folder / "out/rwforc.csv", delimiter=",", names=True)
        self.assertEqual(tuple(walls), reference.dtype.names)
        for name in reference.dtype.names:
            numpy.testing.assert_array_equal(walls[name], reference[name])
        self.assertGreater(walls["normal"].max(), 0)
        nodes = result.history("nodout")
        self.assertEqual(set(nodes["node"]), {11, 13})
        one = nodes.select(node=13)
        self.assertEqual(one.rows * 2, nodes.rows)
        self.assertTrue(numpy.all(one["node"] == 13))
        with self.assertRaisesRegex(crumple.Error, "glstat"):
            result.history("rbdout")
        with self.assertRaisesRegex(KeyError, "normal"):
            walls["nomral"]

    def test_units(self):
        result = self.result()
        self.assertEqual(result.history("rwforc").units["normal"], "kN")
        self.assertEqual(result.history("glstat").units["internal"], "J")
        self.assertEqual(result.history("nodout").units["ax"], "mm/ms^2")
        self.assertEqual(result.history("rwforc").units["wall"], "")
        other = crumple.Result(self.folder / "out", units="t, mm, s").history("glstat")
        self.assertEqual(other.units["internal"], "mJ")
        self.assertEqual(Units("").unit("force"), "M L/T^2")
        # One kN and one g in SI.
        self.assertAlmostEqual(Units("kg, mm, ms").si("force"), 1e3)
        self.assertAlmostEqual(Units("t, mm, s").si("stress"), 1e6)
        self.assertAlmostEqual(Units("kg, mm, ms").si("acceleration"), 1e3)
        with self.assertRaises(ValueError):
            Units("kg, mm")
        with self.assertRaises(ValueError):
            Units("").si("force")

    def test_tables(self):
        walls = self.result().history("rwforc")
        table = walls.to_structured()
        numpy.testing.assert_array_equal(table["normal"], walls["normal"])
        self.assertEqual(table.dtype.metadata["units"]["normal"], "kN")
        try:
            import pandas
        except ImportError:
            self.assertIsInstance(crumple.Result(self.folder / "out").table("rwforc"), numpy.ndarray)
            return
        frame = crumple.Result(self.folder / "out").table("rwforc")
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(frame.attrs["units"]["normal"], "kN")
        numpy.testing.assert_array_equal(frame["normal"], walls["normal"])

    def test_every_column_of_the_histories_has_a_kind(self):
        result = self.result()
        for name in result.history_names:
            for column, unit in result.history(name).units.items():
                if (name, column) != ("timestep", "kind"):
                    self.assertNotEqual(unit, "?", (name, column))

    def test_frames_are_the_state(self):
        states = []
        with crumple.Simulation(write_plate(self.folder), output=self.folder / "out") as simulation:
            simulation.run()
            states.append((simulation.node_ids, simulation.positions.copy(), simulation.displacements))
        result = crumple.Result(self.folder / "out")
        frames = result.frames
        self.assertEqual(len(frames), 11)
        self.assertEqual(frames[0].time, 0.0)
        last = frames[-1]
        self.assertAlmostEqual(last.time, simulation.time, 12)
        ids, positions, displacements = states[0]
        place = {node: k for k, node in enumerate(ids)}
        order = [place[node] for node in last.node_ids]
        numpy.testing.assert_allclose(last.points, positions[order], rtol=1e-6, atol=1e-6)
        numpy.testing.assert_allclose(last.displacements, displacements[order], rtol=1e-6, atol=1e-6)
        self.assertEqual(len(last.cells), 16)
        self.assertEqual(last.cell_data("part").tolist(), [7] * 16)
        self.assertEqual({len(cell) for cell in last.cells}, {4})
        shells = {tuple(sorted(last.node_ids[cell])) for cell in last.cells}
        deck = simulation.deck
        self.assertEqual(shells, {tuple(sorted(deck.node_ids[row])) for row in deck.elements()["nodes"]})
        with self.assertRaisesRegex(KeyError, "displacement"):
            last.point_data("stress")
        self.assertEqual(result.frame_at(0.021).time, frames[4].time)

    def test_damaged_frames_are_an_error(self):
        frame = self.result().frames[-1]
        data = frame.path.read_bytes()
        for damaged in (b"", b"text", data[:len(data) // 2], data[:-200] + bytes(200)):
            frame.path.write_bytes(damaged)
            with self.assertRaises(crumple.Error):
                fresh = crumple.Frame(frame.path, 0.0)
                fresh.displacements, fresh.points, [fresh.cell_data(name) for name in fresh.cell_names], fresh.cells
                fresh.node_ids

    def test_comparison_is_that_of_the_program(self):
        result = self.result()
        crumple.Simulation(crumple.Deck(write_plate(self.folder), {"thick": 1.3}), output=self.folder / "other").run()
        self.program("compare", self.folder / "out", self.folder / "other", "--json", self.folder / "c.json", "-q")
        self.assertEqual(result.compare(self.folder / "other"), json.loads((self.folder / "c.json").read_text()))
        same = result.compare(result, quantities=["rwforc.normal"])
        self.assertEqual([curve["difference"] for curve in same["curves"]], [0.0])
        with self.assertRaises(crumple.Error):
            result.compare(self.folder / "nowhere")

    def test_a_folder_without_results(self):
        with self.assertRaises(crumple.Error):
            crumple.Result(self.folder / "none")
        empty = crumple.Result(self.folder)
        self.assertFalse(empty.has_ended)
        for read in (lambda: empty.record, lambda: empty.frames, lambda: empty.history("glstat")):
            with self.assertRaises(crumple.Error):
                read()

    def test_a_run_that_still_writes_can_be_read(self):
        simulation = crumple.Simulation(write_plate(self.folder), output=self.folder / "out")
        simulation.run(until=0.02)
        result = crumple.Result(self.folder / "out")
        self.assertLessEqual(result.history("glstat")["time"][-1], simulation.time)
        with open(self.folder / "out/glstat.csv", "a") as stream:
            stream.write("0.5,1,2")  # half a row
        self.assertLessEqual(result.history("glstat")["time"][-1], simulation.time)


class ResponseTest(FolderTest):
    def setUp(self):
        super().setUp()
        crumple.Simulation(write_plate(self.folder), output=self.folder / "out").run()
        self.result = crumple.Result(self.folder / "out")

    def test_peak_mean_absorbed(self):
        walls = self.result.history("rwforc")
        self.assertEqual(crumple.peak("rwforc", "normal", wall=1)(self.result), numpy.abs(walls["normal"]).max())
        # The rows are means over their intervals, so the impulse is the change of momentum.
        whole = crumple.mean("glstat", "kinetic")(self.result)
        rows = self.result.history("glstat")
        self.assertAlmostEqual(whole * rows["time"][-1], numpy.trapz(rows["kinetic"], rows["time"]), 9)
        part = crumple.mean("glstat", "kinetic", start=0.0102, end=0.0307)(self.result)
        fine = numpy.linspace(0.0102, 0.0307, 200001)
        self.assertAlmostEqual(part, numpy.interp(fine, rows["time"], rows["kinetic"]).mean(), 6)
        self.assertEqual(crumple.absorbed()(self.result), rows["internal"][-1])
        self.assertAlmostEqual(crumple.absorbed(part=7)(self.result) / rows["internal"][-1], 1.0, 6)
        with self.assertRaisesRegex(ValueError, "select"):
            crumple.peak("nodout", "ux")(self.result)
        with self.assertRaisesRegex(ValueError, "no rows"):
            crumple.peak("rwforc", "normal", wall=2)(self.result)

    def test_filtered_peak(self):
        walls = self.result.history("rwforc")
        _, filtered = crumple.cfc_filter(walls["time"], walls["normal"], 1000, 1e-3)
        self.assertEqual(crumple.peak("rwforc", "normal", wall=1, cfc=1000)(self.result), numpy.abs(filtered).max())

    def test_intrusion(self):
        frames = self.result.frames
        node = 13
        moved = [frame.displacements[list(frame.node_ids).index(node)].astype(float) for frame in frames]
        self.assertAlmostEqual(crumple.intrusion(node)(self.result), max(map(numpy.linalg.norm, moved)), 12)
        down = crumple.intrusion(node, direction=(0, 0, -2))(self.result)
        self.assertAlmostEqual(down, max(-move[2] for move in moved), 12)
        self.assertAlmostEqual(crumple.intrusion(node, reference=node)(self.result), 0.0)
        both = crumple.intrusion([11, 13], direction=(0, 0, -1))(self.result)
        other = [frame.displacements[list(frame.node_ids).index(11)].astype(float) for frame in frames]
        self.assertAlmostEqual(both, max(-(a[2] + b[2]) / 2 for a, b in zip(moved, other)), 12)
        with self.assertRaisesRegex(ValueError, "999"):
            crumple.intrusion(999)(self.result)

    def test_hic_of_a_node(self):
        # From mm/ms^2 to g, and the filter by components: as by hand.
        rows = self.result.history("nodout").select(node=13)
        square = 0.0
        for name in ("ax", "ay", "az"):
            time, values = crumple.cfc_filter(rows["time"], rows[name], 1000, 1e-3)
            square = square + (values * 1e3 / 9.80665) ** 2
        self.assertAlmostEqual(crumple.hic_of_result(self.result, 13) / crumple.hic(1e-3 * time, numpy.sqrt(square)), 1.0, 12)
        self.assertGreater(crumple.hic_of_result(self.result, 13), 0)
        self.assertTrue(math.isfinite(crumple.hic_of_result(self.result, 13, window=0.036, cfc=0)))
        with self.assertRaises(ValueError):
            crumple.hic_of_result(self.result, 12)


if __name__ == "__main__":
    unittest.main()
