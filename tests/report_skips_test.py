#!/usr/bin/env python3
"""tests/report_skips.py on what this machine's ctest writes: report_skips_test.py CTEST"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CTEST = sys.argv.pop(1)
# Name, script, properties.
TESTS = [("passes", "echo fine", ""), ("fails", "echo skipped: not this time; exit 1", ""),
         ("leaves", "echo hello; echo skipped: there is no browser; exit 77", "SKIP_RETURN_CODE 77"), ("mute", "exit 77", "SKIP_RETURN_CODE 77"),
         ("partly", "printf 'a.cpp:12: Skipped\\\\nchroot is for root\\\\n\\\\nb.cpp:1: Skipped\\\\n\\\\nskipped: no <b>\\\\n'", ""),
         ("text", "echo 'a word skipped: in a line'; head -c 20000 /dev/zero | tr '\\\\0' x; echo; echo skipped: far below", ""),
         ("never", "true", "DISABLED TRUE"), ("absent", "", "")]


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="raytree ")
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)

    def run_tests(self, tests, *options):
        lines = []
        for name, script, properties in tests:
            lines.append(f'add_test({name} "/no/such/program")' if name == "absent" else f'add_test({name} "sh" "-c" "{script}")')
            if properties:
                lines.append(f"set_tests_properties({name} PROPERTIES {properties})")
        (self.here / "CTestTestfile.cmake").write_text("\n".join(lines) + "\n")
        subprocess.run([CTEST, "--output-junit", "tests.xml", *options], cwd=self.here, capture_output=True, check=False)

    def report(self, *options):
        done = subprocess.run([sys.executable, HERE / "report_skips.py", self.here / "tests.xml", *options], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_all_kinds_are_listed(self):
        self.run_tests(TESTS, "--test-output-size-passed", "1000000", "--test-output-size-failed", "1000000")
        expected = """Left out, so not tested here:
  fails: not this time
  leaves: there is no browser
  mute: it did not run (SKIP_RETURN_CODE=77)
  partly: no <b>
  partly: chroot is for root
  partly: no reason is given
  text: far below
  never: it is disabled
  absent: it did not run (Unable to find executable)
"""
        self.assertEqual(self.report(), (0, expected))
        self.assertEqual(self.report("--fail"), (1, expected))

    def test_nothing_left_out_is_said_too(self):
        self.run_tests(TESTS[:1])
        self.assertEqual(self.report("--fail"), (0, "All of 1 tests ran; nothing was left out.\n"))

    def test_output_that_was_cut_is_no_good_news(self):
        self.run_tests([test for test in TESTS if test[0] == "text"])
        code, text = self.report("--fail")
        self.assertEqual(code, 1)
        self.assertIn("  text: ctest cut its output", text)

    def test_no_results_are_a_sentence(self):
        code, text = self.report()
        self.assertEqual((code, text.count("\n")), (2, 1), text)
        (self.here / "tests.xml").write_text("<half")
        self.assertEqual(self.report()[0], 2)


unittest.main(verbosity=1)
