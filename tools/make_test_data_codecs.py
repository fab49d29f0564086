"""Encoders of the test data's compressed parts, for make_test_data.py: the least of each format that its decoders read.

Each follows its format's specification, and stores where it could compress, so that the bytes are the same on every
machine and every version of a library.
"""

import struct

# --- Draco: "Draco Bitstream Specification" 2.2 ------------------------------------------------------------------

DRACO_POSITION, DRACO_NORMAL = 0, 1
_DRACO_F32 = 9
_QUANTIZATION_DECODER = 2
_NO_PREDICTION = -2


def _varint(value):
    out = bytearray()
    while value >= 128:
        out.append(128 | value & 127)
        value >>= 7
    return bytes(out + bytes([value]))


def _quantized(rows, bits):
    """The integers of rows of floats, zigzagged as two bytes each, and how to return: lowest values, range, bits."""
    lowest = [min(column) for column in zip(*rows)]
    span = max(max(column) - low for column, low in zip(zip(*rows), lowest))
    steps = (1 << bits) - 1
    values = [round((x - low) / span * steps) for row in rows for x, low in zip(row, lowest)]
    packed = b"".join(struct.pack("<H", 2 * value) for value in values)
    return packed, struct.pack(f"<{len(lowest)}ff", *lowest, span) + bytes([bits])


def draco_mesh(attributes, indices, bits=14):
    """A sequential mesh. attributes: (type, unique id, rows of floats); indices below 65536."""
    points = len(attributes[0][2])
    out = b"DRACO" + bytes([2, 2, 1, 0]) + b"\0\0"
    out += _varint(len(indices) // 3) + _varint(points) + b"\1"
    out += struct.pack(f"<{len(indices)}{'B' if points < 256 else 'H'}", *indices)
    out += b"\1" + _varint(len(attributes))
    for kind, unique_id, rows in attributes:
        out += bytes([kind, _DRACO_F32, len(rows[0]), 0]) + _varint(unique_id)
    out += bytes([_QUANTIZATION_DECODER] * len(attributes))
    quantized = [_quantized(rows, bits) for _, _, rows in attributes]
    for packed, _ in quantized:
        out += struct.pack("<bBB", _NO_PREDICTION, 0, 2) + packed
    return out + b"".join(transform for _, transform in quantized)


# --- EXT_meshopt_compression, appendix A: bitstream --------------------------------------------------------------


def _byte_group(deltas):
    """16 bytes, in the shorter of two forms: nothing where all are 0, else themselves; with the form's number."""
    return (0, b"") if not any(deltas) else (3, bytes(deltas))


def meshopt_attributes(elements):
    """Mode 0, of elements as equally long bytes, whose number of bytes is a multiple of 4."""
    stride = len(elements[0])
    block = min(8192 // stride // 16 * 16, 256)
    out, before = bytearray(b"\xa0"), elements[0]
    for start in range(0, len(elements), block):
        part = elements[start : start + block]
        for k in range(stride):
            column = [before[k]] + [element[k] for element in part]
            deltas = [(b - a + 128) % 256 - 128 for a, b in zip(column, column[1:])]
            zigzag = [2 * d if d >= 0 else -2 * d - 1 for d in deltas]
            zigzag += [0] * (-len(zigzag) % 16)
            groups = [_byte_group(zigzag[i : i + 16]) for i in range(0, len(zigzag), 16)]
            header = bytearray((len(groups) + 3) // 4)
            for i, (form, _) in enumerate(groups):
                header[i // 4] |= form << 2 * (i % 4)
            out += header + b"".join(data for _, data in groups)
        before = part[-1]
    return bytes(out) + bytes(max(0, 32 - stride)) + elements[0]


def meshopt_triangles(indices):
    """Mode 1: each triangle spelled out, as differences from the index before."""
    codes, data, last = bytearray(), bytearray(), 0
    for i in range(0, len(indices), 3):
        codes.append(0xFF)
        data.append(0xFF)
        for index in indices[i : i + 3]:
            delta = index - last
            data += _varint(2 * delta if delta >= 0 else -2 * delta - 1)
            last = index
    return b"\xe1" + bytes(codes + data) + bytes(16)


def exponential(row, exponent=-15):
    """Filter of floats: 24 bits of mantissa and 8 of a power of 2."""
    return b"".join(struct.pack("<I", (exponent & 0xFF) << 24 | round(x / 2**exponent) & 0xFFFFFF) for x in row)


def octahedral(n):
    """Filter of unit vectors, in four bytes: x and y of the octahedron, its size, and nothing."""
    size = 127
    total = sum(abs(c) for c in n)
    x, y = n[0] / total, n[1] / total
    if n[2] < 0:
        x, y = (1 - abs(y)) * (1 if x >= 0 else -1), (1 - abs(x)) * (1 if y >= 0 else -1)
    return struct.pack("<bbbb", round(size * x), round(size * y), size, 0)


# --- WebP: RFC 9649, lossless ------------------------------------------------------------------------------------


def webp(width, height, pixel):
    """An opaque picture whose channels have at most two values each; pixel(x, y) gives three values 0..255."""
    pixels = [pixel(x, y) for y in range(height) for x in range(width)]
    channels = [sorted(set(column)) for column in zip(*pixels)]
    assert all(len(values) <= 2 for values in channels), "a simple prefix code has two symbols"
    bits, count = 0, 0

    def put(value, width_in_bits):
        nonlocal bits, count
        bits |= value << count
        count += width_in_bits

    put(width - 1, 14)
    put(height - 1, 14)
    put(0, 1 + 3)  # no alpha, version 0
    put(0, 1 + 1 + 1)  # no transforms, no colour cache, one group of codes
    green, red, blue = channels[1], channels[0], channels[2]
    for symbols in (green, red, blue, [255], [0]):  # alpha, and distances, which no pixel has
        put(1 | (len(symbols) - 1) << 1 | 1 << 2, 3)
        for symbol in symbols:
            put(symbol, 8)
    for color in pixels:
        for channel, symbols in ((1, green), (0, red), (2, blue)):
            put(symbols.index(color[channel]), len(symbols) - 1)
    data = b"\x2f" + bits.to_bytes((count + 7) // 8, "little")
    chunk = b"VP8L" + struct.pack("<I", len(data)) + data + b"\0" * (len(data) % 2)
    return b"RIFF" + struct.pack("<I", 4 + len(chunk)) + b"WEBP" + chunk
