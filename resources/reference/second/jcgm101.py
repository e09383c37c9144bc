# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean, u, shortest coverage interval of simulated values, and how far they can be trusted (JCGM 101:2008, 7)."""
import math

import numpy as np

PROBABILITY = 0.9545
BLOCK = 10000
TRIALS_OF_PALMER = 220000


def shortest(values):
    """7.7.2: the shortest interval that holds the probability."""
    y = np.sort(values)
    q = int(PROBABILITY * len(y) + 0.5)
    widths = y[q:] - y[:-q]
    start = int(np.argmin(widths))
    return y[start], y[start + q]


def summary(values):
    low, high = shortest(values)
    return {"mean": values.mean(), "u": values.std(ddof=1), "low": low, "high": high, "U": (high - low) / 2}


def numerical_tolerance(u):
    """7.9.2: half a unit of the second significant digit."""
    return 0.5 * 10.0 ** (math.floor(math.log10(u)) - 1)


def simulated(values):
    """Each quantity: value, and by how much another simulation of 220 000 trials may differ from it: the numerical
    tolerance, or four times the standard deviation of the difference if that is more. It is taken from blocks as in
    7.9.4, of 10 000 trials and of as many as the other simulation has. It falls with the root of the number of trials;
    the ends of the shortest interval slide where the density is flat, and theirs with the cube root or slower."""
    whole = summary(values)
    size = len(values)
    spread = {}
    for block in (BLOCK, TRIALS_OF_PALMER):
        if size >= 2 * block:
            parts = [summary(values[k * block:(k + 1) * block]) for k in range(size // block)]
            spread[block] = {key: float(np.std([part[key] for part in parts], ddof=1)) for key in whole}
    result = {}
    for key, value in whole.items():
        power = 2 / 3 if key in ("low", "high") else 1
        of_difference = max(s[key] * math.sqrt((block / size) ** power + (block / TRIALS_OF_PALMER) ** power)
                            for block, s in spread.items())
        result[key] = (float(value), max(numerical_tolerance(whole["u"]), 4 * of_difference))
    return result
