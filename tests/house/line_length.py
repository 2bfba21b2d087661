#!/usr/bin/env python3
"""Refuses comments of C++ files that are longer than 100 columns: clang-format sees to the code.

    line_length.py ROOT       checks the tree at ROOT; exit status 1 and a line for each comment
    line_length.py --self-test   checks that it finds one
"""

import os
import re
import sys

COLUMNS = 100
FOLDERS = ("bench", "examples", "include", "proofs", "python", "src", "tests")
# A comment by itself, but for those that clang-tidy reads.
COMMENT = re.compile(r"\s*//(?!\s*NOLINT)")


def too_long(lines):
    """The numbers of the lines that are comments of more than 100 columns."""
    return [number for number, line in enumerate(lines, 1)
            if len(line.rstrip("\n")) > COLUMNS and COMMENT.match(line)]


def check(root):
    found = 0
    for folder in FOLDERS:
        for directory, _, names in os.walk(os.path.join(root, folder)):
            for name in sorted(names):
                if not name.endswith((".cpp", ".hpp")):
                    continue
                path = os.path.join(directory, name)
                with open(path, encoding="utf-8") as file:
                    for number in too_long(file):
                        print(f"{os.path.relpath(path, root)}:{number}: a comment of more than "
                              f"{COLUMNS} columns")
                        found += 1
    return 1 if found else 0


def self_test():
    long_text = "x" * COLUMNS
    lines = [f"// {long_text}\n", "// short\n", f'  call("{long_text}");\n',
             f"  /// {long_text}\n", f"  // NOLINT(rule): {long_text}\n"]
    return 0 if too_long(lines) == [1, 4] else 1


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(sys.argv[1]))
