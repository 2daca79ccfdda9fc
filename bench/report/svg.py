"""A small SVG writer, in the colours of the project's other pictures (oracle/draw/colours.h)."""

from html import escape

PAGE, PAPER, INK, MUTED, GRID = "#fbfaf6", "#ffffff", "#1f2a3d", "#667085", "#98a2b3"
COLOURS = ["#0b5fb0", "#d1490c", "#b5267b", "#b7791f", "#2f7d6b", "#6b4fa0", "#7a5c3e", "#1f2a3d"]
FONT = "system-ui, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', sans-serif"


def number(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


class Svg:
    def __init__(self, width, height, title, description):
        self.out = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" role="img" font-family="{FONT}">',
            f"<title>{escape(title)}</title>",
            f"<desc>{escape(description)}</desc>",
            f'<rect width="{width}" height="{height}" fill="{PAGE}"/>',
        ]
        self.text(28, 40, title, size=18, weight=600)
        self.text(28, 62, description, size=12.5, fill=MUTED)

    def text(self, x, y, content, size=11.5, fill=INK, anchor="start", weight=400):
        self.out.append(
            f'<text x="{number(x)}" y="{number(y)}" font-size="{size}" fill="{fill}" text-anchor="{anchor}" '
            f'font-weight="{weight}">{escape(content)}</text>'
        )

    def rect(self, x, y, width, height, **style):
        self._leaf("rect", {"x": x, "y": y, "width": width, "height": height}, style)

    def line(self, points, **style):
        data = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        self._leaf("path", {"d": data}, {"fill": "none", **style})

    def dot(self, x, y, radius, **style):
        self._leaf("circle", {"cx": x, "cy": y, "r": radius}, style)

    def finish(self):
        return "\n".join(self.out + ["</svg>", ""])

    def _leaf(self, tag, attributes, style):
        pairs = {**attributes, **{key.replace("_", "-"): value for key, value in style.items()}}
        words = (f'{k}="{number(v) if isinstance(v, float) else v}"' for k, v in pairs.items())
        self.out.append(f"<{tag} {' '.join(words)}/>")
