#!/usr/bin/env python3
"""Refuses a formula evaluated over a type in a source that does not see the type's functions.

evaluation.hpp looks for the functions of a type T in supplement<T>. Where its specialization stands
in one source, and another evaluates formulas over T without it, one template has two definitions,
and the linker takes either of them. A source is safe where it sees that the template is compiled
elsewhere: "extern template class compiled_expression<T>".

    one_supplement.py ROOT       checks the tree at ROOT; exit status 1 and a line for each case
    one_supplement.py --self-test   checks that it finds one
"""

import os
import re
import sys

FOLDERS = ("include", "src")
EVALUATION_HEADER = "include/polhode/expression/evaluation.hpp"
SPECIALIZATION = re.compile(r"struct supplement<(.+?)>\s*(?:final\s*)?(?::[^{]*)?\{")
EVALUATION = re.compile(r"\b(?:evaluator|execute|evaluate_over)<\s*([\w:]+(?:<[\w:, ]+>)?)\s*>")
COMPILED_ELSEWHERE = re.compile(r"extern template class compiled_expression<(.+?)>;")
INCLUDED = re.compile(r'#include "([^"]+)"')


def sources(root):
    """The text of each C++ file, by its path."""
    texts = {}
    for folder in FOLDERS:
        for directory, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                if name.endswith((".cpp", ".hpp")):
                    path = os.path.join(directory, name)
                    with open(path, encoding="utf-8") as file:
                        texts[os.path.relpath(path, root)] = file.read()
    return texts


def seen_from(path, texts):
    """The files that a source includes, in turn, and itself."""
    seen, left = set(), [path]
    while left:
        at = left.pop()
        if at in seen:
            continue
        seen.add(at)
        for name in INCLUDED.findall(texts[at]):
            for candidate in (f"include/{name}", f"src/{name}",
                              os.path.normpath(os.path.join(os.path.dirname(at), name))):
                if candidate in texts:
                    left.append(candidate)
    return seen


def cases(texts):
    """Each evaluation that does not see the specialization of its type."""
    home = {}
    for path, text in texts.items():
        if path == EVALUATION_HEADER:  # whoever instantiates an evaluation includes it
            continue
        for name in SPECIALIZATION.findall(text):
            home[name.removeprefix("detail::")] = path
    found = []
    for path in sorted(texts):
        if not path.endswith(".cpp"):
            continue
        seen = seen_from(path, texts)
        elsewhere = {name for part in seen for name in COMPILED_ELSEWHERE.findall(texts[part])}
        for name in sorted(set(EVALUATION.findall(texts[path]))):
            where = home.get(name.removeprefix("detail::"))
            if where is not None and where not in seen and name not in elsewhere:
                found.append(f"{path}: formulas over {name}, whose functions are in {where}")
    return found


def self_test():
    texts = {
        "src/a.hpp": "template <>\nstruct supplement<seen> {\n",
        "src/b.cpp": "template <>\nstruct supplement<unseen> : base<unseen> {};\n",
        "src/b.hpp": "extern template class compiled_expression<compiled>;\n",
        "src/d.cpp": "template <>\nstruct supplement<compiled> {\n",
        "src/c.cpp": '#include "a.hpp"\n#include "b.hpp"\n'
                     "f.evaluator<seen>(64); f.evaluator<unseen>(64); f.evaluator<compiled>(64);\n",
    }
    found = cases(texts)
    expected = ["src/c.cpp: formulas over unseen, whose functions are in src/b.cpp"]
    if found != expected:
        print(f"found {found}, not {expected}")
        return 1
    return 0


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    if sys.argv[1] == "--self-test":
        return self_test()
    found = cases(sources(sys.argv[1]))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
