"""Tests by unittest that say what they left out, so that `./raytree test` can list it (report_skips.py)."""
import sys
import unittest


def main():
    """In place of unittest.main: each test that was left out is a line `skipped: WHY`. Exit codes: 0 all held, 1 something did
    not, 77 nothing failed and something was left out."""
    result = unittest.main(verbosity=1, exit=False).result
    for test, why in result.skipped:
        print(f"skipped: {test.id().rpartition('.')[2]}: {why}", flush=True)
    sys.exit(0 if result.wasSuccessful() and not result.skipped else 77 if result.wasSuccessful() else 1)
