# SPDX-License-Identifier: BSD-3-Clause
"""Decks from Python: tables, diagnostics, parameters; all as the program says it."""
import json
import unittest

import numpy

import crumple
from small_deck import write_plate
from support import ROOT, FolderTest


class DeckTest(FolderTest):
    def test_tables_of_nodes_elements_and_parts(self):
        deck = crumple.Deck(write_plate(self.folder))
        self.assertTrue(deck.ok)
        numpy.testing.assert_array_equal(deck.node_ids, numpy.arange(11, 36))
        numpy.testing.assert_array_equal(deck.positions[7], [10.0, 5.0, 0.1 + 0.6])
        shells = deck.elements("shell")
        numpy.testing.assert_array_equal(shells["id"], numpy.arange(101, 117))
        numpy.testing.assert_array_equal(shells["part"], numpy.full(16, 7))
        numpy.testing.assert_array_equal(deck.node_ids[shells["nodes"][5]], [17, 18, 23, 22])
        self.assertEqual(deck.elements("solid")["nodes"].shape, (0, 8))
        self.assertEqual(deck.parts, [{"id": 7, "title": "plate", "kind": "shell", "rigid": False, "elements": 16}])
        self.assertEqual((deck.units, deck.title, deck.end_time), ("kg, mm, ms", "a plate falls on a wall", 0.05))
        with self.assertRaises(ValueError):
            deck.elements("quad")

    def test_positions_are_a_view_that_outlives_the_deck(self):
        positions = crumple.Deck(write_plate(self.folder)).positions
        self.assertFalse(positions.flags.owndata)
        with self.assertRaises(ValueError):
            positions[0, 0] = 1.0
        self.assertEqual(positions[24, 0], 20.0)

    def test_diagnostics_name_keyword_card_and_field(self):
        path = write_plate(self.folder, **{"       0.3      0.25": "      0.3x      0.25"})
        deck = crumple.Deck(path)
        self.assertFalse(deck.ok)
        errors = [item for item in deck.check() if item.severity == "error"]
        self.assertEqual(len(errors), 1)
        first = errors[0]
        line = path.read_text().split("\n").index("*MAT_PLASTIC_KINEMATIC") + 2
        self.assertEqual((first.file, first.line, first.keyword, first.card, first.field),
                         (str(path), line, "*MAT_PLASTIC_KINEMATIC", 1, "PR"))
        self.assertIn('read "0.3x"', first.message)
        code, _, console = self.program("check", path)
        self.assertEqual(code, 1)
        self.assertIn(str(first), console.splitlines())
        with self.assertRaises(crumple.DeckError) as raised:
            crumple.Simulation(deck)
        self.assertIn(str(first), str(raised.exception))
        with self.assertRaises(crumple.DeckError):
            deck.positions

    def test_diagnostics_are_those_of_check_json_for_all_faulty_decks(self):
        for path in sorted((ROOT / "tests/deck/bad").glob("*.k"))[::10]:
            with self.subTest(path.name):
                answer = json.loads(self.program("check", "--json", path)[1])
                deck = crumple.Deck(path)
                ours = [{name: getattr(item, name) for name in answer["messages"][0]} for item in deck.diagnostics] \
                    if answer["messages"] else []
                self.assertEqual(ours, answer["messages"])
                self.assertEqual(deck.ok, answer["can_run"])

    def test_a_missing_deck_is_a_diagnostic(self):
        deck = crumple.Deck(self.folder / "none.k")
        self.assertFalse(deck.ok)
        self.assertIn("none.k", str(deck.check()[0]))

    def test_parameters_go_before_those_of_the_deck(self):
        path = write_plate(self.folder)
        deck = crumple.Deck(path, {"thick": 1.25})
        self.assertEqual(deck.parameters["THICK"], ("1.25", "command line"))
        self.assertEqual(deck.parameters["SPEED"][1], "deck")
        self.assertNotEqual(deck.hash, crumple.Deck(path).hash)

    def test_parameters_that_the_deck_does_not_have_are_refused_with_the_words_of_the_console(self):
        path = write_plate(self.folder)
        with self.assertRaises(crumple.DeckError) as raised:
            crumple.Deck(path, {"thik": 1.25})
        _, _, console = self.program("run", path, "-P", "thik=1.25", "-o", self.folder / "out")
        self.assertIn("did you mean THICK?", str(raised.exception))
        self.assertIn(str(raised.exception), console)

    def test_parameters_without_use_and_what_is_no_number_are_refused(self):
        path = write_plate(self.folder, **{"&thick": "       1.0"})
        with self.assertRaises(crumple.DeckError) as raised:
            crumple.Deck(path, {"thick": 1.25})
        self.assertIn("never uses &THICK", str(raised.exception))
        with self.assertRaises(crumple.DeckError):
            crumple.Deck(path, {"speed": "fast"})
        with self.assertRaises(TypeError):
            crumple.Deck(path, {"speed": True})


if __name__ == "__main__":
    unittest.main()
