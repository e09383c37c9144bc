# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The response to a temperature: τ·dy/dt = θ − y by Gauss' quadrature over each step, least squares by NumPy's SVD, τ by a
grid that is refined about its least."""
import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


def delayed(theta, step, tau):
    share = (NODES + 1) / 2
    kernel = WEIGHTS / 2 * step / tau * np.exp(-(1 - share) * step / tau)
    added = (theta[:-1, None] * (1 - share) + theta[1:, None] * share) @ kernel
    y = np.empty_like(theta)
    y[0] = theta[0]
    for i, one in enumerate(added):
        y[i + 1] = np.exp(-step / tau) * y[i] + one
    return y


def fit(x, theta, step, settled, tau):
    """Sum of squares, k and slope at one τ; NaN in x: no reading."""
    t = np.arange(len(x)) * step
    columns = [np.ones(len(x)), t / t[-1], delayed(theta, step, tau)] + ([] if settled else [np.exp(-t / tau)])
    rows = ~np.isnan(x)
    a = np.stack(columns, 1)[rows]
    c = np.linalg.lstsq(a, x[rows], rcond=None)[0]
    return float(np.sum((x[rows] - a @ c) ** 2)), float(c[2]), float(c[1] / t[-1])


def response(x, theta, step, settled):
    last = (len(x) - 1) * step
    taus = np.geomspace(step / 2, 4 * last, 80)
    for _ in range(7):
        squares = [fit(x, theta, step, settled, tau)[0] for tau in taus]
        i = int(np.argmin(squares))
        taus = np.linspace(taus[max(i - 1, 0)], taus[min(i + 1, len(taus) - 1)], 21)
    _, k, slope = fit(x, theta, step, settled, taus[10])
    return {"k": k, "tau": float(taus[10]), "slope": slope}
