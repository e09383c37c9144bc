# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Palmer from Python: tests of machine tools (ISO 230-2, ISO 230-4), evaluated by `palmer-cli`.

    >>> import palmer
    >>> palmer.evaluate("x.palmer").results[["symbol", "value", "expandedUncertainty", "unit"]]

Everything is a pandas DataFrame with the keys of the JSON as columns (`palmer-cli schema NAME` describes them). Values
are unrounded, in the unit of the column `unit`: mm, or deg of rotary axes. `DataFrame.attrs["units"]` says the units of
columns that have one of their own. The program is `palmer-cli` of the PATH, or what the variable PALMER_CLI names.
"""
from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Iterable, Union

import pandas as pd

__all__ = ["Evaluation", "PalmerError", "evaluate", "trend"]

PathLike = Union[str, "os.PathLike[str]"]


class PalmerError(Exception):
    """A file cannot be read, or the call is wrong. `exit`: the code of palmer-cli (2 wrong usage, 3 a file)."""

    def __init__(self, message: str, exit_code: int) -> None:
        super().__init__(message)
        self.exit = exit_code


def _run(*words: str) -> str:
    """Standard output of palmer-cli. Raises PalmerError with its last line; a verdict (exit 1) is no error."""
    program = os.environ.get("PALMER_CLI", "palmer-cli")
    done = subprocess.run([program, *words], capture_output=True, encoding="utf-8", check=False)
    if done.returncode not in (0, 1):
        lines = done.stderr.strip().splitlines()
        raise PalmerError(lines[-1] if lines else f"{program} ended with {done.returncode}", done.returncode)
    return done.stdout


def _file(path: PathLike) -> str:
    return str(Path(path).absolute())  # no name is taken for an option


def _settings(settings: Iterable[str]) -> list[str]:
    return [word for setting in settings for word in ("--set", setting)]


class Evaluation:
    """A file evaluated. `json`: what `export --as json` writes, as it is."""

    def __init__(self, content: dict[str, Any]) -> None:
        self.json = content

    def _rows(self, key: str, columns: Iterable[str], of: str = "") -> pd.DataFrame:
        """A row per entry of each test; `test` counts from 1. `columns`: there even without rows. `of`: the member
        of the test that holds the list."""
        rows = []
        for number, test in enumerate(self.json["tests"], start=1):
            holder = (test.get(of) or {}) if of else test
            rows += [{"test": number, **row} for row in holder.get(key) or []]
        return pd.DataFrame(rows, columns=None if rows else ["test", *columns])

    def _unit(self, number: int) -> str:
        test = self.json["tests"][number]
        limits = test["parameters"] or [{"unit": test.get("unit", "mm")}]
        return limits[0]["unit"]

    @property
    def tests(self) -> pd.DataFrame:
        """A row per test: title, kind, axis or plane, edition, accordance, verdict, limits …"""
        return pd.DataFrame(
            [{"test": number, **{key: value for key, value in test.items() if not isinstance(value, (list, dict))}}
             for number, test in enumerate(self.json["tests"], start=1)])

    @property
    def results(self) -> pd.DataFrame:
        """A row per parameter: id, symbol, value, unit, expandedUncertainty (with coverageFactor and
        coverageProbability), limit, verdict. value, U and limit in `unit`; NaN: none."""
        numbers = ["value", "expandedUncertainty", "coverageFactor", "coverageProbability", "limit", "guardBand"]
        frame = self._rows("parameters", ["id", "symbol", "unit", "verdict", *numbers])
        return frame.astype({name: float for name in numbers})

    @property
    def targets(self) -> pd.DataFrame:
        """A row per target position of positioning tests: means, reversal, standard deviations, limits of the
        2s bands. All in the unit of the column `unit` (mm; rotary axes deg)."""
        frame = self._rows("targets", ["target", "meanPositive", "meanNegative", "mean", "reversal"])
        frame["unit"] = [self._unit(number - 1) for number in frame["test"]]
        return frame

    @property
    def readings(self) -> pd.DataFrame:
        """A row per reading, with `unit` (mm; rotary axes deg). Positioning: run (from 1), approach, position,
        deviation; missing readings are NaN. Circular: arc (from 1), sense, angle (degrees), deviation (radial).
        Drift: time (s), deviation; of several channels also channel, their name."""
        rows: list[dict[str, Any]] = []
        for number, test in enumerate(self.json["tests"], start=1):
            unit, readings = self._unit(number - 1), test["readings"]
            head = {"test": number, "unit": unit}
            for index, run in enumerate(readings.get("runs", []), start=1):
                rows += [{**head, "run": index, "approach": run["approach"], "position": position, "deviation": value}
                         for position, value in zip(readings["targets"], run["deviations"])]
            for index, arc in enumerate(readings.get("arcs", []), start=1):
                rows += [{**head, "arc": index, "sense": arc["sense"], "angle": angle, "deviation": value}
                         for angle, value in zip(arc["angles"], arc["radialDeviations"])]
            rows += [{**head, "time": time, "deviation": value}
                     for time, value in zip(readings.get("times", []), readings.get("deviations", []))]
            for channel in readings.get("channels", []):
                own = {**head, "unit": "mm" if channel["quantity"] == "deviation" else "deg", "channel": channel["name"]}
                rows += [{**own, "time": time, "deviation": value}
                         for time, value in zip(readings["times"], channel["values"])]
        frame = pd.DataFrame(rows, columns=None if rows else ["test", "unit", "deviation"])
        frame["deviation"] = frame["deviation"].astype(float)
        frame.attrs["units"] = {"angle": "deg", "time": "s"}
        return frame

    @property
    def findings(self) -> pd.DataFrame:
        """A row per finding: grade (requirement, recommendation, note), source, state, clause, id, text."""
        return self._rows("findings", ["grade", "source", "state", "clause", "id", "keys", "text"])

    @property
    def diagnosis(self) -> pd.DataFrame:
        """A row per source of deviation of circles: id, axis, value with its `unit` (µm, µm/m, µrad, ms), u (NaN
        where there is no interval), separable, contribution (mm). Empty without circles."""
        return self._rows("sources", ["id", "axis", "value", "u", "unit", "contribution", "separable"], "diagnosis")


def evaluate(path: PathLike, *, settings: Iterable[str] = (), accept: bool = False) -> Evaluation:
    """Evaluates a test file, a report of Palmer (PDF) or a measurement file.

    `settings`: as of --set ("machine.name=DMU 50", "unit=um"); `accept`: take what an import assumes. Raises
    PalmerError if the file cannot be read, a question stays open, or palmer-cli refuses a setting.
    """
    accepted = ["--accept"] if accept else []
    return Evaluation(json.loads(_run("export", _file(path), "--as", "json", "-o", "-", *accepted, *_settings(settings))))


def trend(machine: str, axis: str, parameter: str, *, register: PathLike | None = None) -> pd.DataFrame:
    """A parameter of an axis over the years, from a register (`palmer-cli register scan FOLDER`).

    A row per test: date, value, U, limit in the unit of the column `unit`; `k`; uOwn, the standard uncertainty of this
    value alone; series (from 1). Tests without a date are left out. `attrs["line"]`: the line through the first series, or None; `attrs["units"]`. Raises
    PalmerError for an unknown machine, axis or parameter.
    """
    where = ["--register", os.fspath(register)] if register is not None else []
    text = _run("register", "trend", "--machine", machine, "--axis", axis, "--parameter", parameter, "--json", *where)
    found = json.loads(text.splitlines()[0])
    rows = [{"series": number, "unit": found["unit"], **point}
            for number, series in enumerate(found["series"], start=1) for point in series["points"]]
    frame = pd.DataFrame(rows, columns=None if rows else ["series", "unit", "date", "value", "U", "limit"])
    frame["date"] = pd.to_datetime(frame["date"])
    frame.attrs["line"] = found["line"]
    frame.attrs["units"] = {"slopePerYear": found["unit"] + "/year"}
    return frame
