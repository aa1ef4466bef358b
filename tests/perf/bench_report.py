"""What was measured, as CSV, SVG and Markdown."""
import csv
import io
import math
import re
from xml.sax.saxutils import escape

# Okabe and Ito's colours, which differ for all eyes.
COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]


def csv_text(rows):
    """One line a row; columns as they first appear."""
    columns = list(dict.fromkeys(key for row in rows for key in row))
    out = io.StringIO()
    writer = csv.DictWriter(out, columns, lineterminator="\n", restval="")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()


def number(x):
    """Three digits that count."""
    if x is None:
        return "-"
    if x == 0 or not math.isfinite(x):
        return f"{x:g}"
    digits = max(0, 2 - math.floor(math.log10(abs(x))))
    return f"{x:,.{digits}f}" if abs(x) < 1e7 else f"{x:.3g}"


def ticks(low, high):
    """Powers of ten within the range; 2 and 5 times them if there are few."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for factors in ((1,), (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 7)):
        found = [f * 10.0 ** d for d in decades for f in factors if low <= f * 10.0 ** d <= high]
        if len(found) >= 3:
            return found
    return found


def svg(title, x_name, y_name, curves):
    """Both axes logarithmic. curves: name -> [(x, y)], all positive."""
    points = [p for curve in curves.values() for p in curve]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    x0, x1, y0, y1 = min(xs) * 0.9, max(xs) * 1.1, min(ys) * 0.8, max(ys) * 1.25
    left, right, top, bottom = 66, 520, 34, 300

    def place(x, y):
        return (left + (right - left) * math.log(x / x0) / math.log(x1 / x0),
                bottom - (bottom - top) * math.log(y / y0) / math.log(y1 / y0))

    text = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 680 350" width="680" height="350" font-family="sans-serif" '
            f'font-size="12">\n<rect width="680" height="350" fill="#ffffff"/>\n'
            f'<text x="{left}" y="20" font-weight="bold">{escape(title)}</text>\n'
            f'<text x="{(left + right) / 2}" y="340" text-anchor="middle">{escape(x_name)}</text>\n'
            f'<text transform="translate(14 {(top + bottom) / 2}) rotate(-90)" text-anchor="middle">{escape(y_name)}</text>\n')
    for x in ticks(x0, x1):
        px, _ = place(x, y0)
        text += (f'<path d="M{px:.1f} {top}V{bottom}" stroke="#eeeeee"/><text x="{px:.1f}" y="{bottom + 17}" '
                 f'text-anchor="middle">{x:g}</text>\n')
    for y in ticks(y0, y1):
        _, py = place(x0, y)
        text += (f'<path d="M{left} {py:.1f}H{right}" stroke="#dddddd"/><text x="{left - 6}" y="{py + 4:.1f}" '
                 f'text-anchor="end">{y:g}</text>\n')
    for i, (name, curve) in enumerate(curves.items()):
        color, placed = COLORS[i % len(COLORS)], [place(*p) for p in sorted(curve)]
        line = "L".join(f"{x:.1f} {y:.1f}" for x, y in placed)
        text += f'<path d="M{line}" fill="none" stroke="{color}" stroke-width="1.6"/>\n'
        text += "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in placed)
        text += f'\n<text x="{right + 12}" y="{top + 14 + 18 * i}" fill="{color}">{escape(name)}</text>\n'
    return text + "</svg>\n"


def table(head, rows):
    """Markdown. Columns of numbers stand to the right."""
    number = re.compile(r"-|[\d.,]+( \([\d.,]+\))?")
    rows = [[str(cell) for cell in row] for row in rows]
    rule = ["---:" if rows and all(number.fullmatch(cell) for cell in column) else "---" for column in zip(*rows)] or ["---"] * len(head)
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, rule, *rows]) + "\n"


def replace_section(text, name, section):
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
    i, j = text.index(begin) + len(begin), text.index(end)
    return text[:i] + section + text[j:]
