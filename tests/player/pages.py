#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens animated pages in a headless Chromium, and compares them with `elgen simulate`.

    pages.py ELGEN MODEL...    one line per model; exit code 1 if a state differs or a page logs a message

A page opened with #test=T runs T seconds at once and shows its state in all digits. The reference is
the same method with the same step size or tolerance. States may differ by 1e-10 after fixed steps,
relative to the largest coordinate or rate, because a browser's sines differ from the C library's.
After adapted steps they may differ by 1e-7: if such a difference decides whether a step is accepted,
the state changes by the tolerance of a step, 1e-9, which the motion may amplify. Chaotic systems
amplify most, so they are compared after half a second.
"""

import html.parser
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

FIXED, ADAPTED = 1e-10, 1e-7
USUAL = (2.5, 0.002)  # seconds of each run, and the step size
CHAOTIC = (0.5, 0.002)
CHAOS = ["acrobot", "chain", "chain_rope", "double_pendulum", "panda7", "panda7_calibrated", "panda7_gravity",
         "panda7_rollouts", "swinging_atwood", "triple_pendulum"]
RUNS = {"andrews": (0.03, 1e-5), "five_bar": (0.25, 0.002)} | {name: CHAOTIC for name in CHAOS}  # both stop soon after


class State(html.parser.HTMLParser):
    """The text of the element <output id="state">."""

    def __init__(self, text):
        super().__init__()
        self.text, self.inside = "", False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.inside = self.inside or dict(attributes).get("id") == "state"

    def handle_endtag(self, tag):
        self.inside = self.inside and tag != "output"

    def handle_data(self, data):
        self.text += data if self.inside else ""


def browser():
    return next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)


def run(command, seconds=120):
    return subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)


def opened(page, time):
    """The state that the page shows, and its console messages."""
    command = [browser(), "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
               "--enable-logging=stderr", "--virtual-time-budget=5000", "--dump-dom", f"file://{page}#test={time}"]
    shown = run(command)
    console = [line for line in shown.stderr.splitlines() if ":CONSOLE" in line]
    try:
        return json.loads(State(shown.stdout).text), console
    except json.JSONDecodeError:
        return None, console or ["no state"]


def expected(elgen, model, time, steps):
    """Coordinates and rates at the end of the run; angles that wrap are in (-pi, pi]."""
    command = [elgen, "simulate", "-q", *steps, "--time", str(time), "--every", str(time)]
    shown = run([*command, "--format", "json", model])
    if shown.returncode != 0:
        raise RuntimeError(shown.stderr.strip())
    data = json.loads(shown.stdout)
    names = [column["name"] for column in data["columns"]]
    end = len(names) - 1 - [name == "E" for name in reversed(names)].index(True)
    return data["rows"][-1][1:end]


def difference(shown, wanted):
    """The largest difference, relative to the largest coordinate or rate. Whole turns of an angle do not count."""
    wanted = wanted[:len(shown)]  # inputs and multipliers follow the state
    turn = 2 * math.pi
    apart = [abs(a - b) if abs(a - b) < 3 else abs(math.remainder(a - b, turn)) for a, b in zip(shown, wanted)]
    return max(apart) / (max(abs(x) for x in wanted) or 1.0)


def verdict(elgen, model, folder):
    name = os.path.basename(model).split(".")[0]
    time, step = RUNS.get(name, USUAL)
    page = os.path.join(folder, name + ".html")
    parts = []
    for steps, permitted in ((["--method", "rk4", "--step", str(step)], FIXED), (["--method", "dopri5"], ADAPTED)):
        made = run([elgen, "simulate", "-q", "--time", "20", *steps, "-o", page, "--force", model])
        if made.returncode != 0:
            return False, made.stderr.strip().splitlines()[0]
        shown, console = opened(page, time)
        if console:
            return False, console[0]
        parts.append(difference(shown, expected(elgen, model, time, steps)))
        if not parts[-1] <= permitted:
            return False, f"differs by {parts[-1]:.1e} at {time} s by {steps[1]}"
    apart = " and ".join(f"{part:.1e}" for part in parts)
    return True, f"differs by {apart} at {time} s, {os.path.getsize(page) / 1000:.0f} KB"


def main():
    elgen, *models = sys.argv[1:]
    if browser() is None:
        print("skipped: no Chromium")
        return 0
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for model in models:
            holds, text = verdict(os.path.abspath(elgen), model, folder)
            failures += not holds
            print(f"{'holds' if holds else 'FAILS'}  {re.sub('.*/', '', model)}  {text}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
