#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes computedtypes.h: factors of tolerance limits and statistics of random values, computed another way than the
program does: the noncentral t distribution as an integral over the chi distribution with 30 digits, quantiles by bisection."""
import os
import random

from mpmath import erfinv, exp, gamma, log, mp, mpf, ncdf, quad, sqrt

mp.dps = 30
random.seed(11)


def z(p):
    return sqrt(2) * erfinv(2 * mpf(p) - 1)


def below(t, nu, delta):
    """P(T ≤ t): T = (Z + δ)/(χ/√ν)."""
    middle = sqrt(mpf(nu))
    density = lambda c: c ** (nu - 1) * exp(-c * c / 2) / (2 ** (mpf(nu) / 2 - 1) * gamma(mpf(nu) / 2))
    cuts = [max(mpf(0), middle + k) for k in (-9, -6, -4, -2, -1, 0, 1, 2, 4, 6, 9)]
    return quad(lambda c: ncdf(t * c / sqrt(mpf(nu)) - delta) * density(c), sorted(set(cuts)))


def factor(n, p, confidence):
    delta = z(p) * sqrt(mpf(n))
    low, high = mpf(0), mpf(400)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if below(middle, n - 1, delta) < confidence else (low, middle)
    return low / sqrt(mpf(n))


def spread(x):
    mean = sum(x) / len(x)
    return mean, sqrt(sum((v - mean) ** 2 for v in x) / (len(x) - 1))


def francia(x):
    n = len(x)
    m = [z((i + 1 - mpf(3) / 8) / (n + mpf(1) / 4)) for i in range(n)]
    xm, mm = sum(x) / n, sum(m) / n
    w = (sum((a - xm) * (b - mm) for a, b in zip(sorted(x), m)) ** 2
         / sum((a - xm) ** 2 for a in x) / sum((b - mm) ** 2 for b in m))
    l = log(n)
    s = (log(1 - w) + mpf("1.2725") - mpf("1.0521") * (log(l) - l)) / (mpf("1.0308") - mpf("0.26758") * (log(l) + 2 / l))
    return w, 1 - ncdf(s)


out = ["// SPDX-FileCopyrightText: 2026 the Palmer authors", "// SPDX-License-Identifier: GPL-3.0-or-later",
       "// Written by computedtypes.py.", "#pragma once", "", "#include <cstddef>
#include <vector>", "",
       "namespace palmer::testdata {", "",
       "struct ComputedFactor {", "    std::size_t count;", "    double content;", "    double confidence;", "    double factor;",
       "};", "// clang-format off", "inline const std::vector<ComputedFactor> computedFactors{"]
for n, p, c in [(3, .95, .95), (4, .95, .95), (5, .95, .95), (10, .95, .95), (20, .95, .95), (50, .95, .95), (100, .95, .95),
                (10, .9, .95), (10, .99, .95), (10, .95, .9), (40, .5, .99)]:
    out.append(f"    {{{n}, {p}, {c}, {float(factor(n, mpf(str(p)), mpf(str(c))))!r}}},")
out += ["};", "", "struct ComputedType {", "    std::vector<double> values;",
        "    double mean, s, normalLimit, logNormalLimit, w, probability, wOfLogarithms, probabilityOfLogarithms;", "};",
        "inline const std::vector<ComputedType> computedTypes{"]
for n in (8, 10, 25):
    values = [round(random.lognormvariate(0, 0.6 if n == 25 else 0.3) * 5, 2) for _ in range(n)]
    x = [mpf(str(v)) for v in values]
    logs = [log(v) for v in x]
    k = factor(n, mpf("0.95"), mpf("0.95"))
    (mean, s), (m, sl) = spread(x), spread(logs)
    numbers = [mean, s, mean + k * s, exp(m + k * sl), *francia(x), *francia(logs)]
    out.append("    {{%s},\n     %s}," % (", ".join(map(repr, values)), ", ".join(repr(float(v)) for v in numbers)))
out += ["};", "// clang-format on", "", "} // namespace palmer::testdata", ""]
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "computedtypes.h"), "w", encoding="utf-8") as file:
    file.write("\n".join(out))
