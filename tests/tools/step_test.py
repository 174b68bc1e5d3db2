# SPDX-License-Identifier: BSD-3-Clause
"""docs/step.md names the stages of the time step in the order of crumple/timeloop/step.cpp, and no others.

A stage is a call that acts. Calls of Simulation's own functions are followed; one of them that calls nothing that
acts is a stage itself. Calls that only answer (QUERIES), calls into std and declarations are no stages.
"""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "crumple"
QUERIES = {
    "begin", "blocks", "carried_energy", "chunks", "data", "empty", "end", "infinity", "joins_nodes",
    "keeps_previous_velocity", "kinetic_energy", "relative_speed", "size", "total",
}  # fmt: skip
KEYWORDS = {"for", "if", "return", "switch", "while"}
FUNCTION = r"^\w[^\n;{}]*?\b%s(\w+)\(([^;{}]*)\)(?: const)? \{\n(.*?)^\}"
CALL = re.compile(r"((?:\w+::)*)(?:(\w+)(?:\[[^\]]*\])?(?:\.|->))?(?<!\w)(\w+)\(")
DECLARATION = re.compile(r"(?:(?!return\b|else\b)\b\w+|>)[*&]? (\w+)\(")


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def code_of(text):
    """A source without comments and strings."""
    return re.sub(r'"(?:[^"\\]|\\.)*"', '""', without_comments(text))


def functions(text, scope=""):
    """Parameters and body of each function of a source, by name."""
    found = re.finditer(FUNCTION % re.escape(scope), code_of(text), re.M | re.S)
    return {match[1]: (match[2], match[3]) for match in found}


def classes(*texts):
    """The class of each variable in declarations, loops and parameters."""
    declared = r"(?:std::(?:vector|optional)<)?(?:\w+::)*(\w+)>?[*&]? (\w+)(?= *[;:=,)]|$)"
    return {match[2]: match[1] for text in texts for match in re.finditer(declared, text, re.M)}


def calls(body, kinds):
    """The calls that act, in order: `Class::function` where the class is known, else `function`."""
    body = re.sub(DECLARATION, " (", body)
    for spaces, receiver, name in CALL.findall(body):
        if name in KEYWORDS | QUERIES or spaces.startswith("std::"):
            continue
        yield f"{kinds[receiver]}::{name}" if receiver in kinds else name


class Step:
    """The stages of a step, read from the sources."""

    def __init__(self, source, header, parts=None):
        self.functions = functions(source, "Simulation::")
        self.members = classes(code_of(header))
        self.parts = {}
        for name, text in (parts or {}).items():
            own = functions(text)
            parameters, body = own[name]
            self.parts[name] = [c for c in calls(body, classes(parameters)) if c not in own]

    def functions_of_step(self):
        return list(calls(self.functions["step"][1], self.members))

    def stages(self, name):
        parameters, body = self.functions[name]
        kinds = self.members | classes(parameters, body)
        found = []
        for call in calls(body, kinds):
            found += (self.stages(call) or [call]) if call in self.functions else [call]
            found += self.parts.get(call, [])
        return found


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def documented(page):
    """The code names in the first column of the table below each heading that names a function."""
    found = {}
    for section in re.split(r"^## ", page, flags=re.M)[1:]:
        heading, _, text = section.partition("\n")
        name = re.search(r": `(\w+)`$", heading)
        if name:
            rows = [line for line in text.splitlines() if line.startswith("|")]
            if not rows or cells(rows[0])[0] != "stage":
                raise ValueError(f"{heading}: no table of stages")
            found[name[1]] = [code for row in rows[2:] for code in re.findall(r"`([^`]+)`", cells(row)[0])]
    return found


def names_in_tables(page):
    lines = [line for line in page.splitlines() if line.startswith("|")]
    codes = re.findall(r"`([^`]+)`", "\n".join(lines))
    return {name for code in codes for name in re.findall(r"[A-Za-z_]\w*", code)}


def differences(step, page):
    """What the page and the sources do not agree about."""
    found = documented(page)
    order = step.functions_of_step()
    wrong = [] if list(found) == order else [f"the step calls {order}, the page has {list(found)}"]
    for name in [name for name in order if name in found]:
        stages = step.stages(name)
        if stages != found[name]:
            wrong.append(f"{name} calls {stages}, the page has {found[name]}")
    return wrong


