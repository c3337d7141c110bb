#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the font files of this folder anew from Debian's packages.

Needs fonts-noto-core, fonts-noto-mono, python3-fonttools and python3-brotli. With an argument it
reads the Noto files from that folder instead of /usr/share/fonts/truetype/noto. The output depends
on the versions of these packages only.
"""
import os
import shutil
import sys
import tempfile

from fontTools import merge, subset
from fontTools.ttLib import TTFont

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = sys.argv[1] if len(sys.argv) > 1 else "/usr/share/fonts/truetype/noto"

# What a report can contain in Latin letters; other scripts come from the reader's system.
REPORT = [*range(0x20, 0x7F), *range(0xA0, 0x180), *range(0x370, 0x400), *range(0x2010, 0x2028),
          *range(0x2070, 0x208F), 0x2030, 0x2032, 0x2033, 0x20AC, 0x2103, 0x2126]
# Signs of the interface that Noto Sans itself does not have.
MATH = [*range(0x2190, 0x2300)]  # arrows and mathematical operators
SHAPES = [*range(0x25A0, 0x27C0)]  # geometric shapes, miscellaneous symbols, dingbats
REPORT_SIGNS = [ord(sign) for sign in "←↑→↓↔↺↻−≈≠≤≥●○■▲★⚠✓✔✖✗✘"]


def options(flavor=None):
    chosen = subset.Options()
    chosen.flavor = flavor
    chosen.hinting = flavor is None
    chosen.layout_features = ["kern", "mark", "ccmp"]
    chosen.notdef_outline = True
    return chosen


def make_subset(path, characters, output, flavor=None):
    chosen = options(flavor)
    font = subset.load_font(path, chosen)
    subsetter = subset.Subsetter(chosen)
    subsetter.populate(unicodes=characters)
    subsetter.subset(font)
    font["head"].modified = font["head"].created
    font.recalcTimestamp = False
    subset.save_font(font, output, chosen)


def make_symbols(work, output):
    parts = []
    for name, characters in (("NotoSansMath", MATH), ("NotoSansSymbols2", SHAPES)):
        part = os.path.join(work, name + ".ttf")
        chosen = options()
        chosen.hinting = False
        chosen.layout_features = []
        font = subset.load_font(os.path.join(SOURCE, name + "-Regular.ttf"), chosen)
        subsetter = subset.Subsetter(chosen)
        subsetter.populate(unicodes=characters)
        subsetter.subset(font)
        for table in ("GSUB", "GPOS", "GDEF", "MATH"):
            if table in font:
                del font[table]
        subset.save_font(font, part, chosen)
        parts.append(part)
    font = merge.Merger().merge(parts)
    # The heights of Noto Sans: a line with a sign in it must be no taller than one without.
    text = TTFont(os.path.join(SOURCE, "NotoSans-Regular.ttf"))
    for table, keys in (("hhea", ("ascent", "descent", "lineGap")),
                        ("OS/2", ("sTypoAscender", "sTypoDescender", "sTypoLineGap",
                                  "usWinAscent", "usWinDescent"))):
        for key in keys:
            setattr(font[table], key, getattr(text[table], key))
    for record in list(font["name"].names):
        if record.nameID in (1, 4, 6, 16):
            name = "ServoDeskSymbols" if record.nameID == 6 else "ServoDesk Symbols"
            font["name"].setName(name, record.nameID, record.platformID, record.platEncID,
                                 record.langID)
    font["head"].created = font["head"].modified = text["head"].created
    font.recalcTimestamp = False
    font.save(output)


def main():
    for name in ("NotoSans-Regular.ttf", "NotoSans-Bold.ttf", "NotoSansMono-Regular.ttf"):
        shutil.copyfile(os.path.join(SOURCE, name), os.path.join(HERE, name))
    symbols = os.path.join(HERE, "ServoDeskSymbols-Regular.ttf")
    with tempfile.TemporaryDirectory() as work:
        make_symbols(work, symbols)
    for name in ("Regular", "Bold"):
        make_subset(os.path.join(HERE, "NotoSans-" + name + ".ttf"), REPORT,
                    os.path.join(HERE, "report-" + name.lower() + ".woff2"), "woff2")
    make_subset(symbols, REPORT_SIGNS, os.path.join(HERE, "report-symbols.woff2"), "woff2")


if __name__ == "__main__":
    main()
