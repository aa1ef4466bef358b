"""Reads the PNG files that the project writes: 8 bits, RGB or RGBA, not interlaced (PNG specification, third edition, 9)."""
import struct
import zlib


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def read(path):
    """(width, height, rows of RGB bytes)."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", data[at + 8:at + 21])
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    if (depth, interlaced) != (8, 0) or colour not in (2, 6):
        raise ValueError(f"{path}: expected 8-bit RGB or RGBA, not interlaced")
    n = 3 if colour == 2 else 4
    raw, rows, before = zlib.decompress(packed), [], bytes(width * n)
    for y in range(height):
        start = y * (width * n + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + width * n])
        for i in range(len(row)) if kind else ():
            a, b, c = (row[i - n] if i >= n else 0), before[i], (before[i - n] if i >= n else 0)
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth(a, b, c) if kind == 4 else 0)[kind]) & 255
        rows.append(row if n == 3 else bytearray(byte for i, byte in enumerate(row) if i % 4 != 3))
        before = row
    return width, height, rows
