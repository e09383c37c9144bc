# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The package palmer against what palmer-cli itself says. PALMER_CLI and PYTHONPATH are set; argument: the sources."""
import json
import os
import runpy
import shutil
import subprocess
import sys
import tempfile
import unittest

import palmer

source = sys.argv.pop()
examples = source + "/resources/examples/"
folder = tempfile.mkdtemp()


def cli(*words):
    return subprocess.run([os.environ["PALMER_CLI"], *words], capture_output=True, encoding="utf-8", check=False)


class PalmerTest(unittest.TestCase):
    def test_results_are_those_of_evaluate(self):
        for name in sorted(os.listdir(examples)):
            frame = palmer.evaluate(examples + name).results
            told = [row for test in json.loads(cli("evaluate", examples + name, "--json").stdout)["tests"]
                    for row in test["parameters"]]
            self.assertEqual(list(frame["id"]), [row["id"] for row in told], name)
            self.assertEqual([None if value != value else value for value in frame["value"]],
                             [row["value"] for row in told])
            self.assertLessEqual(set(frame["unit"]), {"mm", "deg"})

    def test_targets_follow_from_the_readings(self):
        axis = palmer.evaluate(examples + "rotary-axis.palmer")
        readings = axis.readings
        means = readings[readings["approach"] == "positive"].groupby("position")["deviation"].mean()
        for _, target in axis.targets.iterrows():
            self.assertAlmostEqual(means[target["target"]], target["meanPositive"], 12)
        self.assertEqual(set(axis.targets["unit"]), {"deg"})
        self.assertEqual(set(readings["unit"]), {"deg"})
        self.assertFalse(len(axis.diagnosis))

    def test_circles_have_a_diagnosis(self):
        file = folder + "/circle.palmer"
        cli("synthesize", "circular", "--source", "squareness=30", "--noise", "0.1", "-o", file)
        circle = palmer.evaluate(file)
        squareness = circle.diagnosis.set_index("id").loc["squareness"]
        self.assertAlmostEqual(squareness["value"], 30, delta=0.5)
        self.assertEqual(squareness["unit"], "µrad")
        self.assertEqual(len(circle.readings), 3600)
        self.assertEqual(circle.readings.attrs["units"]["angle"], "deg")
        self.assertEqual(list(circle.tests["kind"]), ["circular"])
        self.assertTrue(len(circle.findings) and set(circle.findings["grade"]) <= {"requirement", "recommendation", "note"})

    def test_a_drift_record_has_its_channels(self):
        file = folder + "/drift.palmer"
        cli("synthesize", "drift", "--source", "straight:X=5", "--source", "straight:Y=2", "--hours", "0.1", "-o", file)
        readings = palmer.evaluate(file).readings
        self.assertEqual({name: len(part) for name, part in readings.groupby("channel")}, {"X": 7, "Y": 7})
        self.assertAlmostEqual(readings[readings["channel"] == "X"]["deviation"].max(), 0.0005, 9)

    def test_a_measurement_wants_answers(self):
        data = source + "/doc/x-axis.csv"
        open_question = folder + "/without-unit.csv"
        with open(open_question, "w", encoding="utf-8") as file:
            file.write("Target;1+;1-\n0;1;2\n100;2;3\n200;3;4\n300;3;5\n400;4;6\n")
        with self.assertRaises(palmer.PalmerError) as refused:
            palmer.evaluate(open_question)
        self.assertEqual(refused.exception.exit, 3)
        self.assertIn("question", str(refused.exception))
        frame = palmer.evaluate(data, accept=True, settings=["limits.A.value=20um"]).results.set_index("id")
        self.assertEqual(frame.loc["A", "limit"], 0.02)
        with self.assertRaises(palmer.PalmerError) as refused:
            palmer.evaluate(data, accept=True, settings=["machine.nam=x"])
        self.assertEqual(refused.exception.exit, 2)

    def test_trends_come_from_a_register(self):
        tests, register = folder + "/tests", folder + "/r.sqlite"
        os.mkdir(tests)
        for year in (2024, 2025):
            done = cli("import", source + "/doc/x-axis.csv", "--accept", "--set", "axis=X", "--set",
                       "machine.serialNumber=7", "--set", f"tests[0].date={year}-05-01", "--set",
                       f"tests[0].runs[0].deviations[0]=0.00{year - 2020}mm", "-o", f"{tests}/{year}.palmer")
            self.assertEqual(done.returncode, 0, done.stderr)
        cli("import", source + "/doc/x-axis.csv", "--accept", "--set", "axis=X", "--set", "machine.serialNumber=9",
            "-o", f"{tests}/undated.palmer")
        cli("register", "scan", tests, "--register", register)
        frame = palmer.trend("7", "X", "A", register=register)
        self.assertEqual(list(frame["date"].dt.year), [2024, 2025])
        self.assertEqual(set(frame["unit"]), {"mm"})
        self.assertIsNone(frame.attrs["line"])  # two tests
        with self.assertRaises(palmer.PalmerError):
            palmer.trend("8", "X", "A", register=register)
        undated = palmer.trend("9", "X", "A", register=register)
        self.assertEqual((len(undated), set(undated) >= {"date", "value", "U"}), (0, True))

    def test_the_notebook_runs(self):
        with open(source + "/doc/palmer.ipynb", encoding="utf-8") as file:
            notebook = json.load(file)
        code = [line for cell in notebook["cells"] if cell["cell_type"] == "code" for line in cell["source"]]
        self.assertLessEqual(len([line for line in code if line.strip()]), 10)
        shutil.copytree(examples, folder + "/examples")
        os.chdir(folder)
        script = folder + "/notebook.py"
        with open(script, "w", encoding="utf-8") as file:
            file.write("\n".join("".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"))
        values = runpy.run_path(script)
        self.assertTrue(len(values["worst"]))


if __name__ == "__main__":
    unittest.main()
