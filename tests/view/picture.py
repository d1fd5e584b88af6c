"""Pixels of a PNG as browsers write them: 8 bits a channel, not interlaced (ISO/IEC 15948)."""

import struct
import zlib

CHANNELS = {2: 3, 6: 4}


class Picture:
    """Rows of (red, green, blue), 0..255."""

    def __init__(self, png):
        if png[:8] != b"\x89PNG\r\n\x1a\n":
            raise ValueError("no PNG")
        header, data = None, b""
        for kind, content in _chunks(png):
            if kind == b"IHDR":
                header = struct.unpack(">IIBBBBB", content)
            elif kind == b"IDAT":
                data += content
        self.width, self.height, depth, colour, _, _, interlaced = header
        if depth != 8 or interlaced or colour not in CHANNELS:
            raise ValueError("a PNG of another kind")
        self._channels = CHANNELS[colour]
        self._rows = _unfiltered(zlib.decompress(data), self.width * self._channels, self._channels)

    def pixel(self, x, y):
        start = int(x) * self._channels
        return tuple(self._rows[int(y)][start:start + 3])

    def pixels(self):
        """All of them, row by row."""
        return [self.pixel(x, y) for y in range(self.height) for x in range(self.width)]


def _chunks(png):
    at = 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        yield kind, png[at + 8:at + 8 + length]
        at += length + 12


def _paeth(left, above, corner):
    guess = left + above - corner
    distances = [abs(guess - left), abs(guess - above), abs(guess - corner)]
    return (left, above, corner)[distances.index(min(distances))]


def _unfiltered(data, length, step):
    rows = []
    above = bytes(length)
    for start in range(0, len(data), length + 1):
        kind, row = data[start], bytearray(data[start + 1:start + 1 + length])
        for i in range(length if kind else 0):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            row[i] = (row[i] + (left, above[i], (left + above[i]) // 2, _paeth(left, above[i], corner))[kind - 1]) % 256
        rows.append(row)
        above = row
    return rows


def distance(one, other):
    """The largest difference of a channel of two colours."""
    return max(abs(a - b) for a, b in zip(one, other))