SOURCE = """
void Simulation::step() {
  drift();
  kick(0.5 * step_);
  energy = Walls::kinetic_energy(domain_);
}
void Simulation::drift() {
  const StageTimer timer(domain_.times.integrate);
  const Range range = move_nodes(domain_, step_);  // not_called(here)
  print("nor(here)");
}
void Simulation::kick(double interval) {
  if (walls_.empty()) return;
  join();
  sum();
  for (loads::Load& load : loads_) load.add(std::min(interval, 1.0));
  pairs_[0].part(domain_);
}
void Simulation::join() {
  sets_.constrain(domain_);
}
void Simulation::sum() {
  energy = kinetic_energy(domain_);
}
"""
HEADER = """
  constraints::NodeSets sets_;
  std::vector<contact::Pair> pairs_;
"""
PARTS = """
void help() {
}
void move_nodes(Trace* trace) {
  help();
  a.fill();
  trace->see();
}
"""
PAGE = """
## Positions: `drift`
| stage | reads | writes |
|---|---|---|
| `move_nodes`, then `print` | `position` | |
| the clock | | `time` |

## Velocities: `kick`
| stage | reads |
|---|---|
| `NodeSets::constrain`, `sum` | |
| `Load::add` | |
| `Pair::part` | |
"""


class StepTest(unittest.TestCase):
    def test_the_page_follows_the_sources(self):
        step = Step(
            (SOURCES / "timeloop" / "step.cpp").read_text(),
            (SOURCES / "timeloop" / "simulation.hpp").read_text(),
            {"add_element_forces": (SOURCES / "elements" / "element_forces.cpp").read_text()},
        )
        self.assertGreater(len(step.stages("kick")), 10)
        self.assertEqual(differences(step, (ROOT / "docs" / "step.md").read_text()), [])

    def test_every_name_in_the_tables_exists(self):
        files = [path for suffix in ("hpp", "cpp") for path in SOURCES.rglob(f"*.{suffix}")]
        known = set(re.findall(r"\w+", "\n".join(without_comments(path.read_text()) for path in files)))
        names = names_in_tables((ROOT / "docs" / "step.md").read_text())
        self.assertGreater(len(names), 50)
        self.assertEqual(sorted(names - known), [])


class CheckerTest(unittest.TestCase):
    def test_agreement(self):
        self.assertEqual(differences(Step(SOURCE, HEADER), PAGE), [])

    def test_stages_of_a_function_are_read_in_order(self):
        stages = Step(SOURCE, HEADER).stages("kick")
        self.assertEqual(stages, ["NodeSets::constrain", "sum", "Load::add", "Pair::part"])

    def test_parts_of_a_stage_follow_it(self):
        stages = Step(SOURCE, HEADER, {"move_nodes": PARTS}).stages("drift")
        self.assertEqual(stages, ["move_nodes", "fill", "Trace::see", "print"])

    def test_a_stage_in_the_sources_alone(self):
        source = SOURCE.replace("  join();", "  join();\n  pairs_.release(domain_);")
        self.assertEqual(len(differences(Step(source, HEADER), PAGE)), 1)
        source = SOURCE.replace("  drift();", "  drift();\n  choose_step();")
        self.assertEqual(len(differences(Step(source, HEADER), PAGE)), 1)

    def test_a_stage_in_the_page_alone(self):
        page = PAGE.replace("| `Pair::part` | |", "| `Pair::part` | |\n| `Pair::end` | |")
        self.assertEqual(len(differences(Step(SOURCE, HEADER), page)), 1)

    def test_another_order(self):
        page = PAGE.replace("`NodeSets::constrain`, `sum`", "`sum`, `NodeSets::constrain`")
        self.assertEqual(len(differences(Step(SOURCE, HEADER), page)), 1)

    def test_a_section_without_stages(self):
        with self.assertRaises(ValueError):
            documented("## Velocities: `kick`\n| reads | writes |\n|---|---|\n| `a` | |\n")

    def test_names_are_those_of_tables(self):
        self.assertEqual(names_in_tables("`text`\n| `A::b` | `c.d`, e |\n"), {"A", "b", "c", "d"})


if __name__ == "__main__":
    unittest.main()
