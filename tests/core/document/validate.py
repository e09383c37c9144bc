# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Validates documents, one JSON text a line in the file of the second argument, against the schema in the file of
the first. Prints 1 or 0 a line."""
import json
import sys

import jsonschema

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)

# The documents differ in one place each: a part that was valid where a reference led is so in the others.
follow = jsonschema.Draft202012Validator.VALIDATORS["$ref"]
valid = set()


def follow_once(validator, reference, instance, part):
    key = reference, json.dumps(instance)
    if key not in valid:
        error = next(follow(validator, reference, instance, part), None)
        if error:
            yield error
        else:
            valid.add(key)


validator = jsonschema.validators.extend(jsonschema.Draft202012Validator, {"$ref": follow_once})(schema)
with open(sys.argv[2], encoding="utf-8") as documents:
    for document in documents:
        print(int(validator.is_valid(json.loads(document))))
