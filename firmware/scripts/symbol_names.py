"""Names of the source and of the symbols that builds of the C libraries make of them (twiddle/detail/build.h)."""

import re

BUILD = re.compile(r"(twd_\w+?)_(?:float|double|fixed)(?:_\w+)?$")


def source_name(symbol):
    """The source's name: twd_controller_tick of twd_controller_tick_fixed; of another symbol, the symbol."""
    found = BUILD.match(symbol)
    return found.group(1) if found else symbol
