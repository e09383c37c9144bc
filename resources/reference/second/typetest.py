# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of the machines of a type: the noncentral t distribution as an integral over the chi distribution, 20 digits."""
from mpmath import erfinv, exp, findroot, gamma, log, mpf, ncdf, quad, sqrt, workdps


def quantile(p):
    return sqrt(2) * erfinv(2 * mpf(p) - 1)


def below(t, nu, delta):
    """P(T ≤ t) of T = (Z + δ)/(χ/√ν)."""
    middle = sqrt(mpf(nu))
    total = 2 ** (mpf(nu) / 2 - 1) * gamma(mpf(nu) / 2)
    density = lambda c: c ** (nu - 1) * exp(-c * c / 2) / total
    cuts = {max(mpf(0), middle + k) for k in (-9, -6, -4, -2, -1, 0, 1, 2, 4, 6, 9)}
    return quad(lambda c: ncdf(t * c / middle - delta) * density(c), sorted(cuts), method="gauss-legendre")


def factor(count, content, confidence):
    delta = quantile(content) * sqrt(mpf(count))
    found = findroot(lambda t: below(t, count - 1, delta) - mpf(confidence), (delta, 5 * delta + 5),
                     solver="anderson", tol=mpf(10) ** -30)
    return found / sqrt(mpf(count))


def spread(x):
    mean = sum(x) / len(x)
    return mean, sqrt(sum((v - mean) ** 2 for v in x) / (len(x) - 1))


def francia(x):
    """W' and its probability."""
    n = len(x)
    m = [quantile((i + 1 - mpf(3) / 8) / (n + mpf(1) / 4)) for i in range(n)]
    mean, middle = sum(x) / n, sum(m) / n
    w = (sum((a - mean) * (b - middle) for a, b in zip(sorted(x), m)) ** 2
         / sum((a - mean) ** 2 for a in x) / sum((b - middle) ** 2 for b in m))
    l, u = log(n), log(log(n))
    z = (log(1 - w) + mpf("1.2725") - mpf("1.0521") * (u - l)) / (mpf("1.0308") - mpf("0.26758") * (u + 2 / l))
    return w, 1 - ncdf(z)


def statistics(values, content, confidence):
    with workdps(20):
        x = [mpf(str(v)) for v in values]
        logs = [log(v) for v in x]
        k = factor(len(x), content, confidence)
        (mean, s), (m, of_logs) = spread(x), spread(logs)
        found = {"mean": mean, "s": s, "factor": k, "normalLimit": mean + k * s, "logNormalLimit": exp(m + k * of_logs),
                 "confidenceOfLargest": 1 - mpf(content) ** len(x)}
        if len(x) >= 8:
            found["w"], found["probability"] = francia(x)
            found["wOfLogarithms"], found["probabilityOfLogarithms"] = francia(logs)
        return found
