#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Validates all reference data against their schema. Argument: resources."""
import json
import pathlib
import sys

import jsonschema

resources = pathlib.Path(sys.argv[1])
schema = json.loads((resources / "schema/palmer-reference-1.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
files = sorted(resources.glob("reference/**/*.json"))
faults = [f"{file}: {error.json_path}: {error.message[:200]}" for file in files
          for error in validator.iter_errors(json.loads(file.read_text(encoding="utf-8")))]
print("\n".join(faults[:20]))
sys.exit(1 if faults or len(files) < 20 else 0)
