# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A line through values over time: V as a matrix of 50 digits, inverted; s² where chi² is n − 2; Student's t by mpmath."""
import mpmath

mpf = mpmath.mpf


def student(probability, degrees):
    """Quantile of Student's t by bisection of the incomplete beta function."""
    tail = lambda t: mpmath.betainc(mpf(degrees) / 2, mpf("0.5"), 0, degrees / (degrees + t * t), regularized=True) / 2
    low, high = mpf(0), mpf(1000)
    for _ in range(120):
        middle = (low + high) / 2
        low, high = (middle, high) if tail(middle) > 1 - probability else (low, middle)
    return (low + high) / 2


def normal(probability):
    return mpmath.sqrt(2) * mpmath.erfinv(2 * probability - 1)


def fitted(points, s2):
    n = len(points)
    v = mpmath.matrix(n, n)
    sources = sorted({part["source"] for p in points for part in p["shared"]})
    for source in sources:
        c = [sum(mpf(str(part["u"])) for part in p["shared"] if part["source"] == source) for p in points]
        for i in range(n):
            for k in range(n):
                v[i, k] += c[i] * c[k]
    for i, p in enumerate(points):
        v[i, i] += mpf(str(p["own"])) ** 2 + s2
    w = v ** -1
    times = [mpf(str(p["time"])) for p in points]
    centre = sum(times) / n
    x = mpmath.matrix([[1, t - centre] for t in times])
    y = mpmath.matrix([mpf(str(p["value"])) for p in points])
    covariance = (x.T * w * x) ** -1
    b = covariance * x.T * w * y
    rest = y - x * b
    return (rest.T * w * rest)[0], b, covariance, centre


def line(points, limit=None, reserve=None):
    """All that is stated of the line. Time of "not before" by bisection of the bound, None beyond the horizon."""
    free = len(points) - 2
    chi2, b, covariance, centre = fitted(points, mpf(0))
    s2 = mpf(0)
    if chi2 > free:
        low, high = mpf(0), mpf(1)
        while fitted(points, high)[0] > free:
            high *= 2
        s2 = mpmath.findroot(lambda x: fitted(points, x)[0] - free, (low, high), solver="anderson", tol=mpf(10) ** -40)
        _, b, covariance, centre = fitted(points, s2)
    two = student(mpf("0.975"), free) if s2 > 0 else normal(mpf("0.975"))  # 1.96
    one = student(mpf("0.95"), free) if s2 > 0 else normal(mpf("0.95"))  # 1.645
    u = mpmath.sqrt(covariance[1, 1])
    result = {"level": b[0], "slope": b[1], "uLevel": mpmath.sqrt(covariance[0, 0]), "uSlope": u,
              "covariance": covariance[0, 1], "scatter": mpmath.sqrt(s2), "chi2PerDof": chi2 / free,
              "shown": abs(b[1]) >= two * u}
    if limit is not None:
        times = [mpf(str(p["time"])) for p in points]
        first, last = min(times), max(times)
        bound = lambda t: (b[0] + b[1] * (t - centre) + one * mpmath.sqrt(
            covariance[0, 0] + 2 * covariance[0, 1] * (t - centre) + covariance[1, 1] * (t - centre) ** 2))
        height = mpf(str(limit)) - (mpf(str(reserve)) if reserve else 0)
        horizon = first + 2 * (last - first)
        if bound(last) >= height:
            result["notBefore"] = last
        elif bound(horizon) >= height:
            low, high = last, horizon
            for _ in range(90):
                middle = (low + high) / 2
                low, high = (middle, high) if bound(middle) < height else (low, middle)
            result["notBefore"] = low
        else:
            result["notBefore"] = None
    return result
