#!/usr/bin/env python3
"""Damages scenes as typing errors, editors and attackers do, and runs the program on them (README.md).

    python3 tests/fuzz/scene_fuzz.py build/bin/diefill 1000 --seed 1 --keep out/scene_fuzz
    python3 tests/fuzz/scene_fuzz.py build-asan/bin/diefill 1000 --seeds-by build/bin/diefill --no-address-limit --slower 20
    python3 tests/fuzz/scene_fuzz.py build/bin/diefill --replay out/scene_fuzz/*/scene.toml

Every input must end in exit code 0, or in 2 with one line on standard error; a run that was begun also in 3 (it left
the method's range) or 130 (its budget was over). None may take more than 20 s of processor time or 1 GB.
"""
import argparse
import collections
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from scene_damage import damage

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LONGEST = 20  # s of processor time
LARGEST = 1000  # MB
RUN_BUDGET = 3  # s after which a run is asked to stop


def make_folder(scene_file, data):
    """A folder with the scene's neighbours, files that are none, and `data` as scene.toml."""
    folder = tempfile.mkdtemp(prefix="diefill_scene_fuzz_")
    source = os.path.dirname(os.path.abspath(scene_file))
    for name in os.listdir(source):
        if name != "scene.toml":
            os.symlink(os.path.join(source, name), os.path.join(folder, name))
    for name in ("pipe.stl", "pipe.csv"):
        os.mkfifo(os.path.join(folder, name))
    for name in ("sparse.stl", "sparse.csv"):
        with open(os.path.join(folder, name), "wb") as sparse:
            sparse.truncate(10 << 30)
    open(os.path.join(folder, "empty.stl"), "wb").close()
    os.mkdir(os.path.join(folder, "folder.stl"))
    os.symlink("loop.stl", os.path.join(folder, "loop.stl"))
    with open(os.path.join(folder, "scene.toml"), "wb") as scene:
        scene.write(data)
    return folder


class Ending:
    def __init__(self, status, usage, wall, out, err):
        self.code = os.waitstatus_to_exitcode(status)
        self.cpu, self.memory, self.wall = usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, wall
        self.out, self.err = out, err


