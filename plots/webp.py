"""Pictures joined to an animated WebP (RFC 9649)."""

import struct


def _chunk(name, content):
    return name + struct.pack("<I", len(content)) + content + b"\0" * (len(content) % 2)


def _three_bytes(number):
    return struct.pack("<I", number)[:3]


def _image_of(picture):
    """The chunk that holds the pixels of an opaque WebP."""
    at = 12
    while at < len(picture):
        name, length = picture[at:at + 4], struct.unpack_from("<I", picture, at + 4)[0]
        if name in (b"VP8 ", b"VP8L"):
            return _chunk(name, picture[at + 8:at + 8 + length])
        at += 8 + length + length % 2
    raise ValueError("a WebP without an image")


def animation(pictures, durations_ms, width, height):
    """The file: each of the WebP `pictures`, all of one size, for as long as it is to be seen; then from the start."""
    size = _three_bytes(width - 1) + _three_bytes(height - 1)
    animated, replaces = b"\2", b"\2"
    content = _chunk(b"VP8X", animated + b"\0" * 3 + size) + _chunk(b"ANIM", b"\xff" * 4 + b"\0" * 2)
    for picture, duration_ms in zip(pictures, durations_ms):
        content += _chunk(b"ANMF", b"\0" * 6 + size + _three_bytes(duration_ms) + replaces + _image_of(picture))
    return b"RIFF" + struct.pack("<I", len(content) + 4) + b"WEBP" + content
