#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference sets of the second implementation: make.py FOLDER [--trials N]. Readings are made here from fixed
seeds; all results are computed in this folder from the formulas of the standards, with NumPy and mpmath, and share no
line with the program. --trials: of the simulations, 10⁶ for the sets that are kept, fewer to try the rest quickly."""
import argparse
import copy
import math
import os
import random
import sys
from fractions import Fraction

import mpmath
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import comparison
import jcgm101
import thermal
import trend
import typetest
from circular import Circle, Path
from common import EXACT, SECOND, Number, at_decimals, expected, fraction, mp, text_of, word
from positioning import DOWN, OF_LENGTH, UP, Axis, Trials, budget, contributions

SIMPLE, PROVEN, REJECTION = "simple acceptance", "ISO 14253-1", "rejection proven"
VARIANTS = {
    "proven": {"decisionRule.rule": PROVEN},
    "rejection": {"decisionRule.rule": REJECTION},
    "actual": {"decisionRule.rule": PROVEN, "uncertainty.method": "budgetActual"},
    "direct": {"decisionRule.rule": PROVEN, "uncertainty.method": "direct"},
    "simulated": {"decisionRule.rule": PROVEN, "uncertainty.method": "monteCarlo"},
}
WORDS = ("Readings from fixed seeds; results by a second implementation in Python (NumPy, mpmath), which was written from "
         "the formulas and shares no line with the program",
         "Relevés tirés de germes fixes ; résultats d’une seconde implémentation en Python (NumPy, mpmath), écrite d’après "
         "les formules et sans aucune ligne commune avec le programme")
SIMULATIONS = ("; each simulates with its own random numbers, tolerance after JCGM 101, 7.9.",
               " ; chacune simule avec ses propres nombres aléatoires, tolérance selon le JCGM 101, 7.9.")


def named(english, french, more=(".", ".")):
    """Name and origin of a set."""
    return {"name": {"en": english, "fr": french}, "origin": {"en": WORDS[0] + more[0], "fr": WORDS[1] + more[1]}}


def reading(value, decimals=4):
    return Number(f"{value:.{decimals}f}")


# --- axes ----------------------------------------------------------------------------------------------------------

# edition, first and last target, number of targets, runs ↑ and ↓, and what is special.
AXES = [
    ("ISO 230-2:1988", 0, 480, 6, 5, 5, {}),
    ("ISO 230-2:1988", 0, 960, 7, 5, 5, {"standardDeviation": "range"}),
    ("ISO 230-2:1988", -300, 300, 6, 5, 5, {"missing": [(2, 3), (7, 1), (4, 3)]}),
    ("ISO 230-2:1988", 0, 400, 5, 5, 0, {}),
    ("ISO 230-2:1988", 0, 270, 4, 5, 5, {"rotary": True}),
    ("ISO 230-2:1988", 0, 2500, 11, 1, 1, {}),
    ("ISO 230-2:1988", 0, 600, 6, 6, 6, {"aside": [(3, 2, "0.0954"), (8, 5, "-0.0611")]}),
    ("ISO 230-2:1997", 10, 510, 6, 5, 5, {"device": ("certificate", "1.2", "0", "2")}),
    ("ISO 230-2:1997", 0, 315, 8, 5, 5, {"rotary": True}),
    ("ISO 230-2:1997", 0, 400, 5, 0, 5, {}),
    ("ISO 230-2:2006", 0, 500, 6, 5, 5, {}),
    ("ISO 230-2:2006", 0, 500, 6, 2, 2, {}),
    ("ISO 230-2:2006", -450, -50, 5, 3, 3, {}),
    ("ISO 230-2:2006", 0, 300, 5, 10, 10, {}),
    ("ISO 230-2:2006", 0, 500, 6, 5, 4, {}),
    ("ISO 230-2:2006", 0, 700, 7, 6, 6, {"missing": [(2, 0), (5, 4)], "aside": [(4, 6, "0.2041")]}),
    ("ISO 230-2:2006", 50, 850, 6, 5, 5, {"here": True}),
    ("ISO 230-2:2006", 0, 3000, 13, 2, 2, {}),
    ("ISO 230-2:2006", 500, 2300, 9, 5, 5, {"zone": True, "travel": 3200}),
    ("ISO 230-2:2006", 0, 720, 17, 1, 1, {"rotary": True}),
    ("ISO 230-2:2006", 0, 500, 6, 5, 5, {"device": ("range", "0.8", "1.1", None), "driftModel": "linear"}),
    ("ISO 230-2:2014", 0, 500, 6, 5, 5, {"device": ("certificate", "0.3", "1.1", "1.96")}),
    ("ISO 230-2:2014", 0, 340, 9, 5, 5, {"rotary": True, "device": ("certificate", "0.9", "0", "2")}),
    ("ISO 230-2:2014", 0, 400, 5, 5, 0, {"length": "650"}),
    ("ISO 230-2:2014", 0, 600, 7, 5, 5, {"decimals": 3}),
    ("VDI/DGQ 3441:1977", 0, 500, 6, 5, 5, {}),
    ("VDI/DGQ 3441:1977", 0, 300, 4, 10, 10, {"scatter": 6}),
    ("GB/T 17421.2-2016", 0, 500, 6, 5, 5, {"scatter": 5}),
    ("JIS B 6190-2:2016", 0, 900, 6, 5, 5, {"oneRules": True}),
    ("GOST ISO 230-2-2016", 0, 500, 6, 5, 5, {"uncorrected": True}),
]


SIMULATED = {1, 2, 4, 5, 6, 8, 9, 11, 13, 16, 17, 21, 22, 26}  # numbers of axes


def made_axis(number, row):
    edition, first, last, count, up, down, special = row
    dice = random.Random(1000 + number)
    decimals = special.get("decimals", 4)
    rotary = special.get("rotary", False)
    scale = 1 / 3.6 if rotary else 1  # degrees: about as many arc seconds as others have µm
    step = Fraction(last - first, count - 1)
    targets = [float(first)] + [round(float(first + step * i) + dice.uniform(-0.02, 0.02) * float(step), 3)
                                for i in range(1, count - 1)] + [float(last)]
    slope, wave = dice.uniform(-8, 8), dice.uniform(1, 4)
    offset = [dice.uniform(-2, 4) for _ in targets]
    scatter = [special.get("scatter", 1) * dice.uniform(0.4, 1.4) for _ in targets]
    if special.get("oneRules"):
        slope, wave, scatter[3], offset = 0.3, 0.2, 9, [0.2] * count
    runs = []
    drift = dice.uniform(-1, 1)
    for j in range(max(up, down)):
        for way, n in ((UP, up), (DOWN, down)):
            if j < n:
                values = [scale / 1000 * (slope * i / count + wave * math.sin(2 * i) + (1 if way == UP else -1)
                                          * offset[i] / 2 + drift * j / 5 + dice.gauss(0, scatter[i]))
                          for i in range(count)]
                runs.append({"approach": way, "deviations": [reading(v, decimals + rotary) for v in values]})
    test = {"kind": "positioning", "id": f"a{number}", "edition": edition,
            "axis": {"name": "C" if rotary else "X", "motion": "rotary" if rotary else "linear",
                     "travel": float(special.get("travel", last - first))},
            "cycle": "standard", "targets": targets, "runs": runs}
    if "standardDeviation" in special:
        test["standardDeviation"] = special["standardDeviation"]
    if special.get("zone"):
        test["zone"] = {"from": float(first), "to": float(last)}
    for run, target in special.get("missing", []):
        runs[run]["deviations"][target] = None
    for run, target, value in special.get("aside", []):
        runs[run]["deviations"][target] = None
        test.setdefault("excluded", []).append({"run": run + 1, "target": target + 1, "value": Number(value),
                                                "reason": "beam interrupted"})
    correction = ("applied here" if special.get("here") else "not applied" if special.get("uncorrected")
                  else "not stated" if rotary else "applied by the instrument")
    sensors = [] if rotary else [{"measures": "machine", "position": "bed", "start": 22.5, "end": 22.5}]
    if special.get("here"):
        sensors = [{"measures": "machine", "position": "bed", "start": 22.1, "end": 23.3},
                   {"measures": "machine", "position": "slide", "start": 22.7, "end": 24.3},
                   {"measures": "instrument", "position": "scale", "start": 21.2, "end": 21.6}]
    test["conditions"] = {"sensors": sensors, "correctionTo20": correction}
    if not rotary:
        test["conditions"]["expansion"] = {"machine": 11.5, "instrument": 8.0 if special.get("here") else 0.0}
    kind, fixed, per_metre, factor = special.get("device", ("certificate", "0.9" if rotary else "0",
                                                            "0" if rotary else "1.5", "2"))
    device = {"kind": kind, "fixed": Number(fixed)} | ({} if rotary else {"perMetre": Number(per_metre)})
    if factor:
        device["coverageFactor"] = Number(factor)
    here = special.get("here", False)
    test["uncertainty"] = {"method": "budget", "device": device} | ({} if rotary else {
        "misalignmentRange": 1.0, "temperatureRange": {"machine": 0.7, "instrument": 0.4 if here else 0.0},
        "expansionRange": {"machine": 2.0, "instrument": 1.0 if here else 0.0}}) | {
        "environmentalVariation": 1.2 + number % 5 * 0.3, "driftModel": special.get("driftModel", "independent"),
        "trials": jcgm101.TRIALS_OF_PALMER if number in SIMULATED else 1, "seed": number}
    if "length" in special:
        test["uncertainty"]["length"] = Number(special["length"])
    return test


def verdict(value, limit, rule, guard):
    if rule == SIMPLE:
        return "conforms" if value <= limit else "doesNotConform"
    if value <= limit - guard:
        return "conforms"
    return "doesNotConform" if value > limit + guard else "notProven"


class Limits:
    """Limits of a test, at changing distances from the values, and the verdicts under every rule."""

    STEPS = (mpmath.mpf("1.6"), mpmath.mpf("-0.5"), mpmath.mpf("0.4"), mpmath.mpf("-1.7"), mpmath.mpf("0.7"))

    def __init__(self, test, number, values, u, decimals=4):
        self.test, self.values, self.u = test, values, u
        self.limit = {}
        direct = {}
        for k, name in enumerate(values):
            size = abs(values[name]) + self.STEPS[(number + k) % len(self.STEPS)] * u[name]
            limit = at_decimals(size, decimals)
            if limit > 0:
                self.limit[name] = limit
                direct[name] = Number(f"{float(u[name]) * self.unit() * (0.6 if k % 2 else 1.5):.2f}")
        test["limits"] = {self.key(name): {"value": limit} for name, limit in self.limit.items()}
        test["decisionRule"] = {"rule": SIMPLE, "guardFactor": (1.0, 0.83)[number % 2]}
        test["uncertainty"]["expanded"] = {self.key(name): value for name, value in direct.items()}
        self.direct = direct

    def unit(self):
        return 3600 if self.test.get("axis", {}).get("motion") == "rotary" else 1000

    @staticmethod
    def key(name):
        return name.split("_")[0]

    def verdicts(self, place, actual=None, proves=lambda name: True):
        guard = fraction(self.test["decisionRule"]["guardFactor"])
        rows = []
        for name, limit in self.limit.items():
            value, limit = abs(mp(self.values[name])), mp(fraction(limit.text))
            u = self.u[name]
            methods = [(None, SIMPLE, u), ("proven", PROVEN, u), ("rejection", REJECTION, u)]
            if actual is not None:
                methods.append(("actual", PROVEN, actual.get(name) or u))
            methods.append(("direct", PROVEN, mp(fraction(self.direct[name].text)) / self.unit()))
            for variant, rule, of_method in methods:
                found = verdict(value, limit, rule, mp(guard) * of_method)
                if rule != SIMPLE and not proves(name):
                    found = "notProven"
                rows.append(word(found, **place, **({"variant": variant} if variant else {}), parameter=name,
                                 of="verdict"))
        return rows


def simulated_rows(place, name, values, evaluated, budget_u):
    """What is expected of the simulation of a result; U is the budget's after a large shift."""
    found = jcgm101.simulated(values)
    rows = []
    for key in ("mean", "u", "low", "high"):
        value, tolerance = found[key]
        rows.append(expected(value, digits_of(tolerance), float(f"{tolerance:.2g}"), **place, variant="simulated",
                             parameter=name, of=key))
    u, tolerance = found["U"]
    shift = abs(found["mean"][0] - float(evaluated))
    if abs(shift - u / 3) > 3 * tolerance:
        if shift > u / 3:
            rows.append(expected(budget_u, **place, variant="simulated", parameter=name, of="expandedUncertainty"))
        else:
            rows.append(expected(u, digits_of(tolerance), float(f"{tolerance:.2g}"), **place, variant="simulated",
                                 parameter=name, of="expandedUncertainty"))
    return rows


