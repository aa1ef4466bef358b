"""Where a line may break, and where not. Browsers break after a hyphen, before a sign and around a formula."""
import html
import re

NBSP = "\N{NO-BREAK SPACE}"
SHORT_CODE, SHORT_FORMULA = 24, 16  # characters that fit into a line of a phone beside other words


def whole(markup):
    return f'<span class="whole">{markup}</span>'


def words(text):
    """HTML of plain text: no line begins with a unit or a sign, numbers stay whole, and the signs of C++ stand close together."""
    text = re.sub(r"(?<=\d) (?=(dB|ns|ms|B|MiB|GiB)\b|%)", NBSP, text)
    text = re.sub(r"(?<=\d) / (?=\d)", f"{NBSP}/{NBSP}", text)
    text = re.sub(r"(?<=\S) (<=|>=|[<>=]) (?=\S)", rf"{NBSP}\1{NBSP}", text)
    text = re.sub(r"\((-?[\d.]+, )+-?[\d.]+\)", lambda found: found[0].replace(" ", NBSP), text)
    text = html.escape(text, quote=False)
    text = re.sub(r"\b[\w.]*\d(-\w+)+|\b\w+(-\d\w*)+", lambda found: whole(found[0]), text)
    return text.replace("++", '<span class="close">++</span>')


def code(text, in_table=False, is_link=False):
    """HTML of code within a line. What is short stays whole; in a table's narrow columns long names break between their parts."""
    shown = html.escape(text)
    if in_table and len(text) > 10 and " " not in text:
        return re.sub(r"(?<=[\w;])(?=::)|(?<=[/_])(?=\w)|(?<=[a-z])(?=[A-Z])", "<wbr>", shown)
    if is_link:
        return shown.replace("/", "/<wbr>")
    return whole(shown) if len(text) <= SHORT_CODE else options(shown)


def options(markup):
    """Options of commands stay whole: --jobs, -c."""
    return re.sub(r"(?<![\w/-])--?[A-Za-z][\w-]*(?![^<>]*>)", lambda found: whole(found[0]), markup)


def command(row):
    """A coloured line of a shell's commands. Its remark gets a line of its own where the page is narrow."""
    return re.sub(r'<span class="k-w">( {2,})</span>(?=<span class="k-c1">)', r'<span class="gap">\1</span>', options(row))


def formula(tex, markup):
    """A formula within a line: a short one stays whole."""
    shown = re.sub(r"\\text\{(.*?)\}|\\[A-Za-z]+|[ {}_^]", lambda found: found[1] or ("x" if found[0][0] == "\\" else ""), tex)
    return whole(markup) if len(shown) <= SHORT_FORMULA else markup
