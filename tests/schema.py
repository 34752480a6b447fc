#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# Check files against what `windfirm schema KIND --json-schema` prints. Given: the program, then KIND=FILE...; prints each
# mistake as FILE: place: message. Exit code: how many, at most 99; 77 without python3-jsonschema or python3-yaml.
import json, subprocess, sys
try:
    import jsonschema, yaml
except ImportError as missing:
    print("not checked:", missing)
    sys.exit(77)

validators, mistakes = {}, 0
for argument in sys.argv[2:]:
    kind, file = argument.split("=", 1)
    if kind not in validators:
        schema = json.loads(subprocess.run([sys.argv[1], "schema", kind, "--json-schema"], check=True, capture_output=True).stdout)
        jsonschema.Draft7Validator.check_schema(schema)
        validators[kind] = jsonschema.Draft7Validator(schema)
    with open(file, encoding="utf-8") as text:
        content = yaml.safe_load(text)
    for error in validators[kind].iter_errors(content):
        print(f"{file}: {'.'.join(map(str, error.path))}: {error.message}")
        mistakes += 1
sys.exit(min(mistakes, 99))