def digits_of(tolerance):
    """Decimals down to a tenth of the tolerance."""
    return 1 - math.floor(math.log10(tolerance))


def axes(trials, rotary):
    tests, rows = [], []
    for number, row in enumerate(AXES, 1):
        if row[6].get("rotary", False) != rotary:
            continue
        test = made_axis(number, row)
        tests.append(test)
        place = {"test": len(tests)}
        axis = Axis(test)
        names = axis.results()
        values = {name: axis.result(name)[0] for name in names}
        parts = contributions(test)
        u = {name: budget(axis, name, parts) for name in names}
        actual = None if rotary else {name: budget(axis, name, parts, True) for name in names}
        limits = Limits(test, number, values, u, 5 if rotary else 4)
        for name in names:
            rows.append(expected(values[name], **place, parameter=name))
        for d, sign in ((UP, "+"), (DOWN, "-")):
            for i in axis.targets() if d in axis.ways else []:
                rows.append(expected(axis.mean[d][i], **place, statistic="mean" + sign, target=i + 1))
                if axis.s[d][i] is not None:
                    rows.append(expected(axis.s[d][i], **place, statistic="s" + sign, target=i + 1))
        for key, value in parts.items():
            rows.append(expected(value, **place, contribution=key))
        for name in names:
            rows.append(expected(u[name], **place, parameter=name, of="budget"))
            if actual and actual[name] is not None:
                rows.append(expected(actual[name], **place, parameter=name, of="budgetActual"))
        if len(set(len(x) for d in axis.ways for x in axis.readings[d])) == 1 and len(axis.readings[axis.ways[0]][0]) > 2:
            change, t = axis.drift()
            rows += [expected(change, **place, drift="change"), expected(t, 6, **place, drift="t")]
        proves = lambda name: not (row[6].get("uncorrected") and name in OF_LENGTH)
        rows += limits.verdicts(place, u if rotary else actual, proves)
        simulation = Trials(axis).run(names, trials, number) if number in SIMULATED else {}
        for name in simulation:
            rows += simulated_rows(place, name, simulation[name], values[name], u[name])
    name = ("Rotary axes", "Axes rotatifs") if rotary else ("Linear axes", "Axes linéaires")
    return {**named(*name, SIMULATIONS), "quantity": "angularDeviation" if rotary else "deviation",
            "variants": VARIANTS, "tests": tests, "expected": rows}


