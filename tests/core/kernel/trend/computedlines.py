#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes computedlines.h: lines through random points, computed another way than the program does: V as a dense matrix of
decimals with 50 digits, its inverse by elimination, s² by bisection."""
import random
from decimal import Decimal, getcontext

getcontext().prec = 50
random.seed(7)


def inverse(m):
    n = len(m)
    a = [list(row) + [Decimal(int(i == j)) for j in range(n)] for i, row in enumerate(m)]
    for c in range(n):
        p = max(range(c, n), key=lambda i: abs(a[i][c]))
        a[c], a[p] = a[p], a[c]
        a[c] = [x / a[c][c] for x in a[c]]
        for i in range(n):
            if i != c:
                a[i] = [x - a[i][c] * y for x, y in zip(a[i], a[c])]
    return [row[n:] for row in a]


def times(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def solve(t, y, r, c, s2):
    n = len(t)
    v = [[sum(p * q for p, q in zip(c[i], c[j])) + ((r[i] ** 2 + s2) if i == j else 0) for j in range(n)]
         for i in range(n)]
    w = inverse(v)
    mean = sum(t) / n
    x = [[Decimal(1), ti - mean] for ti in t]
    xt = [list(row) for row in zip(*x)]
    cov = inverse(times(times(xt, w), x))
    b = times(times(times(cov, xt), w), [[yi] for yi in y])
    e = [[yi - row[0] * b[0][0] - row[1] * b[1][0]] for yi, row in zip(y, x)]
    chi2 = times(times([list(row) for row in zip(*e)], w), e)[0][0]
    return chi2, b, cov


def line(t, y, r, c):
    free = len(t) - 2
    at_zero, b, cov = solve(t, y, r, c, Decimal(0))
    s2 = Decimal(0)
    if at_zero > free:
        low, high = Decimal(0), Decimal(1)
        while solve(t, y, r, c, high)[0] > free:
            high *= 2
        for _ in range(80):
            middle = (low + high) / 2
            if solve(t, y, r, c, middle)[0] > free:
                low = middle
            else:
                high = middle
        s2 = high
        _, b, cov = solve(t, y, r, c, s2)
    return [at_zero / free, s2.sqrt(), b[0][0], b[1][0], cov[0][0].sqrt(), cov[1][1].sqrt(), cov[0][1]]


def number(low, high):
    return Decimal(random.randint(round(low * 1000), round(high * 1000))) / 1000


cases = []
for count, sources, scatter in [(4, 1, 0), (5, 2, 1.5), (6, 3, 0), (8, 2, 2), (12, 4, 0.8), (16, 5, 0)]:
    t = sorted(number(20, 28) for _ in range(count))
    r = [number(0.2, 0.6) for _ in range(count)]
    c = [[Decimal(0)] * sources for _ in range(count)]
    for i in range(count):
        c[i][i * sources // count] = number(0.3, 0.9)
        if sources > 2:
            c[i][sources - 1] = number(-0.4, 0.4)
    z = [Decimal(str(round(random.gauss(0, 1), 3))) for _ in range(sources)]
    y = [Decimal(9) + (ti - 20) * Decimal('0.8') + sum(p * q for p, q in zip(c[i], z)) +
         Decimal(str(round(random.gauss(0, float(r[i])) + random.gauss(0, scatter), 3))) for i, ti in enumerate(t)]
    points = []
    for i in range(count):
        shared = ", ".join('{"%d", %s}' % (k, c[i][k]) for k in range(sources) if c[i][k] != 0)
        points.append("{%s, %s, %s, {%s}}" % (t[i], y[i].normalize(), r[i], shared))
    results = ", ".join("%.17g" % float(value) for value in line(t, y, r, c))
    cases.append("    {{%s},\n     %s}," % (",\n      ".join(points), results))

print('''#pragma once

#include "kernel/trend/trendline.h"

#include <vector>

/// Made by computedlines.py, which says how.
namespace palmer::testdata {

struct ComputedLine {
    std::vector<TrendPoint> points;
    double chi2PerDof;
    double scatter;
    double level;
    double slope;
    double uOfLevel;
    double uOfSlope;
    double covariance;
};

inline const std::vector<ComputedLine> computedLines{
%s
};

} // namespace palmer::testdata''' % "\n".join(cases))
