"""The program `polhode`, and its answers with balls for numbers."""

import fractions
import json
import os
import pathlib
import shutil
import subprocess

from ._polhode import ball


class PolhodeError(ValueError):
    """What the program refused, in its own sentence."""


def path():
    """The program: $POLHODE_PROGRAM, that which was built or installed with this package, or the
    first in PATH."""
    here = pathlib.Path(__file__).resolve()
    beside = [here.parents[2] / "polhode", here.parents[4] / "bin" / "polhode"]
    for candidate in [os.environ.get("POLHODE_PROGRAM"), *beside, shutil.which("polhode")]:
        if candidate and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            return str(candidate)
    raise PolhodeError("the program polhode is not found: build it, install it, or set "
                       "POLHODE_PROGRAM to its path")


def text_of(number):
    """An exact number or a ball's middle as the program reads it; other things as they are."""
    if isinstance(number, float) and not number.is_integer():
        raise TypeError(f"{number!r} is a float, a binary number that is seldom the decimal it "
                        f"looks like: write \"{number!r}\", Fraction or Decimal")
    if isinstance(number, float):
        return str(int(number))
    if isinstance(number, ball):
        if not number.is_exact:
            raise TypeError("a ball that is no single number cannot be given to the program")
        return str(number.mid)
    return str(number)


def joined(numbers):
    """The numbers with commas between them."""
    return ",".join(text_of(x) for x in numbers)


def options_of(options):
    """digits=30, lower_bound=True: ["--digits", "30", "--lower-bound"]."""
    result = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        result.append("--" + name.replace("_", "-"))
        if value is not True:
            result.append(joined(value) if isinstance(value, (list, tuple)) else text_of(value))
    return result


def with_balls(answer):
    """The JSON answer, in which each number, an object with its ends, is a ball; a Fraction where
    it is known exactly."""
    if isinstance(answer, dict):
        if "rational" in answer:
            return fractions.Fraction(answer["rational"])
        if "lower" in answer and "upper" in answer and "value" in answer:
            digits = max(len(answer["upper"]), len(answer["lower"]), 15)
            return ball.hull_of(answer["lower"], answer["upper"], digits)
        return {key: with_balls(value) for key, value in answer.items()}
    if isinstance(answer, list):
        return [with_balls(value) for value in answer]
    return answer


def run_for_bytes(*arguments, accept=(0, 1)):
    """What the program prints for these arguments, as bytes.

    Raises PolhodeError, with the program's sentence, where its exit status is not accepted: 0 is
    certified, 1 not certified, 2 bad usage or input, 3 a contradiction.
    """
    done = subprocess.run([path(), *map(text_of, arguments)], capture_output=True, check=False)
    if done.returncode not in accept:
        lines = done.stderr.decode().strip().splitlines()
        raise PolhodeError(lines[-1] if lines else f"exit status {done.returncode}")
    return done.stdout


def run(*arguments, accept=(0, 1)):
    """What the program prints, as text; otherwise as run_for_bytes."""
    return run_for_bytes(*arguments, accept=accept).decode()


def answer_of(*arguments, accept=(0, 1)):
    """The program's JSON answer as a dict, with balls for numbers."""
    return with_balls(json.loads(run(*arguments, "--format", "json", accept=accept)))
