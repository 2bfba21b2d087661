#!/usr/bin/env python3
"""Refuses a sentence that prover and checker both spell out.

The words of a claim stand once, in src/statements; a sentence typed in proofs/ and in src/checker
would have to be changed in two places.

    words_once.py ROOT          checks the tree at ROOT; exit status 1 and a line for each sentence
    words_once.py --self-test   checks that it finds one
"""

import os
import re
import sys

LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
PIECE = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
# Keys of witnesses are the format of certificates, and have no spaces; shorter texts are words.
LEAST = 24


def sentences(text):
    """The string literals of a source that are sentences, neighbours joined."""
    code = re.sub(r"//[^\n]*", "", text)
    joined = ("".join(PIECE.findall(found)) for found in LITERALS.findall(code))
    return {literal for literal in joined if len(literal) >= LEAST and " " in literal}


def sentences_below(folder):
    """All sentences below a folder, each with a file that has it."""
    found = {}
    for directory, _, names in os.walk(folder):
        for name in names:
            if name.endswith((".cpp", ".hpp")):
                path = os.path.join(directory, name)
                with open(path, encoding="utf-8") as file:
                    for sentence in sentences(file.read()):
                        found.setdefault(sentence, path)
    return found


def twice(provers, checkers):
    return sorted(set(provers) & set(checkers))


def self_test():
    prover = 'fact("at the given a, b: " "the phase is above 2 pi", holds);'
    checker = 'e.fact(\n    "at the given a, b: the phase "\n    "is above 2 pi", holds);'
    other = 'e.fact(statements::phase_is_above, holds);  // "at the given a, b: the phase is above 2 pi"'
    assert twice(sentences(prover), sentences(checker)) == [
        "at the given a, b: the phase is above 2 pi"]
    assert not twice(sentences(prover), sentences(other))
    print("words_once: finds a sentence that is typed twice")


def main():
    if len(sys.argv) != 2:
        sys.exit("words_once.py: usage: words_once.py ROOT | --self-test")
    if sys.argv[1] == "--self-test":
        return self_test()
    provers = sentences_below(os.path.join(sys.argv[1], "proofs"))
    provers.update(sentences_below(os.path.join(sys.argv[1], "src", "certificate")))
    checkers = sentences_below(os.path.join(sys.argv[1], "src", "checker"))
    if not provers or not checkers:
        sys.exit(f"words_once.py: no sentences below {sys.argv[1]}")
    found = twice(provers, checkers)
    for sentence in found:
        print(f"{provers[sentence]} and {checkers[sentence]}: \"{sentence}\": "
              "it belongs in src/statements")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
