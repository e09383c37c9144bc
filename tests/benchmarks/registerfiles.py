#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes test files of many machines over eight years, to try a register with: made-up data whose truth is known.

    registerfiles.py FOLDER [--files 10000] [--machines 30] [--circles] [--seed 1]

Each file holds one test of an axis, 11 targets, 5 runs each way (with --circles each fourth test is a circle). Each axis
drifts at its own pace; each machine has a collision, a repair and a compensation. Instruments are calibrated every year.
"""
import argparse
import datetime
import json
import math
import os
import random

START = datetime.date(2018, 11, 20)
DAYS = 8 * 365


def conditions(feed, theta):
    return {
        "feed": feed, "feedMode": "programmed", "dwell": 3.0,
        "warmUp": {"kind": "dryRun", "text": "30 min", "specifiedBy": "agreement"},
        "otherAxes": "middle of travel", "levelled": True, "complete": True, "unloaded": True, "shielded": True,
        "stabilised": True, "soak": "12 h", "instrumentCompensation": "on", "temperatureControlled": False,
        "sensors": [{"measures": "machine", "position": "scale", "start": theta, "end": theta + 0.2},
                    {"measures": "instrument", "position": "laser head", "start": theta, "end": theta},
                    {"measures": "air", "position": "beam", "start": theta, "end": theta}],
        "expansion": {"machine": 11.0, "instrument": 0.0}, "correctionTo20": "applied by the instrument",
        "gradientPerHour": 0.3, "gradientHoursBefore": 12,
    }


def positioning(rng, axis, length, level, edition, theta):
    """A test whose E is about `level` mm."""
    targets = [round(i * length / 10 + (rng.uniform(-3, 3) if 0 < i < 10 else 0), 3) for i in range(11)]
    wave = [math.sin(i * 0.7) * level * 0.25 + level * 0.5 * i / 10 for i in range(11)]
    runs = []
    for run in range(5):
        for approach, sign in (("positive", 0.5), ("negative", -0.5)):
            runs.append({"approach": approach,
                         "deviations": [round(w + sign * level * 0.15 + rng.gauss(0, level * 0.03), 6) for w in wave]})
    return {
        "kind": "positioning", "edition": edition,
        "axis": {"name": axis, "motion": "linear", "travel": length + 20, "positionFeedback": "linear scale"},
        "cycle": "standard", "targets": targets,
        "targetChoice": {"kind": "free", "interval": length / 10, "period": 5.0}, "runs": runs,
        "conditions": conditions(6000.0, theta),
        "limits": {"A": {"value": 0.016, "source": "acceptance"}, "E": {"value": 0.013, "source": "acceptance"},
                   "R": {"value": 0.008, "source": "acceptance"}, "B": {"value": 0.004, "source": "acceptance"}},
        "uncertainty": {"method": "budget",
                        "device": {"kind": "certificate", "fixed": 0.1, "perMetre": 0.8, "coverageFactor": 2},
                        "misalignmentRange": 0.5, "temperatureRange": {"machine": 0.2, "instrument": 0.1},
                        "expansionRange": {"machine": 2.0, "instrument": 0.0}, "environmentalVariation": 0.6,
                        "driftModel": "independent"},
    }


def circular(rng, level, points=120):
    arcs = []
    for sense, step in (("counterclockwise", 1), ("clockwise", -1)):
        angles = [round(step * i * 360 / points, 4) for i in range(points + 1)]
        arcs.append({"sense": sense, "angleReference": "polar", "angles": angles,
                     "radialDeviations": [round(level * 0.3 * math.sin(math.radians(2 * a)) +
                                                step * level * 0.1 + rng.gauss(0, level * 0.01), 6) for a in angles]})
    return {
        "kind": "circular", "edition": "ISO 230-4:2005", "plane": {"first": "X", "second": "Y"}, "nominalRadius": 150.0,
        "feed": 1000.0, "arcs": arcs, "limits": {"G(b)": {"value": 0.014, "source": "acceptance"}},
        "conditions": {key: value for key, value in conditions(0, 20.0).items()
                       if key not in ("feed", "feedMode", "dwell", "gradientPerHour", "gradientHoursBefore")},
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--files", type=int, default=10000)
    parser.add_argument("--machines", type=int, default=30)
    parser.add_argument("--circles", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    axes = ["X", "Y", "Z"] + (["XY"] if options.circles else [])
    written = 0
    for machine in range(options.machines):
        rng = random.Random(options.seed * 1000 + machine)
        share = options.files // options.machines + (machine < options.files % options.machines)
        campaigns = -(-share // len(axes))
        slopes = {axis: rng.uniform(-0.0001, 0.0012) for axis in axes}
        collision = rng.randrange(campaigns // 3, max(2 * campaigns // 3, campaigns // 3 + 1))
        folder = os.path.join(options.folder, "machine %03d" % (machine + 1))
        os.makedirs(folder, exist_ok=True)
        since, base = 0.0, 0.009
        for campaign in range(campaigns):
            years = campaign / max(campaigns - 1, 1) * DAYS / 365.25
            date = START + datetime.timedelta(days=round(years * 365.25))
            purpose, role, jump = "periodic", "asFound", 0.0
            if campaign == 0:
                purpose, role = "acceptance", "notStated"
            elif campaign == collision:
                purpose, jump = "afterCollision", 0.008
            elif campaign == collision + 1:
                purpose, role, since, base = "afterRepair", "asLeft", years, 0.0085
            year = (date - START).days // 365
            for axis in axes:
                if share == 0:
                    break
                share -= 1
                level = max(0.002, base + slopes[axis] * (years - since) + jump + rng.gauss(0, 0.0002))
                edition = "ISO 230-2:1988" if years < 1.5 else "ISO 230-2:2014"
                theta = round(20 + rng.gauss(0, 0.6), 2)
                test = circular(rng, level) if axis == "XY" else positioning(
                    rng, axis, {"X": 1000.0, "Y": 600.0, "Z": 500.0}[axis], level, edition, theta)
                test.update({"id": axis.lower(), "title": "%s, %s" % (axis, purpose), "date": date.isoformat(),
                             "time": "09:30", "instruments": ["laser"], "purpose": purpose, "role": role})
                document = {
                    "format": "palmer test report", "version": 2,
                    "report": {"number": "R-%06d" % written, "languages": ["fr", "en"],
                               "laboratory": {"name": "Test laboratory"}},
                    "machine": {"name": "Machine %03d" % (machine + 1), "manufacturer": "Maker %s" % "ABC"[machine % 3],
                                "model": "CU 1000", "serialNumber": "000-%03d" % (machine + 1) if machine % 15 != 14 else "",
                                "location": "Hall %d" % (machine % 4 + 1)},
                    "instruments": [{"id": "laser", "description": "laser interferometer", "serialNumber": "LSR-%d" % (machine % 4),
                                     "certificate": "C-%d-%d" % (machine % 4, year), "resolution": 0.0001,
                                     "calibrationDate": (START + datetime.timedelta(days=365 * year)).isoformat(),
                                     "calibrationDue": (START + datetime.timedelta(days=365 * (year + 1) + 60)).isoformat()}],
                    "tests": [test]}
                with open(os.path.join(folder, "%s %s.palmer" % (date.isoformat(), axis)), "w") as file:
                    json.dump(document, file)
                written += 1
    print("%d files" % written)


if __name__ == "__main__":
    main()
