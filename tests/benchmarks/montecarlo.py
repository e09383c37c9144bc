#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Monte Carlo simulation of a positioning test as a vectorised NumPy program, to compare times with.

The same model as MonteCarlo/positioning of palmer-benchmarks: worked example of ISO 230-2:1988 as reconstructed
(11 targets, 5 runs each way) under 2006, laser of 1.5 µm/m, misalignment 1 mm, machine at 25 °C ± 0.5 with
alpha = 12 ± 1 µm/(m·°C), E_VE = 3 µm drawn for every reading; twelve parameters, mean, u and shortest 95.45 %
interval of each. Needs python3-numpy; a benchmark only.

    montecarlo.py [TRIALS [PALMER-BENCHMARKS]]

With the second argument the benchmark of this project is run in the same process of measuring, before and after.
"""
import subprocess
import sys
import time

import numpy as np

TARGETS = np.array([0.0, 150.71, 300.85, 450.33, 601.11, 750.31, 901.55, 1050.02, 1201.9, 1351.56, 1500.41])
UP = np.array([
    [-3.0, 0.2, -5.0, 0.6, -8.4, -4.9, -6.5, -5.5, -8.2, -7.4, -7.8],
    [-2.0, 0.7, -5.6, 1.6, -7.4, -3.7, -5.6, -3.6, -5.9, -5.5, -5.8],
    [-1.9, 0.4, -4.8, 0.5, -7.8, -4.7, -4.8, -5.0, -6.3, -5.4, -5.6],
    [-1.8, 1.8, -2.7, 2.3, -6.1, -3.4, -3.9, -2.3, -4.5, -3.7, -4.7],
    [-0.9, 1.5, -2.8, 2.3, -6.9, -2.3, -3.5, -2.3, -3.4, -2.2, -2.7]])
DOWN = np.array([
    [2.3, 5.4, -1.5, 2.4, -9.0, -6.1, -5.8, -5.6, -6.1, -5.6, -3.0],
    [1.1, 4.6, -1.0, 2.1, -9.4, -5.7, -5.6, -4.8, -5.0, -4.6, -1.8],
    [3.2, 5.7, -0.8, 3.6, -8.1, -4.5, -4.7, -4.4, -4.8, -2.9, -0.2],
    [2.5, 5.4, -2.6, 2.2, -8.3, -3.6, -4.2, -4.4, -3.1, -2.8, 0.0],
    [1.5, 5.9, -0.8, 2.9, -7.8, -3.1, -3.3, -2.0, -2.0, -1.4, -2.7]])


def block(random, trials):
    """All parameters of `trials` trials, µm."""
    length = TARGETS[-1] - TARGETS[0]
    metres = (TARGETS - TARGETS[0]) / 1000
    slope = (random.normal(0, 0.75, trials)                          # device, µm/m
             + 12 * random.uniform(-0.5, 0.5, trials)                # temperature of the machine
             + 5 * random.uniform(-1, 1, trials)                     # its coefficient of expansion
             - random.uniform(0, 1, trials) / (2 * length) * 1e6 / length)  # misalignment
    common = slope[:, None, None] * metres
    up = UP + common + random.uniform(-1.5, 1.5, (trials,) + UP.shape)
    down = DOWN + common + random.uniform(-1.5, 1.5, (trials,) + DOWN.shape)
    mean_up, mean_down = up.mean(axis=1), down.mean(axis=1)
    s_up, s_down = up.std(axis=1, ddof=1), down.std(axis=1, ddof=1)
    mean, b = (mean_up + mean_down) / 2, mean_up - mean_down
    high_up, low_up = mean_up + 2 * s_up, mean_up - 2 * s_up
    high_down, low_down = mean_down + 2 * s_down, mean_down - 2 * s_down
    r = np.maximum(2 * s_up + 2 * s_down + np.abs(b), 4 * np.maximum(s_up, s_down))
    return np.stack([
        np.maximum(high_up, high_down).max(axis=1) - np.minimum(low_up, low_down).min(axis=1),    # A
        high_up.max(axis=1) - low_up.min(axis=1), high_down.max(axis=1) - low_down.min(axis=1),    # A+ A-
        np.maximum(mean_up, mean_down).max(axis=1) - np.minimum(mean_up, mean_down).min(axis=1),  # E
        np.ptp(mean_up, axis=1), np.ptp(mean_down, axis=1), np.ptp(mean, axis=1),                 # E+ E- M
        r.max(axis=1), 4 * s_up.max(axis=1), 4 * s_down.max(axis=1),                              # R R+ R-
        np.abs(b).max(axis=1), b.mean(axis=1)])                                                   # B Bmean


def simulate(trials, seed=1, size=20000):
    random = np.random.Generator(np.random.SFC64(seed))
    values = np.concatenate([block(random, min(size, trials - k)) for k in range(0, trials, size)], axis=1)
    values.sort(axis=1)
    held = int(0.9545 * trials + 0.5)
    widths = values[:, held:] - values[:, :trials - held]
    return values.mean(axis=1), values.std(axis=1, ddof=1), widths.min(axis=1) / 2


def palmer(program, trials):
    subprocess.run([program, f'--benchmark_filter=MonteCarlo/positioning/trials:{trials}/'], check=True)


def main():
    trials = int(sys.argv[1]) if len(sys.argv) > 1 else 1000000
    if len(sys.argv) > 2:
        palmer(sys.argv[2], trials)
    wall, cpu = time.perf_counter(), time.process_time()
    mean, u, expanded = simulate(trials)
    print(f'NumPy {np.__version__}: {trials} trials, {time.perf_counter() - wall:.2f} s, '
          f'processor time {time.process_time() - cpu:.2f} s')
    for name, *row in zip('A A+ A- E E+ E- M R R+ R- B Bmean'.split(), mean, u, expanded):
        print(f'{name:6}' + ''.join(f'{x:10.4f}' for x in row))
    if len(sys.argv) > 2:
        palmer(sys.argv[2], trials)


if __name__ == '__main__':
    main()
