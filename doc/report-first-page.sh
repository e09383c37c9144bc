#!/bin/sh
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes doc/report-first-page.png after ./run; needs poppler-utils and imagemagick.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
# Exit code 1: the example does not conform, as it should.
build/release/bin/palmer-cli report tests/data/report/limits-2006.palmer --language fr -o "$work/report.pdf" ||
    [ $? = 1 ]
pdftoppm -r 110 -f 1 -l 1 -png -singlefile "$work/report.pdf" "$work/page"
convert "$work/page.png" -strip -colors 64 -define png:compression-level=9 doc/report-first-page.png