# --- circles -------------------------------------------------------------------------------------------------------

# plane, radius, points per arc, arcs (sense, from, to), and what is special.
CCW, CW = "counterclockwise", "clockwise"
FULL = [(CCW, 0, 360), (CW, 360, 0)]
CIRCLES = [
    ("XY", 150, 90, FULL, {}),
    ("XY", 100, 120, [(CW, 360, 0), (CCW, 0, 360)], {}),
    ("YZ", 50, 90, FULL, {"decimals": 3}),
    ("ZX", 300, 144, FULL, {"points": (144, 96)}),
    ("XZ", 150, 90, FULL, {}),
    ("XY", 150, 90, [(CCW, 0, 360)], {}),
    ("XY", 150, 90, [(CW, 200, -160)], {}),
    ("ZX", 150, 90, [(CCW, 0, 180), (CW, 180, 0)], {}),
    ("ZX", 120, 60, [(CCW, 10, 110), (CW, 110, 10)], {}),
    ("XY", 150, 90, FULL, {"commanded": (0.05, -0.03)}),
    ("YZ", 200, 90, FULL, {"commanded": (-0.2, 0.1)}),
    ("XY", 150, 30, FULL, {"referenceCircle": "leastSquares", "simulated": True}),
    ("YZ", 100, 24, FULL, {"referenceCircle": "leastSquares", "simulated": True, "here": True}),
    ("ZX", 150, 60, FULL, {"referenceCircle": "leastSquares", "sameSensor": True}),
    ("XY", 250, 36, [(CCW, 0, 360)], {"referenceCircle": "leastSquares", "simulated": True, "edition": "ISO 230-4:2022"}),
    ("XY", 150, 90, FULL, {"here": True}),
    ("XY", 150, 90, FULL, {"centring": "instrument"}),
    ("XY", 150, 90, FULL, {"source": "feedback"}),
    ("XY", 150, 90, FULL, {"edition": "ISO 230-4:1996"}),
    ("YZ", 150, 90, FULL, {"edition": "ISO 230-4:2022", "here": True}),
    ("XY", 150, 30, FULL, {"simulated": True}),
    ("ZX", 120, 24, [(CW, 190, -10), (CCW, -10, 190)], {"simulated": True}),
    ("YZ", 200, 30, FULL, {"simulated": True, "edition": "ISO 230-4:1996"}),
    ("XY", 100, 36, FULL * 4, {"repeated": True}),
    ("XZ", 150, 24, FULL * 3, {"repeated": True, "simulated": True}),
]


