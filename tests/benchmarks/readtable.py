#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""pandas.read_csv on the table of the benchmark ReadTable, to compare with (python3-pandas).

    PALMER_BENCHMARK_TABLE=/tmp/table.csv palmer-benchmarks --benchmark_filter=ReadTable
    /usr/bin/python3 tests/benchmarks/readtable.py /tmp/table.csv
"""
import sys
import time

import pandas

times = []
for _ in range(5):
    wall, processor = time.perf_counter(), time.process_time()
    frame = pandas.read_csv(sys.argv[1], sep=";")
    times.append((time.perf_counter() - wall, time.process_time() - processor))
    assert frame.shape == (1_000_000, 3)
wall, processor = min(times)
print(f"pandas {pandas.__version__} read_csv: {wall * 1000:.0f} ms wall, {processor * 1000:.0f} ms processor time")
