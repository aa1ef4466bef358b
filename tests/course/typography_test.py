#!/usr/bin/env python3
"""Where the site's lines may break: slides-notes/site/typography.py, and what markdown.py and listings.py do about it.

Exit code 77: a python module of the site is missing."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "slides-notes/site"))
try:
    import listings
    import markdown
    import typography
    from markdown_it.token import Token
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

NBSP = typography.NBSP


class Words(unittest.TestCase):
    def test_a_unit_stays_with_its_number(self):
        self.assertEqual(typography.words("40 dB, 3 ms, 50 % of 8 balls"), f"40{NBSP}dB, 3{NBSP}ms, 50{NBSP}% of 8 balls")

    def test_a_comparison_stays_together_and_is_escaped(self):
        self.assertEqual(typography.words("if t > 1 or a <= b"), f"if t{NBSP}&gt;{NBSP}1 or a{NBSP}&lt;={NBSP}b")

    def test_numbers_with_a_hyphen_stay_whole(self):
        self.assertEqual(typography.words("of 1e-4 in UTF-8, half-open"), 'of <span class="whole">1e-4</span> in <span class="whole">UTF-8</span>, half-open')

    def test_a_row_of_numbers_stays_together(self):
        self.assertEqual(typography.words("0.0 / 0.3 / 1, and / or"), f"0.0{NBSP}/{NBSP}0.3{NBSP}/{NBSP}1, and / or")

    def test_a_point_stays_together(self):
        self.assertEqual(typography.words("(-4, 1, 1.5) or (a, 1)"), f"(-4,{NBSP}1,{NBSP}1.5) or (a, 1)")

    def test_the_signs_of_the_language_stand_close(self):
        self.assertEqual(typography.words("C++"), 'C<span class="close">++</span>')


class Code(unittest.TestCase):
    def test_short_code_stays_whole(self):
        self.assertEqual(typography.code("./raytree lesson 9"), '<span class="whole">./raytree lesson 9</span>')

    def test_in_long_code_options_stay_whole(self):
        self.assertEqual(typography.code("./raytree view 6 --tracer ./my_tracer"), './raytree view 6 <span class="whole">--tracer</span> ./my_tracer')

    def test_in_a_table_long_names_break_between_their_parts(self):
        self.assertEqual(typography.code("RayTree::nodesOf", in_table=True), "Ray<wbr>Tree<wbr>::nodes<wbr>Of")
        self.assertEqual(typography.code("common/tree/ray_tree.h", in_table=True, is_link=True), "common/<wbr>tree/<wbr>ray_<wbr>tree.h")

    def test_a_link_to_a_file_breaks_at_its_folders(self):
        self.assertEqual(typography.code("lessons/06_fresnel/trace.h", is_link=True), "lessons/<wbr>06_fresnel/<wbr>trace.h")

    def test_what_is_in_a_tag_is_left_alone(self):
        self.assertEqual(typography.options('<span class="k --w">x</span>'), '<span class="k --w">x</span>')

    def test_a_hyphen_within_a_word_is_no_option(self):
        self.assertEqual(typography.options("2026-fall x86-64-v3"), "2026-fall x86-64-v3")

    def test_the_gap_before_a_remark_is_marked(self):
        row, = listings.coloured("./raytree    # the viewer\n", "sh")
        self.assertIn('<span class="gap">    </span><span class="k-c1"># the viewer</span>', typography.command(row))


class Formula(unittest.TestCase):
    def test_a_short_one_stays_whole(self):
        self.assertEqual(typography.formula(r"F_t = 1 - F_r\text{,}", "x"), '<span class="whole">x</span>')
        self.assertEqual(typography.formula(r"\theta_1 + \theta_2 = \alpha", "x"), '<span class="whole">x</span>')

    def test_a_long_one_may_break(self):
        self.assertEqual(typography.formula(r"\cos^2\theta_2 = 1 - (n_1/n_2)^2(1 - \cos^2\theta_1)", "x"), "x")

    def test_the_punctuation_after_one_becomes_part_of_it(self):
        formula, text = Token("math_inline", "", 0, content="a"), Token("text", "", 0, content="), and")
        markdown.keep_punctuation([formula, text])
        self.assertEqual((formula.content, text.content), (r"a\text{),}", " and"))
        spaced = Token("text", "", 0, content=" and")
        markdown.keep_punctuation([formula, spaced])
        self.assertEqual(spaced.content, " and")


class NewLines(unittest.TestCase):
    def test_a_new_function_ends_with_its_own_brace(self):
        """difflib would mark the brace of the function before it."""
        after = ["}", "", "int g()", "{", "    int x = 3;", "    return x;", "}"]
        old = ["int f()", "{", "    return 1;", *after]
        new = ["int f()", "{", "    return 1;", "}", "", "int h()", "{", "    return 2;", *after]
        self.assertEqual(listings.added(old, new), ([5, 6, 7, 8, 9], 0))

    def test_a_changed_line_is_new_and_its_old_form_gone(self):
        self.assertEqual(listings.added(["a", "b", "c"], ["a", "x", "c"]), ([1], 1))


if __name__ == "__main__":
    unittest.main()
