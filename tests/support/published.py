"""The published and derived checks of tests/data/validation.json, by id."""

import json
from pathlib import Path

CHECKS = {
    check["id"]: check
    for check in json.loads((Path(__file__).parents[1] / "data" / "validation.json").read_text())[
        "checks"
    ]
}


def given_and_expected(name):
    """What a check starts from, and what it should come to."""
    return CHECKS[name]["input"], CHECKS[name]["expected"]
