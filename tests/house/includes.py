#!/usr/bin/env python3
"""Reads every #include of the library and the programs and refuses those that the plan of the house forbids.

    includes.py ROOT       checks the tree at ROOT; exit status 1 and a line for each forbidden include
    includes.py --self-test   checks that each rule refuses a tree that breaks it

The plan: a room is a folder of include/polhode (its public headers) and of src (its sources and private headers).
Rooms stand on floors. The rules:
  1. A room includes headers of its own and of lower floors only: never of a higher floor, nor of a neighbour.
  2. A private header is included by its own room only. Those of the open rooms are meant for all rooms above.
  3. A public header includes public headers only: private ones are not installed.
  4. The checker includes its own headers, the digest's and the texts of the claims, nothing else.
  5. Each folder is a room of the plan, and each include leads to a file.
  6. The folders inside a room include each other in one direction: there is no circle of them.
An exception is a debt: it has a reason, and it is refused once nothing needs it.
"""

import os
import re
import sys
import tempfile

# From the lowest floor to the highest.
FLOORS = [
    # What any program needs: digests, threads, near names, quotes, clocks. The texts of the claims.
    ["base", "statements"],
    ["arithmetic"],
    ["tiling"],  # the proofs that parts make up a whole
    ["elliptic"],
    ["expression"],  # formulas as text or made by a generic function, and their evaluation
    ["quadrature"],
    ["roots"],
    ["rigid_body", "certificate"],
    ["scene", "proofs", "verify", "real"],  # verify: second opinions of integrals, roots and values
    ["cost"],
    ["polhode.hpp", "cli"],  # polhode.hpp includes what a program needs most
]

# Their headers beside their sources are meant for other rooms: none of these rooms is installed on
# its own.
OPEN = {"base", "statements", "tiling", "proofs", "cost"}

# What stands apart from the floors: the room, and the files and folders of others that it may
# include.
APART = {"checker": ("src/base/sha256.hpp", "src/statements/")}
# Who may include the public headers of a room that stands apart.
APART_SERVES = {"checker": {"cli"}}

# Made while the library is built.
GENERATED = {"function_tables.hpp"}

# (the file that includes, the file that is included): why it is still so.
EXCEPTIONS = {}


def room_of(path):
    parts = path.split("/")
    if parts[0] == "proofs":
        return "proofs"
    room = parts[2] if parts[0] == "include" else parts[1]
    return "base" if room in ("version.hpp", "language.hpp") else room


def is_public(path):
    return path.startswith("include/")


def sources(root):
    for top in ("include/polhode", "src", "proofs"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in sorted(names):
                if name.endswith((".hpp", ".cpp")):
                    yield os.path.relpath(os.path.join(folder, name), root)


def target_of(root, source, include):
    """The path of the file that the include means, or None."""
    for folder in (os.path.dirname(source), "include", "src", ""):
        path = os.path.normpath(os.path.join(folder, include))
        if os.path.isfile(os.path.join(root, path)):
            return path
    return None


def problem_of(source, target):
    """What is wrong with the include, or None."""
    room, other = room_of(source), room_of(target)
    if is_public(source) and not is_public(target):
        return "a public header includes a private one"
    if room == other:
        return None
    if room in APART:
        return None if target.startswith(APART[room]) else f"{room} stands apart, and includes nothing of {other}"
    if other in APART:
        return None if room in APART_SERVES[other] else f"{other} stands apart, and {room} may not include it"
    floor = {name: number for number, names in enumerate(FLOORS) for name in names}
    if floor[other] > floor[room]:
        return f"an arrow upward: {room} stands below {other}"
    if floor[other] == floor[room]:
        return f"{room} and {other} stand on one floor"
    if not is_public(target) and other not in OPEN:
        return f"a private header of {other}"
    return None


def folder_in_room(path):
    """(room, folder) of a source in a folder of src's rooms; None for other files."""
    parts = path.split("/")
    return (parts[1], parts[2]) if parts[0] == "src" and len(parts) > 3 else None


def circles(arrows):
    """A line for each circle of arrows. arrows: (source, target) -> the line of code that makes it."""
    ahead = {}
    for start, end in arrows:
        ahead.setdefault(start, set()).add(end)

    def way(start, end):
        ways, seen = [[start]], set()
        while ways:
            at = ways.pop(0)
            for following in sorted(ahead.get(at[-1], ())):
                if following == end:
                    return [*at, end]
                if following not in seen:
                    seen.add(following)
                    ways.append([*at, following])
        return None

    said = set()
    for start, end in sorted(arrows):
        back = way(end, start)
        if back is None or frozenset(back) in said:
            continue
        said.add(frozenset(back))
        names = " -> ".join("/".join(folder) for folder in [start, *back])
        yield f"{arrows[start, end]}: a circle of folders: {names}"


def problems(root, exceptions):
    known = {name for names in FLOORS for name in names} | set(APART)
    unused = dict(exceptions)
    arrows = {}
    count = 0
    for source in sources(root):
        if room_of(source) not in known:
            yield f"{source}: {room_of(source)} is no room of the plan; give it a floor in tests/house/includes.py"
            continue
        with open(os.path.join(root, source), encoding="utf-8") as file:
            lines = file.readlines()
        for number, line in enumerate(lines, 1):
            found = re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line)
            if not found or ("<" in line and not found[1].startswith("polhode/")):
                continue
            include = found[1]
            count += 1
            target = target_of(root, source, include)
            if target is None:
                if include not in GENERATED:
                    yield f'{source}:{number}: there is no "{include}"'
                continue
            if room_of(target) not in known:
                continue  # said at the file itself
            start, end = folder_in_room(source), folder_in_room(target)
            if start and end and start[0] == end[0] and start != end:
                arrows.setdefault((start, end), f"{source}:{number}")
            problem = problem_of(source, target)
            if problem is None:
                continue
            if (source, target) in exceptions:
                unused.pop((source, target), None)
            else:
                yield f'{source}:{number}: "{include}": {problem}'
    yield from circles(arrows)
    for source, target in unused:
        yield f"{source} needs no exception for {target} any more; delete it in tests/house/includes.py"
    if count == 0:
        yield f"{root}: no source includes anything; is this the tree?"