def made_circle(number, row):
    plane, radius, count, arcs, special = row
    dice = random.Random(2000 + number)
    scale, square, servo, lost = (dice.uniform(-5, 5) for _ in range(4))
    ripple = dice.uniform(0.2, 1)
    commanded = special.get("commanded")
    tests = []
    for k, (sense, start, end) in enumerate(arcs):
        n = special["points"][k] if "points" in special else count
        sign = 1 if sense == CCW else -1
        closed = abs(end - start) == 360
        angles = [start + (end - start) * i / (n - (not closed)) for i in range(n)]
        values = []
        for angle in angles:
            a = math.radians(angle)
            d = (scale * math.cos(2 * a) + square * math.sin(2 * a) + sign * servo * math.sin(2 * a) / 2
                 + sign * lost * math.copysign(1, math.sin(a + 1e-9)) * math.cos(a) / 2 + ripple * math.sin(9 * a)
                 + 1.5 * math.cos(a) + 0.8 * math.sin(a) + dice.gauss(0, 0.15)) / 1000
            if commanded:
                ex, ey = commanded
                across, along = ex * math.sin(a) - ey * math.cos(a), ex * math.cos(a) + ey * math.sin(a)
                d = math.hypot(radius + d - along, across) - radius
            values.append(reading(d, special.get("decimals", 5 if commanded else 4)))
        tests.append({"sense": sense, "angleReference": "commanded" if commanded else "polar",
                      "angles": [Number(f"{a:.4f}") for a in angles], "radialDeviations": values})
    here = special.get("here", False)
    test = {"kind": "circular", "id": f"c{number}", "edition": special.get("edition", "ISO 230-4:2005"),
            "plane": {"first": plane[0], "second": plane[1]}, "nominalRadius": float(radius), "feed": 1000.0,
            "source": special.get("source", "external"), "centring": special.get("centring", "leastSquares"),
            "referenceCircle": special.get("referenceCircle", "minimumZone"),
            "referenceLength": {"calibrated": True, "expandedUncertainty": 0.6, "coverageFactor": 2},
            "arcs": tests,
            "conditions": {
                "sensors": [{"measures": "machine", "position": "table", "start": 21.6 if here else 20.0,
                             "end": 22.2 if here else 20.0},
                            {"measures": "instrument", "position": "bar", "start": 21.1 if here else 20.0,
                             "end": 21.3 if here else 20.0}],
                "expansion": {"machine": 11.5, "instrument": 1.2},
                "correctionTo20": "applied here" if here else "not applied"},
            "uncertainty": {
                "method": "budget", "displacement": {"expanded": 0.0 if special.get("simulated") else 0.4,
                                                     "coverageFactor": 2},
                "resolution": 0.1, "pointNoise": 0.2,
                "repeatability": None if special.get("repeated") else 0.15 + number % 3 * 0.1,
                "environmentalVariation": 0.5 + number % 4 * 0.2, "centring": 0.4, "sameSensor": special.get("sameSensor",
                                                                                                           False),
                "temperatureStandardUncertainty": {"machine": 0.3, "instrument": 0.3 if special.get("sameSensor") else 0.2},
                "expansionStandardUncertainty": {"machine": 1.0, "instrument": 0.2},
                "trials": jcgm101.TRIALS_OF_PALMER if special.get("simulated") else 1, "seed": number}}
    return test


