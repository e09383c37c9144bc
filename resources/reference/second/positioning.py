# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Axes: ISO 230-2 and VDI/DGQ 3441, in exact fractions and 50 digits; the budget after Annex A, combined by propagation
(GUM); the propagation of distributions (JCGM 101) with NumPy. Written from the formulas, target by target."""
from fractions import Fraction

import mpmath
import numpy as np

from common import fraction, mp, root

UP, DOWN = "positive", "negative"
SIGN = {UP: "+", DOWN: "-"}
RANGE_FACTORS = {2: "1.128", 3: "1.693", 4: "2.059", 5: "2.326", 6: "2.534", 7: "2.704", 8: "2.847", 9: "2.970",
                 10: "3.078"}  # k(n) of the 1988 edition
# Arithmetic of an edition: c, and its results.
NINETEEN = ("A", "A+", "A-", "R", "R+", "R-", "Bmean", "r", "r+", "r-")
LATER = ("A", "A+", "A-", "R", "R+", "R-", "B", "Bmean", "E", "E+", "E-", "M")
VDI = ("P", "Pa", "Psmax", "Psmean", "Umax", "Umean")
EDITIONS = {
    "ISO 230-2:1988": (3, NINETEEN), "ISO 230-2:1997": (2, LATER), "ISO 230-2:2006": (2, LATER),
    "ISO 230-2:2014": (2, LATER + ("UPR",)), "VDI/DGQ 3441:1977": (3, VDI), "GB/T 17421.2-2000": (2, LATER),
    "GB/T 17421.2-2016": (2, LATER), "GB/T 17421.2-2023": (2, LATER + ("UPR",)), "JIS B 6190-2:2008": (2, LATER),
    "JIS B 6190-2:2016": (2, LATER + ("UPR",)), "GOST ISO 230-2-2016": (2, LATER + ("UPR",)),
}
NEEDS_S = {"A", "A+", "A-", "R", "R+", "R-", "r", "r+", "r-", "UPR", "P", "Psmax", "Psmean"}
OF_LENGTH = {"A", "A+", "A-", "E", "E+", "E-", "M", "P", "Pa"}  # S counts


class Axis:
    """A test of a file and its statistics. Deviations in mm (degrees) as fractions."""

    def __init__(self, test):
        self.test = test
        self.c, self.names = EDITIONS[test["edition"]]
        self.positions = [fraction(p) for p in test["targets"]]
        self.corrections = correction(test, self.positions)
        self.readings = {d: [[] for _ in self.positions] for d in (UP, DOWN)}
        for run in test["runs"]:
            for i, x in enumerate(run["deviations"]):
                if x is not None:
                    self.readings[run["approach"]][i].append(fraction(x) + self.corrections[i])
        self.ways = [d for d in (UP, DOWN) if any(self.readings[d])]
        self.n = {d: [len(x) for x in self.readings[d]] for d in self.ways}
        self.mean = {d: [sum(x) / len(x) for x in self.readings[d]] for d in self.ways}
        self.s = {d: [self.deviation(x) for x in self.readings[d]] for d in self.ways}

    def deviation(self, x):
        """s: mpf; None for one reading."""
        if len(x) < 2:
            return None
        if self.test.get("standardDeviation") == "range":
            return mp((max(x) - min(x)) / fraction(RANGE_FACTORS[len(x)]))
        m = sum(x) / len(x)
        return root(sum((one - m) ** 2 for one in x) / (len(x) - 1))

    def targets(self):
        return range(len(self.positions))

    def results(self):
        """Ids of the edition that this test has."""
        single = max(max(n) for n in self.n.values()) == 1
        names = [name for name in self.names if not (single and name in NEEDS_S)]
        if len(self.ways) == 1:
            sign = SIGN[self.ways[0]]
            names = [name for name in names if name.endswith(sign)]
        return names

    # Every result is a list of candidates (value, statistics it is made of), of which the largest rules.
    # Statistics: (kind, direction, target, factor), kind "x" of a mean, "s" of a standard deviation.

    def ends(self, ways, upper):
        """Mean ± c·s of all targets, mean where c is None."""
        return [(mp(self.mean[d][i]) + upper * self.c * self.s[d][i],
                 [("x", d, i, 1), ("s", d, i, self.c)]) for i in self.targets() for d in ways]

    def span(self, high, low):
        top = max(high, key=lambda e: e[0])
        bottom = min(low, key=lambda e: e[0])
        return top[0] - bottom[0], top[1], bottom[1]

    def means(self, ways):
        return [(mp(self.mean[d][i]), [("x", d, i, 1)]) for i in self.targets() for d in ways]

    def both_means(self):
        return [(mp((self.mean[UP][i] + self.mean[DOWN][i]) / 2),
                 [("x", UP, i, Fraction(1, 2)), ("x", DOWN, i, Fraction(1, 2))]) for i in self.targets()]

    def reversal(self, i):
        return self.mean[UP][i] - self.mean[DOWN][i]

    def repeatability(self, d, i):
        return 2 * self.c * self.s[d][i], [("s", d, i, 2 * self.c)]

    def bidirectional(self, i):
        """R_i and the form that rules it."""
        whole = (self.c * self.s[UP][i] + self.c * self.s[DOWN][i] + abs(mp(self.reversal(i))),
                 [("s", UP, i, self.c), ("s", DOWN, i, self.c), ("x", UP, i, 1), ("x", DOWN, i, 1)])
        return max([whole, self.repeatability(UP, i), self.repeatability(DOWN, i)], key=lambda e: e[0])

    def spread(self, i):
        """Ps_i of VDI: 6·s̄_i."""
        return 3 * (self.s[UP][i] + self.s[DOWN][i]), [("s", UP, i, 3), ("s", DOWN, i, 3)]

    def result(self, name):
        """Value and the statistics that carry its uncertainty; None instead of these: the safe side."""
        kind, sign = name.rstrip("+-"), name[-1]
        ways = self.ways if sign not in "+-" else [UP if sign == "+" else DOWN]
        largest = lambda candidates: max(candidates, key=lambda e: e[0])
        average = lambda values: sum(values, mpmath.mpf(0)) / len(self.positions)
        if kind == "A":
            value, top, bottom = self.span(self.ends(ways, 1), self.ends(ways, -1))
            if top[0][1:3] == bottom[0][1:3]:  # one target, one direction: 2c·s
                return value, [("s", top[1][1], top[1][2], 2 * self.c)]
            return value, top + bottom
        if kind == "E":
            value, top, bottom = self.span(self.means(ways), self.means(ways))
            return value, top + bottom
        if kind in ("M", "Pa"):
            value, top, bottom = self.span(self.both_means(), self.both_means())
            return value, top + bottom
        if kind in ("B", "Umax"):
            return largest([(abs(mp(self.reversal(i))), [("x", UP, i, 1), ("x", DOWN, i, 1)])
                            for i in self.targets()])
        if name == "Bmean":
            return average([mp(self.reversal(i)) for i in self.targets()]), None
        if name == "Umean":
            return average([abs(mp(self.reversal(i))) for i in self.targets()]), None
        if name == "R":
            return largest([self.bidirectional(i) for i in self.targets()])
        if kind == "R":
            return largest([self.repeatability(ways[0], i) for i in self.targets()])
        if name == "UPR":
            return min([self.result("R+"), self.result("R-")], key=lambda e: e[0])
        if name == "r":
            return average([self.bidirectional(i)[0] for i in self.targets()]), None
        if kind == "r":
            return average([self.repeatability(ways[0], i)[0] for i in self.targets()]), None
        if name == "Psmax":
            return largest([self.spread(i) for i in self.targets()])
        if name == "Psmean":
            return average([self.spread(i)[0] for i in self.targets()]), None
        if name == "P":
            half = lambda i: (abs(mp(self.reversal(i))) + self.spread(i)[0]) / 2
            ends = lambda sign: [(mp((self.mean[UP][i] + self.mean[DOWN][i]) / 2) + sign * half(i), i)
                                 for i in self.targets()]
            top, bottom = max(ends(1), key=lambda e: e[0]), min(ends(-1), key=lambda e: e[0])
            i, k = top[1], bottom[1]
            if i == k:
                return top[0] - bottom[0], self.spread(i)[1] + [("x", UP, i, 1), ("x", DOWN, i, 1)]
            part = lambda i, up: [("x", UP if (self.reversal(i) > 0) == up else DOWN, i, 1),
                                  ("s", UP, i, Fraction(3, 2)), ("s", DOWN, i, Fraction(3, 2))]
            return top[0] - bottom[0], part(i, True) + part(k, False)
        raise KeyError(name)

    def drift(self):
        """D = slope·(n − 1) and t of the run means."""
        n = len(self.readings[self.ways[0]][0])
        g = [sum(self.readings[d][i][j] - self.mean[d][i] for d in self.ways for i in self.targets())
             / (len(self.ways) * len(self.positions)) for j in range(n)]
        centre = Fraction(n - 1, 2)
        sxx = sum((j - centre) ** 2 for j in range(n))
        slope = sum((j - centre) * g[j] for j in range(n)) / sxx
        rest = sum((g[j] - sum(g) / n - slope * (j - centre)) ** 2 for j in range(n))
        return mp(slope * (n - 1)), mp(slope) / root(rest / (n - 2) / sxx)


def theta(test, measures, of):
    """Mean over the sensors, of ("start", "end") or one of them."""
    values = [fraction(sensor[key]) for sensor in test["conditions"].get("sensors", [])
              if sensor["measures"] == measures for key in of if sensor.get(key) is not None]
    return sum(values) / len(values) if values else None


def correction(test, positions):
    conditions = test.get("conditions", {})
    if conditions.get("correctionTo20") != "applied here":
        return [Fraction(0)] * len(positions)
    reference = fraction(conditions.get("referencePosition") or test["targets"][0])
    expansion = Fraction(0)
    for of, sign in (("machine", 1), ("instrument", -1)):
        alpha = fraction(conditions["expansion"][of])
        if alpha:
            expansion += sign * alpha * (theta(test, of, ("start", "end")) - 20)
    return [-(p - reference) * expansion / 10 ** 6 for p in positions]


# --- uncertainty ---------------------------------------------------------------------------------------------------

RECTANGULAR = Fraction(6, 10)


def farthest(test, of):
    both = [t for t in (theta(test, of, (key,)) for key in ("start", "end")) if t is not None]
    return max((t - 20 for t in both), key=abs, default=None)


def shape(test):
    """Whether the axis is linear, the unit of its deviations in mm or degrees, the length of the budget."""
    linear = test["axis"]["motion"] == "linear"
    length = test["uncertainty"].get("length") or fraction(test["targets"][-1]) - fraction(test["targets"][0])
    return linear, Fraction(1, 1000) if linear else Fraction(1, 3600), fraction(length)


def device_size(test, per_metre_only=False):
    """U (k = 2) of the instrument, or of the part of it that grows with the length."""
    device = test["uncertainty"]["device"]
    linear, unit, length = shape(test)
    size = fraction(device["perMetre"]) * length / 1000 if linear else Fraction(0)
    size += 0 if per_metre_only else fraction(device["fixed"])
    return unit * size * (RECTANGULAR if device["kind"] == "range" else 2 / fraction(device.get("coverageFactor", 2)))


def contributions(test, drift_range=None):
    """U (k = 2) of every contribution, mm; rotary: degrees."""
    u = test["uncertainty"]
    linear, unit, length = shape(test)
    result = {}
    result["device"] = device_size(test)
    if linear:
        result["misalignment"] = Fraction(3, 10) * fraction(u["misalignmentRange"]) ** 2 / length
        for of in ("machine", "instrument"):
            alpha = fraction(test["conditions"]["expansion"][of])
            name = of.capitalize()
            result["temperature" + name] = (unit * RECTANGULAR * alpha * length / 1000
                                            * fraction(u["temperatureRange"][of]))
            spread = fraction(u["expansionRange"][of])
            away = farthest(test, of) if spread else Fraction(0)
            result["expansion" + name] = unit * RECTANGULAR * abs(away) * length / 1000 * spread
    e_ve = u.get("environmentalVariation")
    result["environmentalVariation"] = RECTANGULAR * (drift_range if e_ve is None else unit * fraction(e_ve))
    return result


def systematic(parts):
    return sum(u ** 2 for key, u in parts.items() if key != "environmentalVariation")


def square_of_factor(axis, name, carriers):
    """(U/U_EVE)² of what comes from the scatter of the environment."""
    if carriers is not None:
        total = Fraction(0)
        for kind, d, i, factor in carriers:
            total += Fraction(factor) ** 2 / (axis.n[d][i] - (kind == "s"))
        return total
    fewest = {d: min(axis.n[d]) for d in axis.ways}
    if name in ("Bmean", "Umean"):
        return max(Fraction(1, axis.n[UP][i]) + Fraction(1, axis.n[DOWN][i]) for i in axis.targets())
    if name == "Psmean":
        return 9 * sum(Fraction(1, n - 1) for n in fewest.values())
    ways = axis.ways if name == "r" else [UP if name[-1] == "+" else DOWN]
    return Fraction((2 * axis.c) ** 2, min(fewest[d] for d in ways) - 1)


def tilted(axis, size):
    """The axis with all readings tilted by `size` (mpf, mm) over the length."""
    test = axis.test
    other = Axis(test)
    length = fraction(test["uncertainty"].get("length") or axis.positions[-1] - axis.positions[0])
    for d in axis.ways:
        other.mean[d] = [mp(m) + size * mp((p - axis.positions[0]) / length)
                         for m, p in zip(axis.mean[d], axis.positions)]
    return other


def budget(axis, name, parts, actual=False):
    """U (k = 2), mpf. `actual`: with the part of S that the actual targets carry; None where S does not count."""
    value, carriers = axis.result(name)
    environment = mp(parts["environmentalVariation"]) ** 2 * mp(square_of_factor(axis, name, carriers))
    if name not in OF_LENGTH:
        return None if actual else mpmath.sqrt(environment)
    s2 = mp(systematic(parts))
    # A of one target and direction is 2c·s: it has the row of R, S in full all the same.
    if actual:
        # What grows with the length follows the tilt; the rest of the instrument's part counts in full.
        whole, grows = mp(parts["device"]), mp(device_size(axis.test, per_metre_only=True))
        fixed = whole ** 2 - grows ** 2
        tilt = mpmath.sqrt(s2 - fixed)
        reached = max(tilted(axis, tilt).result(name)[0], tilted(axis, -tilt).result(name)[0]) - value
        s2 = min(max(reached, mpmath.mpf(0)), tilt) ** 2 + fixed
    return mpmath.sqrt(s2 + environment)


# --- JCGM 101 ------------------------------------------------------------------------------------------------------

class Trials:
    """The evaluation of many trials at once, in double precision."""

    def __init__(self, axis, drift_range=None):
        self.axis = axis
        test, u = axis.test, axis.test["uncertainty"]
        linear = test["axis"]["motion"] == "linear"
        unit = 1e-3 if linear else 1 / 3600
        self.l = np.array([float(p - axis.positions[0]) for p in axis.positions])
        self.length = float(fraction(u.get("length") or axis.positions[-1] - axis.positions[0]))
        device = u["device"]
        size = (float(device["fixed"]) + (float(device["perMetre"]) * self.length / 1000 if linear else 0)) * unit
        self.device_is_range = device["kind"] == "range"
        self.device = size / self.length if self.device_is_range else (
            size / float(device.get("coverageFactor", 2)) / self.length)
        self.uniform = []  # full widths of the slopes, mm/mm
        self.cosine = 0.0
        if linear:
            self.cosine = float(u["misalignmentRange"]) ** 2 / (2 * self.length)
            for of in ("machine", "instrument"):
                alpha = float(test["conditions"]["expansion"][of])
                self.uniform.append(float(u["temperatureRange"][of]) * alpha * 1e-6)
                spread = float(u["expansionRange"][of])
                self.uniform.append(spread * 1e-6 * float(abs(farthest(test, of))) if spread else 0.0)
        e_ve = u.get("environmentalVariation")
        self.e_ve = float(drift_range) if e_ve is None else float(e_ve) * unit
        self.is_linear_drift = u.get("driftModel") == "linear"
        self.rows = self.places()

    def places(self):
        """Every reading: direction, target, deviation, place in time."""
        rows, time = [], 0
        for run in self.axis.test["runs"]:
            order = list(self.axis.targets())
            for i in order if run["approach"] == UP else reversed(order):
                if run["deviations"][i] is not None:
                    rows.append((run["approach"], i, float(fraction(run["deviations"][i]) + self.axis.corrections[i]),
                                 time))
                    time += 1
        return rows

    def perturbed(self, count, random):
        slope = (random.random(count) - 0.5) * self.device if self.device_is_range else (
            random.standard_normal(count) * self.device)
        for width in self.uniform:
            slope += (random.random(count) - 0.5) * width
        slope -= random.random(count) * self.cosine / self.length
        last = max(row[3] for row in self.rows)
        change = (random.random(count) - 0.5) * 2 * self.e_ve
        values = {d: [[] for _ in self.l] for d in self.axis.ways}
        for d, i, x, time in self.rows:
            if self.is_linear_drift:
                disturbance = change * (time / last - 0.5)
            else:
                disturbance = (random.random(count) - 0.5) * self.e_ve
            values[d][i].append(x + slope * self.l[i] + disturbance)
        return values

    def evaluated(self, values, names):
        axis, c = self.axis, self.axis.c
        mean = {d: np.array([np.mean(x, axis=0) for x in values[d]]) for d in axis.ways}
        s = {}
        if any(name in NEEDS_S for name in names):
            if axis.test.get("standardDeviation") == "range":
                s = {d: np.array([np.ptp(x, axis=0) / float(RANGE_FACTORS[len(x)]) for x in values[d]])
                     for d in axis.ways}
            else:
                s = {d: np.array([np.std(x, axis=0, ddof=1) for x in values[d]]) for d in axis.ways}
        result = {}
        both = len(axis.ways) == 2
        ri = {d: 2 * c * s[d] for d in s}
        if both:
            b = mean[UP] - mean[DOWN]
            middle = (mean[UP] + mean[DOWN]) / 2
            if s:
                rb = np.maximum(np.maximum(c * s[UP] + c * s[DOWN] + np.abs(b), ri[UP]), ri[DOWN])
        for name in names:
            ways = axis.ways if name[-1] not in "+-" else [UP if name[-1] == "+" else DOWN]
            if name[0] == "A":
                y = (np.max([(mean[d] + c * s[d]).max(0) for d in ways], axis=0)
                     - np.min([(mean[d] - c * s[d]).min(0) for d in ways], axis=0))
            elif name[0] == "E":
                y = np.max([mean[d].max(0) for d in ways], axis=0) - np.min([mean[d].min(0) for d in ways], axis=0)
            elif name in ("M", "Pa"):
                y = middle.max(0) - middle.min(0)
            elif name in ("B", "Umax"):
                y = np.abs(b).max(0)
            elif name == "Bmean":
                y = b.mean(0)
            elif name == "Umean":
                y = np.abs(b).mean(0)
            elif name == "R":
                y = rb.max(0)
            elif name == "UPR":
                y = np.minimum(ri[UP].max(0), ri[DOWN].max(0))
            elif name[0] == "R":
                y = ri[ways[0]].max(0)
            elif name == "r":
                y = rb.mean(0)
            elif name[0] == "r":
                y = ri[ways[0]].mean(0)
            elif name in ("Psmax", "Psmean"):
                ps = 3 * (s[UP] + s[DOWN])
                y = ps.max(0) if name == "Psmax" else ps.mean(0)
            elif name == "P":
                half = (np.abs(b) + 3 * (s[UP] + s[DOWN])) / 2
                y = (middle + half).max(0) - (middle - half).min(0)
            result[name] = y
        return result

    def run(self, names, trials, seed):
        """Simulated values of every result."""
        random = np.random.Generator(np.random.PCG64(seed))
        blocks = [self.evaluated(self.perturbed(10000, random), names) for _ in range(trials // 10000)]
        return {name: np.concatenate([block[name] for block in blocks]) for name in names}
