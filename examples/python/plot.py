# A field over time, from a capture, as an SVG picture.
import argparse
import sys

import jauscat
from capture_to_rows import rows


# [plot]
def plot(points, title, unit):
    """An SVG picture of (time, value) pairs; times count from the first."""
    width, height, edge = 800, 300, 50
    times = [time - points[0][0] for time, _ in points]
    values = [value for _, value in points]
    lowest, highest = min(values), max(values)
    span = highest - lowest or 1
    place = [(edge + (width - 2 * edge) * time / (times[-1] or 1), height - edge - (height - 2 * edge) * (value - lowest) / span)
             for time, value in zip(times, values)]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in place)
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">
<rect width="{width}" height="{height}" fill="white"/>
<text x="{width / 2}" y="20" text-anchor="middle" font-size="14">{title}</text>
<polyline fill="none" stroke="#3f51b5" stroke-width="1.5" points="{line}"/>
<text x="4" y="{edge}">{highest:g} {unit}</text>
<text x="4" y="{height - edge}">{lowest:g} {unit}</text>
<text x="{width - edge}" y="{height - edge + 20}" text-anchor="end">{times[-1]:.1f} s</text>
</svg>
"""
# [plot end]


parser = argparse.ArgumentParser(description="Draws a field over time as SVG.",
                                 epilog="Example: plot.py traffic.pcap report_velocity_state velocity_x >velocity.svg")
parser.add_argument("capture")
parser.add_argument("message")
parser.add_argument("field")
options = parser.parse_args()
try:
    known = {field.name: field for field in jauscat.message(options.message).fields}
    if options.field not in known:
        sys.exit(f"plot.py: {options.message} has no field {options.field}; it has {', '.join(known)}")
    found = [(row[0], row[5]) for row in rows(options.capture) if row[3:5] == (options.message, options.field)]
    if not found:
        sys.exit(f"plot.py: {options.capture} has no {options.field} of {options.message}")
    sys.stdout.write(plot(found, f"{options.message}: {options.field}", known[options.field].unit))
except (OSError, ValueError, jauscat.Error) as error:
    sys.exit(f"plot.py: {error}")