def circles(trials):
    tests, rows = [], []
    for number, row in enumerate(CIRCLES, 1):
        test = made_circle(number, row)
        tests.append(test)
        place = {"test": len(tests)}
        circle = Circle(test)
        values = {name: mpmath.mpf(str(value)) for name, value in circle.results().items()}
        u = {name: circle.uncertainty(name) for name in values}
        for name, value in values.items():
            # H: taken at the programmed angles, which the paths leave by some 10⁻¹⁰ rad.
            rows.append(expected(value, **({"tolerance": 1e-9} if name[0] == "H" else {}), **place, parameter=name))
        if circle.correction:
            rows.append(expected(circle.correction, **place, correction=True))
        for name in values:
            rows.append(expected(u[name], **place, parameter=name, of="budget"))
        # One limit holds for both paths: it is put at the first.
        limited = {}
        for name, value in values.items():
            if not name.startswith("F") and Limits.key(name) not in [Limits.key(one) for one in limited]:
                limited[name] = value
        limits = Limits(test, number, limited, u, 4)
        rows += limits.verdicts(place)
        if row[4].get("simulated"):
            simulation = circle.trials(trials, number)
            for name in values:
                rows += simulated_rows(place, name, simulation[name], values[name], u[name])
    return {**named("Circles", "Cercles", SIMULATIONS), "quantity": "deviation",
            "variants": {key: value for key, value in VARIANTS.items() if key != "actual"}, "tests": tests,
            "expected": rows}


# --- diagnosis -----------------------------------------------------------------------------------------------------

# Sources of the model: columns by θ, sense, radius (mm) and feed (mm/s), per unit shown, in µm.
COLUMNS = {
    ("scaleMismatch", None): lambda a, s, r, f: r / 1000 / 2 * np.cos(2 * a),
    ("squareness", None): lambda a, s, r, f: -r / 1000 / 2 * np.sin(2 * a),
    ("servoMismatch", None): lambda a, s, r, f: s * f / 2 * np.sin(2 * a),
    ("backlash", 0): lambda a, s, r, f: s * np.sign(np.sin(a)) * np.cos(a) / 2,
    ("backlash", 1): lambda a, s, r, f: -s * np.sign(np.cos(a)) * np.sin(a) / 2,
    ("lateralPlay", 0): lambda a, s, r, f: -s * np.abs(np.sin(a)) / 2,
    ("lateralPlay", 1): lambda a, s, r, f: s * np.abs(np.cos(a)) / 2,
    ("straightness", 0): lambda a, s, r, f: np.sin(3 * a) / 4,
    ("straightness", 1): lambda a, s, r, f: -np.cos(3 * a) / 4,
}
DIAGNOSES = [
    ("XY", 150, 1000, {("scaleMismatch", None): 40}),
    ("XY", 100, 1000, {("squareness", None): -35}),
    ("YZ", 150, 2000, {("servoMismatch", None): 0.6}),
    ("XY", 150, 1000, {("backlash", 0): 6, ("backlash", 1): -4}),
    ("ZX", 150, 1000, {("lateralPlay", 0): 3, ("lateralPlay", 1): 5}),
    ("XY", 300, 1500, {("straightness", 0): 8, ("straightness", 1): -6}),
    ("XY", 150, 3000, {("scaleMismatch", None): -25, ("squareness", None): 30, ("servoMismatch", None): -0.3}),
    ("YZ", 150, 1000, {("backlash", 0): -5, ("squareness", None): 20, ("lateralPlay", 1): 4}),
    ("XY", 50, 500, {("scaleMismatch", None): 60, ("backlash", 1): 3, ("straightness", 0): 5}),
    ("XY", 150, 1000, {("scaleMismatch", None): 30, ("squareness", None): -25, ("servoMismatch", None): 0.5,
                       ("backlash", 0): 4, ("backlash", 1): 6, ("lateralPlay", 0): -3, ("lateralPlay", 1): 2,
                       ("straightness", 0): 5, ("straightness", 1): -4}),
]
NOISE = 0.05  # µm, of every point
OF_MODEL = {"scaleMismatch": 0.02, "squareness": 0.01, "servoMismatch": 1e-4}  # what points about the centre leave


def diagnoses():
    tests, rows = [], []
    for number, (plane, radius, feed, sources) in enumerate(DIAGNOSES, 1):
        dice = random.Random(3000 + number)
        n, f = 720, feed / 60
        theta = np.radians(np.tile((np.arange(n) + 0.5) * 360 / n, 2))
        sense = np.repeat([1.0, -1.0], n)
        d = sum(value * COLUMNS[key](theta, sense, radius, f) for key, value in sources.items())
        # What the fit of all columns leaves uncertain with this noise: standard uncertainty of every source.
        columns = np.array([np.cos(theta), np.sin(theta), np.ones(2 * n)]
                           + [column(theta, sense, radius, f) for column in COLUMNS.values()])
        u = NOISE * np.sqrt(np.diag(np.linalg.inv(columns @ columns.T)))[3:]
        arcs = []
        for k, name in enumerate((CCW, CW)):
            order = np.arange(n) + k * n
            order = order if k == 0 else order[::-1]
            angles = [(i - k * n + 0.5) * 360 / n for i in order]
            arcs.append({"sense": name, "angles": [Number(f"{a:.2f}") for a in angles],
                         "radialDeviations": [reading((d[i] + dice.gauss(0, NOISE)) / 1000, 7) for i in order]})
        tests.append({"kind": "circular", "id": f"g{number}", "edition": "ISO 230-4:2005",
                      "plane": {"first": plane[0], "second": plane[1]}, "nominalRadius": float(radius),
                      "feed": float(feed), "arcs": arcs})
        for (key, axis), value in sources.items():
            tolerance = 4 * u[list(COLUMNS).index((key, axis))] + OF_MODEL.get(key, 2e-3)
            rows.append(expected(value, 3, float(f"{tolerance:.2g}"), EXACT, test=len(tests), influence=key,
                                 **({} if axis is None else {"axis": plane[axis]})))
    return {"name": {"en": "Diagnoses", "fr": "Diagnostics"}, "quantity": "number",
            "origin": {"en": "Circles made with sources of known size and a noise of 0.05 µm; tolerance: four standard "
                             "uncertainties that the noise leaves. In µm, µm/m, µrad, ms.",
                       "fr": "Cercles construits avec des causes de valeur connue et un bruit de 0,05 µm ; tolérance : "
                             "quatre incertitudes-types que laisse le bruit. En µm, µm/m, µrad, ms."},
            "tests": tests, "expected": rows}