def run(arguments, folder, limits):
    """Runs the program under limits; asks a run to stop after its budget."""
    def set_limits():
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # a shell's background job ignores it, and hands that on
        if limits.address:
            resource.setrlimit(resource.RLIMIT_AS, (limits.address << 20, limits.address << 20))
        resource.setrlimit(resource.RLIMIT_CPU, (int(3 * LONGEST * limits.slower), int(3 * LONGEST * limits.slower) + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begun = time.time()
        child = subprocess.Popen(arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err, preexec_fn=set_limits)
        budget = begun + RUN_BUDGET * limits.slower if arguments[1] == "run" else None
        while True:
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            now = time.time()
            if pid:
                break
            if budget and now > budget:
                child.send_signal(signal.SIGINT)
                budget = None
            if now - begun > 6 * LONGEST * limits.slower:
                child.kill()
            time.sleep(0.005)
        child.returncode = 0
        out.seek(0), err.seek(0)
        return Ending(status, usage, now - begun, out.read(), err.read())


def is_progress(line):
    return re.match(rb"\s*\d+ %  ", line) or line.startswith(b"t = ") or line.startswith(b"warning: ") or b"Numbers chosen by" in line


def faults_of(command, ending, limits):
    faults = []
    # Asked to stop before it listens, a run ends as any program does.
    allowed = (0, 2, 3, 130, -signal.SIGINT) if command == "run" else (0, 2)
    if ending.code not in allowed:
        faults.append("exit code %d after %.0f s, of which %.1f s of processor time" % (ending.code, ending.wall, ending.cpu))
    complaints = [line for line in ending.err.split(b"\n") if line.startswith(b"diefill: ")]
    if ending.code == 2 and (len(complaints) != 1 or not ending.err.rstrip(b"\n").endswith(complaints[0])):
        faults.append("%d lines begin with the program's name" % len(complaints))
    if any(byte < 32 and byte != 10 for byte in ending.err) or b"\x7f" in ending.err:
        faults.append("control characters on standard error")
    if len(ending.err) > 4000 and ending.code == 2:
        faults.append("%d bytes on standard error" % len(ending.err))
    if ending.cpu > LONGEST * limits.slower:
        faults.append("%.0f s of processor time" % ending.cpu)
    if ending.memory > LARGEST * limits.slower:
        faults.append("%.0f MB" % ending.memory)
    return faults


def command_for(rng):
    choice = rng.random()
    if choice < 0.84:
        return ["check"]
    return ["plan", "--no-benchmark"] if choice < 0.92 else ["run", "--out", "fuzz_out", "--no-pictures", "--threads", "1"]


def arguments_of(program, command):
    return [program, command[0], "scene.toml"] + command[1:]


def seeds_in(program, folders, limits, slowest):
    """Scenes that the program checks quickly as they are."""
    seeds = []
    for top in folders:
        for folder, _, names in sorted(os.walk(top)):
            for name in sorted(names):
                if not name.endswith(".toml"):
                    continue
                file = os.path.join(folder, name)
                with open(file, "rb") as scene:
                    data = scene.read()
                if len(data) > 50000:
                    continue
                work = make_folder(file, data)
                ending = run([program, "check", "scene.toml"], work, limits)
                shutil.rmtree(work)
                if ending.code in (0, 2) and ending.cpu < slowest * limits.slower:
                    seeds.append((file, data.decode("utf-8", "replace")))
    return seeds


def seeds_found(program, limits):
    if not limits.seeds_by:
        return seeds_in(program, limits.scenes, limits, limits.slowest)
    plain = argparse.Namespace(address=0, slower=1)
    return seeds_in(os.path.abspath(limits.seeds_by), limits.scenes, plain, limits.slowest)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("count", nargs="?", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first input")
    parser.add_argument("--scenes", nargs="+", default=[os.path.join(PROJECT, "sample_tools")], help="folders of scenes to damage")
    parser.add_argument("--seeds-by", metavar="PROGRAM",
                        help="program that finds the scenes to damage, where the one under test is slow, as with sanitizers")
    parser.add_argument("--slowest", type=float, default=4, help="s of processor time that the check of a scene may take to be damaged")
    parser.add_argument("--keep", help="folder for inputs that ended wrongly")
    parser.add_argument("--address", type=int, default=6000, help="MB of address space for the program")
    parser.add_argument("--no-address-limit", dest="address", action="store_const", const=0, help="for sanitizers")
    parser.add_argument("--slower", type=float, default=1, help="how many times the limits are, for sanitizers")
    parser.add_argument("--replay", nargs="+", metavar="SCENE", help="check these scenes as they are")
    limits = parser.parse_args()
    program = os.path.abspath(limits.program)

    endings, slowest, largest, wrong = collections.Counter(), (0, ""), (0, ""), 0

    def take(name, source, data, command):
        nonlocal slowest, largest, wrong
        folder = make_folder(source, data)
        ending = run(arguments_of(program, command), folder, limits)
        endings["%s: %s" % (command[0], ending.code)] += 1
        slowest, largest = max(slowest, (ending.cpu, name)), max(largest, (ending.memory, name))
        faults = faults_of(command[0], ending, limits)
        if faults:
            wrong += 1
            print("%s (%s, %s): %s: %s" % (name, os.path.relpath(source, PROJECT), " ".join(command), "; ".join(faults),
                                           ending.err[-300:].decode("utf-8", "replace").strip()), flush=True)
            if limits.keep:
                shutil.copytree(folder, os.path.join(limits.keep, name), symlinks=True, dirs_exist_ok=True,
                                ignore=shutil.ignore_patterns("pipe.*", "sparse.*", "fuzz_out"))
        shutil.rmtree(folder)

    if limits.replay:
        for file in limits.replay:
            with open(file, "rb") as scene:
                take(file, file, scene.read(), ["check"])
    else:
        seeds = seeds_found(program, limits)
        if not seeds:
            sys.exit("no scene to damage")
        texts = [text for _, text in seeds]
        print("%d scenes to damage" % len(seeds), flush=True)
        for number in range(limits.first, limits.first + limits.count):
            rng = random.Random(limits.seed * 1000003 + number)
            file, text = rng.choice(seeds)
            take("%d_%d" % (limits.seed, number), file, damage(text, texts, rng), command_for(rng))
    for ending, times in sorted(endings.items()):
        print("%8d  %s" % (times, ending))
    print("%d inputs, %d wrong; longest %.1f s of processor time (%s), largest %.0f MB (%s)"
          % (sum(endings.values()), wrong, slowest[0], slowest[1], largest[0], largest[1]))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