def self_test():
    good = {
        "include/polhode/version.hpp": "",
        "include/polhode/polhode.hpp": '#include "polhode/roots/public.hpp"\n',
        "include/polhode/arithmetic/public.hpp": '#include <vector>\n#include "polhode/version.hpp"\n',
        "include/polhode/roots/public.hpp": '#include "polhode/arithmetic/public.hpp"\n',
        "include/polhode/rigid_body/public.hpp": "",
        "include/polhode/checker/public.hpp": "",
        "src/base/sha256.hpp": "",
        "src/base/quoted.hpp": "",
        "src/statements/beta.hpp": '#include "statements/shared.hpp"\n',
        "src/statements/shared.hpp": "",
        "src/checker/digest.cpp": '#include "base/sha256.hpp"\n',
        "src/checker/beta.cpp": '#include "statements/beta.hpp"\n',
        "src/arithmetic/own.hpp": '#include "base/quoted.hpp"\n',
        "src/arithmetic/ball/deep.cpp": '#include "arithmetic/own.hpp"\n#include "../own.hpp"\n',
        "src/arithmetic/functions/tables.cpp": '#include "function_tables.hpp"\n',
        "src/scene/low/own.hpp": "",
        "src/scene/middle/own.hpp": '#include "scene/low/own.hpp"\n',
        "src/scene/high/own.cpp": '#include "scene/middle/own.hpp"\n#include "scene/low/own.hpp"\n',
        "src/scene/own.hpp": '#include "scene/middle/own.hpp"\n',
        "src/scene/low/uses.cpp": '#include "scene/own.hpp"\n',
        "src/roots/own.cpp": '#include "polhode/roots/public.hpp"\n',
        "src/cost/own.hpp": '#include "proofs/own.hpp"\n',
        "src/cli/own.cpp": '#include "cost/own.hpp"\n#include "polhode/checker/public.hpp"\n',
        "proofs/own.hpp": '#include "statements/beta.hpp"\n',
    }
    # What is added to the good tree, and words of the refusal.
    bad = [
        ("src/arithmetic/up.cpp", '#include "polhode/roots/public.hpp"\n', "upward"),
        ("src/arithmetic/up.cpp", "#include <polhode/roots/public.hpp>\n", "upward"),
        ("src/arithmetic/up.cpp", '  #  include "../cost/own.hpp"\n', "upward"),
        ("src/certificate/aside.cpp", '#include "polhode/rigid_body/public.hpp"\n', "one floor"),
        ("src/roots/inside.cpp", '#include "arithmetic/own.hpp"\n', "private header of arithmetic"),
        ("src/roots/inside.cpp", '#include "../arithmetic/own.hpp"\n', "private header of arithmetic"),
        ("include/polhode/roots/not_installed.hpp", '#include "base/quoted.hpp"\n', "includes a private one"),
        ("include/polhode/base/up.hpp", '#include "polhode/arithmetic/public.hpp"\n', "upward"),
        ("src/checker/leans.cpp", '#include "base/quoted.hpp"\n', "stands apart"),
        ("src/checker/leans.cpp", '#include "polhode/arithmetic/public.hpp"\n', "stands apart"),
        ("src/statements/leans.hpp", '#include "base/quoted.hpp"\n', "one floor"),
        ("src/scene/checks.cpp", '#include "polhode/checker/public.hpp"\n', "may not include"),
        ("src/attic/new.cpp", "", "no room of the plan"),
        ("src/scene/low/back.cpp", '#include "../middle/own.hpp"\n', "a circle of folders"),
        ("src/roots/typing.cpp", '#include "polhode/roots/pubic.hpp"\n', "there is no"),
    ]

    def refused(files, exceptions):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
                with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                    file.write(text)
            return list(problems(root, exceptions))

    failures = []
    if refused(good, {}):
        failures.append(f"the good tree is refused: {refused(good, {})}")
    for path, text, words in bad:
        said = refused(good | {path: text}, {})
        if len(said) != 1 or words not in said[0]:
            failures.append(f"{path} with {text!r}: {said}")
    path, text, _ = bad[4]
    excepted = {(path, "src/arithmetic/own.hpp"): "a reason"}
    if refused(good | {path: text}, excepted):
        failures.append("an exception does not count")
    if len(refused(good, excepted)) != 1:
        failures.append("an exception that nothing needs is not refused")
    if not refused({}, {}):
        failures.append("no tree at all is not refused")
    return failures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = self_test() if sys.argv[1] == "--self-test" else list(problems(sys.argv[1], EXCEPTIONS))
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