# --- trends --------------------------------------------------------------------------------------------------------

def trends():
    made, rows = [], []
    for number in range(1, 11):
        dice = random.Random(4000 + number)
        count = (4, 4, 5, 6, 7, 8, 9, 12, 16, 5)[number - 1]
        shared = number % 3  # no shared parts, one device, several
        slope = dice.uniform(-0.5, 1.5)
        own = dice.uniform(0.2, 0.5)
        points = []
        for i in range(count):
            time = round(2018 + i * 8 / count + dice.uniform(0, 0.4), 3)
            parts = [] if shared == 0 else [{"source": "device" + (str(i % 2) if shared == 2 else ""),
                                             "u": round(dice.uniform(0.3, 0.7), 3)}]
            if shared == 2:
                parts.append({"source": "expansion", "u": round(dice.uniform(-0.5, 0.5), 3)})
            scatter = own * (3 if number % 2 else 0.5)
            points.append({"time": time, "value": round(12 + slope * (time - 2018) + dice.gauss(0, scatter), 4),
                           "own": round(own * dice.uniform(0.7, 1.3), 3), "shared": parts})
        item = {"points": points, "limit": round(12 + slope * 9 + 4, 1)}
        if number % 4 == 0:
            item["reserve"] = 0.8
        made.append(item)
        found = trend.line(points, item["limit"], item.get("reserve"))
        for key in ("level", "slope", "uLevel", "uSlope", "covariance", "scatter", "chi2PerDof"):
            rows.append(expected(found[key], 9, trend=key, test=number))
        rows.append(word("shown" if found["shown"] else "notShown", trend="statement", test=number))
        if found["notBefore"] is None:
            rows.append(word("beyond", trend="notBefore", test=number))
        else:
            rows.append(expected(found["notBefore"], 5, trend="notBefore", test=number))
    return {**named("Trends", "Tendances"), "quantity": "number",
            "trends": made, "expected": rows}


# --- drift tests and compensation ----------------------------------------------------------------------------------

def ranges(values, minutes):
    """Range of all values, one a minute, and the largest range within so many minutes."""
    known = [(i, fraction(v.text)) for i, v in enumerate(values) if v is not None]
    span = lambda some: max(some) - min(some)
    return span([v for _, v in known]), max(span([v for i, v in known if start <= i <= start + minutes])
                                            for start, _ in known)


def drift_tests():
    tests, rows = [], []
    for number in range(1, 6):
        dice = random.Random(5000 + number)
        count = (7, 12, 25, 40, 60)[number - 1]
        x, values = 0.0, []
        for i in range(count):
            x += dice.gauss(0.05, 0.3)
            values.append(reading(x / 1000, 5))
        tests.append({"kind": "drift", "id": f"d{number}", "axis": {"name": "X", "motion": "linear"},
                      "times": [float(60 * i) for i in range(count)], "deviations": values})
        span = max(map(fraction, (v.text for v in values))) - min(map(fraction, (v.text for v in values)))
        rows.append(expected(span, test=len(tests), drift="range"))
        test = made_axis(100 + number, ("ISO 230-2:2006", 0, 500, 6, 3 + number, 3 + number, {}))
        test["uncertainty"]["driftTest"] = f"d{number}"
        del test["uncertainty"]["environmentalVariation"]
        tests.append(test)
        axis = Axis(test)
        change, t = axis.drift()
        parts = contributions(test, span)
        place = {"test": len(tests)}
        rows += [expected(change, **place, drift="change"), expected(t, 6, **place, drift="t"),
                 expected(parts["environmentalVariation"], **place, contribution="environmentalVariation")]
        rows += [expected(budget(axis, name, parts), **place, parameter=name, of="budget") for name in axis.results()]
    # Several channels with gaps; of that of the axis, or of both axes of a plane, the largest range within the duration
    # of the test.
    for number, minutes, names in ((6, 10, "YX"), (7, 25, "YX"), (8, 15, "ZYX")):
        dice = random.Random(5000 + number)
        count, channels = 50 + 10 * number, []
        for name in names:
            x, values = 0.0, []
            for i in range(count):
                x += dice.gauss(0.02, 0.3)
                values.append(None if i % 17 == 5 else reading(x / 1000, 5))
            channels.append({"name": name, "quantity": "deviation", "values": values})
        tests.append({"kind": "drift", "id": f"d{number}", "axis": {"name": "X", "motion": "linear"},
                      "times": [float(60 * i) for i in range(count)], "channels": channels})
        spans = [ranges(channel["values"], minutes) for channel in channels]
        rows.append(expected(spans[-1][0], test=len(tests), drift="range"))
        span = max(within for _, within in spans[1:])
        if number == 8:
            test = made_circle(100 + number, ("XY", 150, 60, FULL, {}))
            test["uncertainty"]["driftTest"], test["duration"] = f"d{number}", float(minutes)
            del test["uncertainty"]["environmentalVariation"]
            tests.append(test)
            test = test | {"uncertainty": test["uncertainty"] | {"environmentalVariation": span * 1000}}
            circle = Circle(test)
            rows += [expected(circle.uncertainty(name), test=len(tests), parameter=name, of="budget")
                     for name in circle.results()]
            continue
        test = made_axis(100 + number, ("ISO 230-2:2006", 0, 500, 6, 5, 5, {}))
        test["uncertainty"]["driftTest"] = f"d{number}"
        test["duration"] = float(minutes)
        del test["uncertainty"]["environmentalVariation"]
        tests.append(test)
        axis = Axis(test)
        parts = contributions(test, span)
        place = {"test": len(tests)}
        rows.append(expected(parts["environmentalVariation"], **place, contribution="environmentalVariation"))
        rows += [expected(budget(axis, name, parts), **place, parameter=name, of="budget") for name in axis.results()]
    return {**named("Drift tests", "Essais de dérive"), "quantity": "deviation",
            "tests": tests, "expected": rows}


