"""Reads linear light from OpenEXR files as `velarium` and Blender write them, and measures how far it is apart.

Standard library alone: scan lines in ZIP compression, the first part, channels R, G and B of 16 or 32 bits
(openexr.com, "OpenEXR File Layout").
"""

import array
import itertools
import struct
import zlib

MAGIC = 20000630
MULTI_PART = 0x1000
ZIP, ROWS_OF_CHUNK = 3, 16
FORMATS = {1: ("e", 2), 2: ("f", 4)}  # pixel types HALF and FLOAT
# The floor of the reference in the relative error, that of `velarium compare`.
FLOOR = 0.01


class Unreadable(Exception):
    """What a file has that this reader does not know."""


def text_at(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def header_at(data, at):
    """The attributes of one header, and where it ends."""
    attributes = {}
    while data[at]:
        name, at = text_at(data, at)
        _, at = text_at(data, at)
        size = struct.unpack_from("<i", data, at)[0]
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(attributes):
    listed, at, channels = attributes["channels"], 0, []
    while listed[at]:
        name, at = text_at(listed, at)
        kind = struct.unpack_from("<i", listed, at)[0]
        if kind not in FORMATS:
            raise Unreadable(f"channel {name} is of integers")
        channels.append((name, *FORMATS[kind]))
        at += 16
    return channels


def unpacked(chunk, size):
    """Undoes ZIP: differences of bytes, all even ones before all odd ones. Chunks that would have grown are stored."""
    if len(chunk) == size:
        return chunk
    summed = bytes(itertools.accumulate(zlib.decompress(chunk), lambda last, step: (last + step - 128) & 255))
    half = (size + 1) // 2
    mixed = bytearray(size)
    mixed[0::2], mixed[1::2] = summed[:half], summed[half:]
    return bytes(mixed)


def rows_of_chunk(raw, rows, width, channels, planes):
    at = 0
    for _ in range(rows):
        for name, code, size in channels:
            if name in planes:
                planes[name].extend(struct.unpack_from(f"<{width}{code}", raw, at))
            at += size * width


def read(file):
    """The planes R, G and B, rows from the top."""
    data = file.read_bytes()
    magic, version = struct.unpack_from("<ii", data, 0)
    if magic != MAGIC:
        raise Unreadable("is not OpenEXR")
    attributes, at = header_at(data, 8)
    part_number_bytes = 0
    if version & MULTI_PART:
        part_number_bytes = 4
        while data[at]:
            _, at = header_at(data, at)
        at += 1
    if attributes["compression"][0] != ZIP:
        raise Unreadable("is not compressed by ZIP")
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    channels = channels_of(attributes)
    planes = {name: array.array("f") for name in "RGB"}
    row_bytes = width * sum(size for _, _, size in channels)
    for chunk in range(-(-height // ROWS_OF_CHUNK)):
        offset = struct.unpack_from("<Q", data, at + 8 * chunk)[0] + part_number_bytes
        size = struct.unpack_from("<i", data, offset + 4)[0]
        rows = min(ROWS_OF_CHUNK, height - chunk * ROWS_OF_CHUNK)
        rows_of_chunk(unpacked(data[offset + 8:offset + 8 + size], rows * row_bytes), rows, width, channels, planes)
    return planes


def relative_squared_errors(picture, reference):
    """Of each pixel, the mean of its channels."""
    channels = [[(a - b) ** 2 / (b * b + FLOOR) for a, b in zip(picture[name], reference[name])] for name in "RGB"]
    return [sum(pixel) / 3 for pixel in zip(*channels)]


def mean_without_worst(errors, share):
    """The mean over all pixels but that share of them whose errors are largest: a few bright specks decide the mean of all."""
    kept = sorted(errors)[:len(errors) - int(share * len(errors))]
    return sum(kept) / len(kept)
