#!/usr/bin/env python3
"""What a run of the tests left out, and why: the last thing that `./raytree test` says.

    report_skips.py RESULTS.xml [--fail]

RESULTS.xml is what `ctest --output-junit` wrote, with --test-output-size-passed large enough that no output is cut. A test leaves
something out when it ends with 77, when it cannot be started, when it prints a line `skipped: WHY`, or by GTEST_SKIP. Exit codes:
0; with --fail 1 if anything was left out; 2 if the file cannot be read.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree

CUT = re.compile(r"^\[?(This part|The rest) of the test output was removed since it exceeds", re.M)  # in place of what ctest cuts


def reasons(output):
    """Of each thing that a test says it left out, why, in its order and once each."""
    found = [match[1] for match in re.finditer(r"^skipped: *(.+)$", output, re.M | re.I)]
    # GoogleTest: FILE:LINE: Skipped, then the message.
    found += [match[1].strip() or "no reason is given" for match in re.finditer(r"^\S[^\n]*: Skipped\n([^\n]*)$", output, re.M)]
    return list(dict.fromkeys(found))


def left_out(results):
    """(test, why) of all that was left out."""
    found = []
    for case in results.iter("testcase"):
        name, output = case.get("name"), "".join(part.text or "" for part in case.iter("system-out"))
        why = reasons(output)
        if case.get("status") in ("notrun", "disabled") and not why:
            said = case.find("skipped")
            why = ["it is disabled" if case.get("status") == "disabled" else
                   f"it did not run ({(said.get('message') if said is not None else '') or 'ctest does not say why'})"]
        if CUT.search(output):
            why.append("ctest cut its output, so nobody knows (give ctest --test-output-size-passed 1000000)")
        found += [(name, one) for one in why]
    return found


def main(arguments):
    fail = "--fail" in arguments
    files = [one for one in arguments if one != "--fail"]
    if len(files) != 1:
        print("usage: report_skips.py RESULTS.xml [--fail]", file=sys.stderr)
        return 2
    try:
        results = xml.etree.ElementTree.parse(pathlib.Path(files[0])).getroot()
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        print(f"report_skips.py: {files[0]}: {error}, expected what ctest --output-junit wrote", file=sys.stderr)
        return 2
    found = left_out(results)
    if not found:
        print(f"All of {len(list(results.iter('testcase')))} tests ran; nothing was left out.")
        return 0
    print("Left out, so not tested here:")
    for name, why in found:
        print(f"  {name}: {why}")
    return 1 if fail else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