# format, perDirection, interval, reference
TABLES = [
    ("linuxcnc", True, None, None), ("csv", False, 50, None), ("siemens", False, 80, 160), ("weihong", True, None, None),
    ("csv", True, 75, None),
]


def compensations():
    """Table values: minus the mean deviation, linear between targets, to 0.1 µm; SINUMERIK: the deviation, counted from
    the reference point."""
    tests, rows = [], []
    for number, (form, per_direction, interval, reference) in enumerate(TABLES, 1):
        test = made_axis(200 + number, ("ISO 230-2:2006", 0, (480, 500, 480, 600, 450)[number - 1], 7, 5, 5, {}))
        tests.append(test)
        axis = Axis(test)
        p = axis.positions
        at = p if interval is None else [p[0] + interval * i for i in range(int((p[-1] - p[0]) / interval) + 1)]
        for way in (UP, DOWN):
            mean = axis.mean[way] if per_direction else [(a + b) / 2 for a, b in zip(axis.mean[UP], axis.mean[DOWN])]

            def correction(position):
                k = max(i for i in range(len(p) - 1) if p[i] <= position)
                return -(mean[k] + (mean[k + 1] - mean[k]) * (position - p[k]) / (p[k + 1] - p[k]))

            zero = correction(fraction(reference)) if reference is not None else 0
            for k, position in enumerate(at, 1):
                value = correction(position) - zero
                options = {"format": form, "perDirection": per_direction}
                if interval is not None:
                    options["interval"] = float(interval)
                if reference is not None:
                    options["reference"] = float(reference)
                rows.append(expected(value, 4, 1e-10 if not tie(value) else 1.01e-4, test=number, compensation=way,
                                     target=k, **options))
    return {**named("Compensation tables", "Tables de compensation"), "quantity": "deviation",
            "tests": tests, "expected": rows}


# --- comparison of two tests ---------------------------------------------------------------------------------------

# runs of each test, change of the slope in µm over the travel, edition
PAIRS = [
    (5, 5, 0, "ISO 230-2:2006"), (5, 3, 9, "ISO 230-2:2014"), (2, 2, -6, "ISO 230-2:2006"), (5, 5, -12, "ISO 230-2:1997"),
]


def comparisons(trials):
    tests, rows = [], []
    for number, (n_before, n_after, change, edition) in enumerate(PAIRS, 1):
        dice = random.Random(6000 + number)
        before = made_axis(300 + number, (edition, 0, 600, 7, n_before, n_before, {}))
        after = copy.deepcopy(before)
        before["id"], after["id"] = f"a{number}", f"b{number}"
        after["runs"] = [{"approach": run["approach"], "deviations": [
            reading(x + change / 1000 * i / 6 + dice.gauss(0, 0.0006)) for i, x in enumerate(run["deviations"])]}
            for run in after["runs"][:2 * n_after]]
        tests += [before, after]
        for name, (was, now, difference, u) in comparison.compared(before, after, trials, 7000 + number).items():
            place = {"test": len(tests), "comparison": name}
            rows.append(expected(difference, **place, of="difference"))
            rows.append(expected(u, 7, 0.015 * u + 1e-9, **place, of="U"))
            if abs(abs(difference) - u) > 0.03 * u:  # elsewhere chance decides
                rows.append(word(comparison.word(name, was, now, u), **place, of="word"))
    return {**named("Comparison of two tests", "Comparaison de deux essais", SIMULATIONS), "quantity": "deviation",
            "tests": tests, "expected": rows}


# --- acceptance sheet ----------------------------------------------------------------------------------------------

