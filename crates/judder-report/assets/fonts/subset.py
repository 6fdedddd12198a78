"""Makes the bundled fonts: letters of Noto Sans, mathematical signs of Noto Sans Math.

Usage: python subset.py FOLDER-OF-NOTO-FONTS   (needs fonttools and brotli)
"""

import sys
import tempfile
from pathlib import Path

from fontTools import subset
from fontTools.merge import Merger
from fontTools.ttLib import TTFont

LETTERS = (
    "U+0020-007E,U+00A0-017F,U+0300-0304,U+0306-0308,U+030A,U+030C,U+0338,U+0391-03A9,U+03B1-03C9,U+03D1,U+03D5,"
    "U+03F5,U+1E00-1EFF,U+2010-2015,U+2018-201E,U+2020-2022,U+2026,U+2030,U+2032,U+2033,U+2070-2079,U+2080-2089,"
    "U+207A-207F,U+2113,U+212B,U+20AC"
)
SIGNS = (
    "U+2190-2194,U+21D2,U+2202,U+2206-2208,U+2211,U+2212,U+2218,U+221A,U+221D,U+221E,U+2225,U+2227,U+2228,U+222B,"
    "U+223C,U+2248,U+2260,U+2261,U+2264,U+2265,U+226A,U+226B,U+2272,U+2273,U+22C5,U+25CF,U+25CB,U+25A0,U+25A1,U+2713,U+2717"
)


def cut(source: Path, characters: str, target: Path) -> Path:
    """Keeps these characters of a font, with the tables that place marks over letters."""
    subset.main([
        str(source), f"--unicodes={characters}", f"--output-file={target}", "--layout-features=ccmp,mark,mkmk,kern,locl",
        "--no-hinting", "--notdef-outline", "--drop-tables+=STAT,MATH,DSIG",
    ])
    return target


def main(folder: Path) -> None:
    """Writes NotoSans-{Regular,Italic,Bold} as TTF for pictures and WOFF2 for the page."""
    here = Path(__file__).parent
    with tempfile.TemporaryDirectory() as scratch:
        signs = cut(folder / "NotoSansMath-Regular.ttf", SIGNS, Path(scratch) / "signs.ttf")
        for face in ("Regular", "Italic", "Bold"):
            letters = cut(folder / f"NotoSans-{face}.ttf", LETTERS, Path(scratch) / "letters.ttf")
            model = TTFont(letters)
            font = Merger().merge([str(letters), str(signs)])
            # names and vertical measures are those of the letters
            font["name"], font["OS/2"] = model["name"], model["OS/2"]
            for measure in ("ascent", "descent", "lineGap"):
                setattr(font["hhea"], measure, getattr(model["hhea"], measure))
            font["head"].created = font["head"].modified = model["head"].created
            font.recalcTimestamp = False
            font.save(here / f"NotoSans-{face}.ttf")
            font.flavor = "woff2"
            font.save(here / f"NotoSans-{face}.woff2")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
