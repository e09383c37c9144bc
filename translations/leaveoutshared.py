#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes out of the window's catalogue what lupdate adds without a translation and the report's catalogue has: the
window asks that one, too (ui/windowlanguage.cpp).

    leaveoutshared.py ui_fr.ts report_fr.ts"""
import pathlib
import re
import sys

MESSAGE = re.compile(r"    <message.*?</message>\n", re.DOTALL)


def source(message):
    """What is translated, and the comment that tells two of them apart."""
    return tuple(re.findall(r"<(?:source|comment)>(.*?)</(?:source|comment)>", message, re.DOTALL))


window, report = map(pathlib.Path, sys.argv[1:3])
shared = {source(message) for message in MESSAGE.findall(report.read_text(encoding="utf-8"))}


def kept(found):
    # As Qt looks it up: with its comment, else without.
    is_shared = source(found[0]) in shared or source(found[0])[:1] in shared
    return "" if is_shared and 'type="unfinished"' in found[0] else found[0]


text = MESSAGE.sub(kept, window.read_text(encoding="utf-8"))
window.write_text(re.sub(r"<context>\n    <name>[^<]*</name>\n</context>\n", "", text), encoding="utf-8")