def sheet():
    """Rows of every kind under every rule; numbers as decimals, compared as exact fractions."""
    dice = random.Random(8001)
    rows, made = [], []
    for number in range(1, 25):
        low = fraction(f"{dice.uniform(-0.02, -0.01):.3f}") if number % 3 == 0 else None
        high = fraction(f"{dice.uniform(0.01, 0.03):.3f}")
        u = fraction(f"{dice.uniform(0.001, 0.004):.4f}")
        value = high + (-2 * u, -u, -u / 2, 0, u / 2, u, 2 * u)[number % 7]
        if low is not None and number % 2:
            value = low - (-2 * u, -u, 0, u, 2 * u)[number % 5]
        elif number % 4 == 1:
            value = -value
        text = lambda x: Number(f"{float(x):.6f}".rstrip("0"))
        row = {"number": f"G{number}", "permitted": text(high) if low is None else [text(low), text(high)],
               "uncertainty": text(u), "unit": "mm"}
        if number % 8:
            row["measured"] = text(value)
        if number % 11 == 0:
            row["notApplicable"] = "has none"
        made.append(row)
        for variant, rule in (("", SIMPLE), ("proven", PROVEN), ("rejection", REJECTION)):
            if number % 11 == 0:
                state = "notApplicable"
            elif number % 8 == 0:
                state = "notMeasured"
            elif low is None:
                state = verdict(abs(value), high, rule, u)
            else:
                order = ("conforms", "notProven", "doesNotConform")
                state = max(verdict(value, high, rule, u), verdict(-value, -low, rule, u), key=order.index)
            rows.append(word(state, sheet=f"G{number}", **({"variant": variant} if variant else {})))
    variants = {name: {"report.decisionRule.rule": rule} for name, rule in (("proven", PROVEN), ("rejection", REJECTION))}
    return {**named("Acceptance sheet", "Fiche de réception"), "report": {"sheet": made}, "variants": variants,
            "expected": rows}


# --- thermal responses and types -----------------------------------------------------------------------------------

def relative(value, tolerance, digits, **place):
    """A value that is checked relatively."""
    return {**place, "value": Number(mpmath.nstr(mp(value), digits)), "relativeTolerance": tolerance, "source": SECOND}


def responses():
    """τ is known to the root of the digits of S, which is flat at its least."""
    tests, rows = [], []
    step = 60.0
    for number, settled, gaps, k, tau in ((1, True, False, 3, 900), (2, False, False, 3, 900), (3, False, True, 5, 700),
                                          (4, True, True, -4, 1500)):
        dice = random.Random(6000 + number)
        t = np.arange(121) * step
        theta = np.round(20 + np.sin(t / 1500) + 0.4 * t / t[-1] + 0.2 * np.cos(t / 400), 3)
        x = (k * (thermal.delayed(theta, step, tau) - 20) + 2e-4 * t + (0 if settled else 1.5) * np.exp(-t / tau)
             + np.array([dice.gauss(0, 0.05) for _ in t]))
        values = [reading(v / 1000, 7) for v in x]
        for i in (7, 40, 41, 90) if gaps else ():
            values[i] = None
        tests.append({"kind": "drift", "id": f"r{number}", "axis": {"name": "X", "motion": "linear"}, "settled": settled,
                      "times": [float(v) for v in t], "channels": [{"name": "X", "quantity": "deviation", "values": values}],
                      "temperatures": [{"measures": "air", "values": [reading(v, 3) for v in theta]}]})
        found = thermal.response(np.array([math.nan if v is None else float(v.text) for v in values]), theta, step, settled)
        rows += [relative(value, 1e-4 if name == "slope" else 1e-5, 7, test=number, response=name)
                 for name, value in found.items()]
    return {**named("Thermal responses", "Réponses thermiques"), "quantity": "number", "tests": tests, "expected": rows}


def types():
    made, rows = [], []
    for number, (count, content, confidence) in enumerate(((3, "0.95", "0.95"), (8, "0.95", "0.95"), (12, "0.9", "0.95"),
                                                           (25, "0.99", "0.9")), 1):
        dice = random.Random(7000 + number)
        values = [Number(f"{5 * dice.lognormvariate(0, 0.6 if count == 25 else 0.3):.2f}") for _ in range(count)]
        made.append({"values": values, "content": Number(content), "confidence": Number(confidence)})
        rows += [relative(value, 1e-9, 12, test=number, typeTest=name)
                 for name, value in typetest.statistics([v.text for v in values], content, confidence).items()]
    return {**named("Types of machines", "Types de machines"), "quantity": "number", "types": made, "expected": rows}


def tie(value):
    """Whether rounding to 0.1 µm is a matter of the last bit."""
    scaled = abs(mp(value)) * 10000
    return abs(scaled - mpmath.floor(scaled) - mpmath.mpf("0.5")) < mpmath.mpf("1e-6")


def sets(trials):
    return {"linear-axes": lambda: axes(trials, False), "rotary-axes": lambda: axes(trials, True),
            "circles": lambda: circles(trials), "diagnoses": diagnoses, "trends": trends, "drift-tests": drift_tests,
            "compensation": compensations, "comparisons": lambda: comparisons(trials),
            "sheet": sheet, "responses": responses, "types": types}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("--trials", type=int, default=1000000)
    parser.add_argument("--only")
    chosen = parser.parse_args()
    for name, make in sets(chosen.trials).items():
        if chosen.only and name != chosen.only:
            continue
        item = {"format": "palmer reference data", "version": 1} | make()
        with open(os.path.join(chosen.folder, name + ".json"), "w", encoding="utf-8") as file:
            file.write(text_of(item) + "\n")
        print(name, len(item["expected"]))


if __name__ == "__main__":
    main()
