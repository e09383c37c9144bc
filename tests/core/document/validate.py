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

# The documents differ in one place each: a value that was valid for a part of the schema is so in the others.
follow = jsonschema.Draft202012Validator.VALIDATORS["$ref"]
valid = set()


def written(instance):
    return json.dumps(instance) if isinstance(instance, (dict, list)) else (type(instance), instance)


def follow_once(validator, reference, instance, part):
    key = reference, written(instance)
    if key not in valid:
        error = next(follow(validator, reference, instance, part), None)
        if error:
            yield error
        else:
            valid.add(key)


Validator = jsonschema.validators.extend(jsonschema.Draft202012Validator, {"$ref": follow_once})
evolve, iter_errors = Validator.evolve, Validator.iter_errors
validators = {}


def evolve_once(validator, **changes):
    """Validators keep their part of the schema, so that no other part gets its id."""
    if changes.keys() != {"schema"}:
        return evolve(validator, **changes)
    key = id(changes["schema"])
    if key not in validators:
        validators[key] = evolve(validator, **changes)
    return validators[key]


def errors_once(validator, instance, *of):
    if of or isinstance(instance, (dict, list)):
        return iter_errors(validator, instance, *of)
    key = id(validator.schema), written(instance)
    if key in valid:
        return iter(())
    errors = list(iter_errors(validator, instance))
    if not errors:
        valid.add(key)
    return iter(errors)


Validator.evolve, Validator.iter_errors = evolve_once, errors_once
validator = Validator(schema)
with open(sys.argv[2], encoding="utf-8") as documents:
    print("\n".join(str(int(validator.is_valid(json.loads(document)))) for document in documents))
