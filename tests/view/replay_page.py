"""The page of `twiddle view` in a browser: its controls, its numbers, its picture."""

import re

import chromium
from picture import Picture, distance

# Of the scene.
BACKGROUND = (238, 241, 244)


class ReplayPage:
    """A page that is open in `browser`."""

    def __init__(self, browser):
        self.browser = browser

    def open_at(self, path, step):
        """Still, at a step."""
        self.browser.open(path, f"#step={step}")
        self.browser.wait_for("window.twiddle !== undefined")

    def step(self):
        return self.browser.value("twiddle.step()")

    def playing(self):
        return self.browser.value("twiddle.isPlaying()")

    def box(self, name):
        """Of the element `name` in the window: x, y, width, height."""
        return self.browser.value(f"(b => [b.x, b.y, b.width, b.height])"
                                  f"(document.getElementById('{name}').getBoundingClientRect())")

    def click(self, name):
        x, y, width, height = self.box(name)
        self.browser.click(x + width / 2, y + height / 2)

    def scrub_to(self, step):
        """As a hand does that drags the slider."""
        self.browser.value(f"(s => {{ s.value = {step}; s.dispatchEvent(new Event('input', {{bubbles: true}})); "
                           f"s.dispatchEvent(new Event('change', {{bubbles: true}})); }})"
                           f"(document.getElementById('scrub'))")

    def text(self, name):
        return self.browser.value(f"document.getElementById('{name}').textContent")

    def number(self, name):
        """The number that an element says, and half a unit of its last decimal."""
        found = re.match(r"-?\d+(?:\.(\d+))?", self.text(name))
        if not found:
            raise chromium.Failure(f"{name} says no number: {self.text(name)}")
        return float(found.group()), 0.5 * 10 ** -len(found.group(1) or "")

    def project(self, point_m):
        """Where a point of the palm frame is in the picture of the scene."""
        return self.browser.value(f"twiddle.project({', '.join(map(repr, point_m))})")

    def picture(self, canvas="scene"):
        return Picture(self.browser.picture(self.box(canvas)))

    def pixels_around(self, place, half):
        """Of the square of 2 `half` + 1 px around a place in the picture of the scene."""
        x, y, _, _ = self.box("scene")
        size = 2 * half + 1
        corner = (round(x + place[0] - half), round(y + place[1] - half))
        return Picture(self.browser.picture((*corner, size, size))).pixels()


def is_background(pixel):
    return distance(pixel, BACKGROUND) < 6


def is_object(pixel):
    """Green, in light and shade; nothing else on the page is."""
    red, green, blue = pixel
    return green > red + 40 and green > blue + 15


def is_index(pixel):
    """Blue, or its lighter trace."""
    red, green, blue = pixel
    return blue > red + 40 and blue > green + 10


def is_thumb(pixel):
    """Orange, or its lighter trace."""
    red, green, blue = pixel
    return red > blue + 60 and green > blue + 25


IS_FINGER = {"index": is_index, "thumb": is_thumb}
