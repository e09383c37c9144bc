#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the second implementation again, with fewer trials, and compares what it makes with the sets that are kept: tests,
values and words are the same, simulated numbers within what fewer trials allow. Arguments: resources/reference/second,
number of trials."""
import json
import pathlib
import subprocess
import sys
import tempfile

kept = pathlib.Path(sys.argv[1])
trials = int(sys.argv[2])
KEPT_TRIALS = 1000000
SIMULATED = {"mean", "u", "low", "high", "expandedUncertainty"}


def is_simulated(row):
    return row.get("variant") == "simulated" and row.get("of") in SIMULATED or "comparison" in row and row["of"] == "U"


def place(row):
    return json.dumps({key: row[key] for key in row if key not in ("value", "tolerance")}, sort_keys=True)


def main():
    faults, compared = [], 0
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["/usr/bin/python3", "-B", kept / "make.py", folder, "--trials", str(trials)], check=True)
        for file in sorted(kept.glob("*.json")):
            old = json.loads(file.read_text(encoding="utf-8"))
            new = json.loads((pathlib.Path(folder) / file.name).read_text(encoding="utf-8"))
            for key in old.keys() - {"expected"}:
                if old[key] != new[key]:
                    faults.append(f"{file.name}: {key}")
            made = {place(row): row for row in new["expected"]}
            for row in old["expected"]:
                again = made.pop(place(row), None)
                compared += again is not None
                if is_simulated(row):
                    # Near a large shift the U of which method decides is open with few trials.
                    allowed = row["tolerance"] * (KEPT_TRIALS / trials) ** 0.5
                    if again is not None and abs(row["value"] - again["value"]) > allowed:
                        faults.append(f"{file.name}: {place(row)}: {row['value']}, again {again['value']}")
                elif again is None or (row["value"], row.get("tolerance")) != (again["value"], again.get("tolerance")):
                    faults.append(f"{file.name}: {place(row)}")
            faults += [f"{file.name}: new {key}" for key, row in made.items() if not is_simulated(row)]
    print(compared, "values compared")
    print("\n".join(faults))
    sys.exit(1 if faults or compared < 2000 else 0)


main()
