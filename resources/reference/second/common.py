# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What all sets share: 50 digits, numbers as they are printed, what is expected of a test."""
import json
from fractions import Fraction

import mpmath

mpmath.mp.dps = 50
SECOND = "second implementation"
EXACT = "exact"
LENGTH_DECIMALS = 12  # of mm and degrees: the last one is checked to 0.6 of its unit


def mp(value):
    return mpmath.mpf(value.numerator) / value.denominator if isinstance(value, Fraction) else mpmath.mpf(value)


def fraction(text):
    return Fraction(str(text))


def root(value):
    return mpmath.sqrt(mp(value))


def at_decimals(value, decimals):
    """The JSON number nearest to `value` with so many decimals."""
    scaled = int(mpmath.nint(mp(value) * mpmath.mpf(10) ** decimals))
    text = f"{abs(scaled):0{max(decimals, 0) + 1}d}"
    if decimals > 0:
        text = f"{text[:-decimals]}.{text[-decimals:]}"
    return Number(("-" if scaled < 0 else "") + text)


class Number(float):
    """A float that is printed as it was written."""

    def __new__(cls, text):
        number = super().__new__(cls, text)
        number.text = text
        return number

    def __repr__(self):
        return self.text


def expected(value, decimals=LENGTH_DECIMALS, tolerance=None, source=SECOND, **place):
    """A value with its place and tolerance; without a tolerance it is checked to 0.6 of its last decimal."""
    number = at_decimals(value, decimals)
    return {**place, "value": number, "tolerance": 6 * 10.0 ** -(decimals + 1) if tolerance is None else tolerance,
            "source": source}


def word(value, **place):
    return {**place, "value": value, "source": SECOND}


def text_of(item, depth=0):
    """JSON; lists of numbers and what is expected on one line each."""
    if isinstance(item, Number):
        return item.text
    if isinstance(item, list) and item and isinstance(item[0], (dict, list)):
        inner = (",\n" + " " * (depth + 1)).join(text_of(one, depth + 1) for one in item)
        return "[\n" + " " * (depth + 1) + inner + "\n" + " " * depth + "]"
    if isinstance(item, dict) and any(isinstance(one, (dict, list)) for one in item.values()):
        inner = (",\n" + " " * (depth + 1)).join(f"{json.dumps(key)}: {text_of(one, depth + 1)}"
                                                for key, one in item.items())
        return "{\n" + " " * (depth + 1) + inner + "\n" + " " * depth + "}"
    if isinstance(item, dict):
        return "{" + ", ".join(f"{json.dumps(key)}: {text_of(one)}" for key, one in item.items()) + "}"
    if isinstance(item, list):
        return "[" + ", ".join(text_of(one) for one in item) + "]"
    return json.dumps(item, ensure_ascii=False)


def significant(value, digits):
    """Decimals after which `value` has so many significant digits."""
    return digits - 1 - int(mpmath.floor(mpmath.log10(abs(mp(value)))))
