# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Difference of two tests of an axis: one simulation of both (bootstrap of whole cycles, errors of the budget drawn once
where both share them). Written from the formulas, with NumPy; all trials at once."""
import copy
import math

import mpmath
import numpy as np

from positioning import DOWN, UP, Axis, Trials, farthest
from trend import student

TAIL = 0.02275
COVERED = 1 - 2 * TAIL


def first_cycles(test, n):
    """The test with the first n runs of each direction."""
    part = copy.deepcopy(test)
    taken = {UP: 0, DOWN: 0}
    part["runs"] = []
    for run in test["runs"]:
        if taken[run["approach"]] < n:
            taken[run["approach"]] += 1
            part["runs"].append(copy.deepcopy(run))
    return part


def factor(n):
    """f: few cycles are as unsure as Student says."""
    return float(student(1 - TAIL, 2 * n - 2)) / 2


class Side:
    """One of two tests: means and scaled residuals, cycles × targets, by direction."""

    def __init__(self, test, n):
        self.axis = Axis(test)
        self.trials = Trials(self.axis)
        self.mean, self.residuals = {}, {}
        for d in self.axis.ways:
            x = np.array([[float(v) for v in target] for target in self.axis.readings[d]]).T
            self.mean[d] = x.mean(0)
            self.residuals[d] = factor(n) * math.sqrt(n / (n - 1)) * (x - self.mean[d])
        self.drifts = False
        if n > 2:
            t = self.axis.drift()[1]
            self.drifts = abs(t) > student(0.975, n - 2)

    def slopes(self, count, random, alpha):
        """Errors per mm; `alpha`: the draw of α of the machine, the same for both tests."""
        trials = self.trials
        slope = random.standard_normal(count) * trials.device
        machine = farthest(self.axis.test, "machine")
        widths = trials.uniform  # temperature and expansion, machine and instrument
        for k, width in enumerate(widths):
            draw = alpha * (1 if machine >= 0 else -1) if k == 1 else random.random(count) - 0.5
            slope += draw * width
        return slope - random.random(count) * trials.cosine / trials.length


def differences(a, b, n, pooled, count, random):
    alpha = random.random(count) - 0.5
    values = []
    for side, other in ((a, b), (b, a)):
        slope = side.slopes(count, random, alpha)
        pool = {d: np.concatenate([side.residuals[d], other.residuals[d]]) if pooled else side.residuals[d]
                for d in side.axis.ways}
        drawn = random.integers(0, 2 * n if pooled else n, (n, count))
        readings = {d: [[side.mean[d][i] + slope * side.trials.l[i] + pool[d][drawn[j], i] for j in range(n)]
                        for i in side.axis.targets()] for d in side.axis.ways}
        values.append(side.trials.evaluated(readings, side.axis.results()))
    return {name: values[1][name] - values[0][name] for name in values[0]}


def compared(before, after, trials, seed):
    """Of each result: values, difference, U. Pooled residuals where n = 2 or one of the tests drifts."""
    n = min(min(sum(r["approach"] == d for r in t["runs"]) for d in (UP, DOWN)) for t in (before, after))
    a, b = (Side(first_cycles(t, n), n) for t in (before, after))
    pooled = n == 2 or a.drifts or b.drifts
    random = np.random.Generator(np.random.PCG64(seed))
    blocks = [differences(a, b, n, pooled, 10000, random) for _ in range(max(1, trials // 10000))]
    result = {}
    for name in a.axis.results():
        d = np.concatenate([block[name] for block in blocks])
        away = np.sort(np.abs(d - d.mean()))
        u = away[math.ceil(COVERED * len(away)) - 1]
        was, now = a.axis.result(name)[0], b.axis.result(name)[0]
        result[name] = was, now, mpmath.mpf(now) - mpmath.mpf(was), float(u)
    return result


def word(name, was, now, u):
    """better, worse, changed, noChangeProven: less is better, Bmean by its magnitude."""
    if not abs(now - was) > u:
        return "noChangeProven"
    more = abs(now) - abs(was)
    return "worse" if more > 0 else "better" if more < 0 else "changed"
