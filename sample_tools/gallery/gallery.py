#!/usr/bin/env python3
"""Runs the worked examples of examples.toml and writes sample_tools/README.md from what they gave.

    python3 sample_tools/gallery/gallery.py                   runs all; fails where an answer leaves its range
    python3 sample_tools/gallery/gallery.py --only first_map  runs one
    python3 sample_tools/gallery/gallery.py --write           also keeps answers, times, pictures and the page
    python3 sample_tools/gallery/gallery.py --page            checks that the page agrees with the kept answers

The program is that of the build or, where there is none, the installed one; results go to out/gallery of the current
folder.
"""
import argparse
import csv
import json
import os
import shlex
import shutil
import subprocess
import sys
import time
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PAGE = HERE.parent / "README.md"
KEPT = HERE / "answers.csv"
COLUMNS = ["example", "figure", "value"]


class GalleryError(Exception):
    """An example that cannot be run, or whose answer is not the stated one."""


def read_examples():
    with open(HERE / "examples.toml", "rb") as file:
        return tomllib.load(file)


def placed(command, out):
    """A command with OUT put in place, for a shell."""
    return command.replace("OUT", shlex.quote(str(out)))


def run_commands(example, program, out):
    """Runs the commands of an example in the project's folder; returns the wall time in s."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    began = time.monotonic()
    for command in example["commands"]:
        words = placed(command, out)
        if words.startswith("diefill "):
            words = shlex.quote(str(program)) + words[len("diefill"):]
        done = subprocess.run(words, shell=True, cwd=ROOT, capture_output=True, text=True)
        if done.returncode != 0:
            raise GalleryError(f"{command}: exit code {done.returncode}: {done.stderr.strip()[-400:]}")
        (out / "printed.txt").write_text(done.stdout)
    return time.monotonic() - began


def value_at(document, path):
    """The value after a path such as `cavities/0/share` of a JSON document."""
    for key in path.split("/"):
        document = document[int(key)] if isinstance(document, list) else document[key]
    return document


def csv_value(file, row, column):
    """The value in `column` of the first line of a CSV file that has `row` in any field."""
    with open(file, newline="") as text:
        for line in csv.DictReader(part for part in text if not part.startswith("#")):
            if row in line.values():
                return line[column]
    raise GalleryError(f"{file}: no line with '{row}'")


def figure_value(figure, out):
    file = out / figure["file"]
    if not file.exists():
        raise GalleryError(f"{file} was not written")
    if "row" in figure:
        value = csv_value(file, figure["row"], figure["column"])
    else:
        try:
            value = value_at(json.loads(file.read_text()), figure["path"])
        except (KeyError, IndexError, TypeError, json.JSONDecodeError) as error:
            raise GalleryError(f"{file}: nothing at {figure['path']}") from error
    return float(value) * figure.get("factor", 1)


def examine(example, out):
    """The figures of an example by name. Throws GalleryError where one is outside its range."""
    values = {}
    for figure in example["figure"]:
        value = figure_value(figure, out)
        if not figure["from"] <= value <= figure["to"]:
            raise GalleryError(f"{figure['label']} {value:.6g}, accepted: {figure['from']} to {figure['to']}")
        values[figure["name"]] = value
    if not (out / example["picture"]).exists():
        raise GalleryError(f"{example['picture']} was not drawn")
    return values


def read_kept():
    kept = {}
    if KEPT.exists():
        with open(KEPT, newline="") as text:
            for line in csv.DictReader(text):
                kept.setdefault(line["example"], {})[line["figure"]] = float(line["value"])
    return kept


def write_kept(kept, order):
    with open(KEPT, "w", newline="") as text:
        lines = csv.writer(text, lineterminator="\n")
        lines.writerow(COLUMNS)
        for name in order:
            for figure, value in kept.get(name, {}).items():
                lines.writerow([name, figure, f"{value:.6g}"])


def duration_text(seconds):
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min"


def section(example, values):
    """The example as a section of the page."""
    lines = [f"## {example['question']}", ""]
    lines += [f"![{example['caption']}](gallery/{example['name']}.png)", "", "```"]
    lines += [placed(command, "out/" + example["name"]) for command in example["commands"]]
    lines += ["```", "", example["answer"].strip().format(**values), ""]
    return lines + [f"*{duration_text(values['seconds'])} on two cores.*", ""]


def page_text(document, kept):
    lines = [document["title"], "", document["introduction"].strip(), ""]
    for example in document["example"]:
        if example["name"] in kept:
            lines += section(example, kept[example["name"]])
    return "\n".join(lines + [document["end"].strip()]) + "\n"


def run_one(example, program, out, keep):
    load = os.getloadavg()[0]
    seconds = run_commands(example, program, out)
    values = examine(example, out)
    if keep:
        shutil.copyfile(out / example["picture"], HERE / (example["name"] + ".png"))
    return {**values, "seconds": seconds, "load": load}


def run_all(document, arguments):
    kept, failed = read_kept(), 0
    for example in document["example"]:
        if arguments.only and example["name"] not in arguments.only:
            continue
        try:
            values = run_one(example, arguments.program, arguments.out / example["name"], arguments.write)
        except GalleryError as error:
            failed += 1
            print(f"{example['name']:20} FAILED  {error}", flush=True)
            continue
        kept[example["name"]] = values
        print(f"{example['name']:20} passed  {values['seconds']:7.1f} s  "
              + example["answer"].strip().replace("\n", " ").format(**values), flush=True)
    if arguments.write:
        write_kept(kept, [example["name"] for example in document["example"]])
        PAGE.write_text(page_text(document, read_kept()))
    return 1 if failed else 0


def check_page(document):
    if PAGE.read_text() == page_text(document, read_kept()):
        return 0
    print(f"{PAGE} is not what the kept answers give; run: python3 sample_tools/gallery/gallery.py --write")
    return 1


def found_program():
    """The program of the build, else the installed one."""
    built = ROOT / "build/bin/diefill"
    return built if built.exists() else Path(shutil.which("diefill") or built)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=found_program())
    parser.add_argument("--out", type=Path, default=Path("out/gallery"), help="directory for the results")
    parser.add_argument("--only", nargs="*", metavar="NAME", help="examples to run")
    parser.add_argument("--write", action="store_true", help="keep answers, times, pictures and the page")
    parser.add_argument("--page", action="store_true", help="only compare the page with the kept answers")
    arguments = parser.parse_args()
    arguments.program, arguments.out = arguments.program.resolve(), arguments.out.resolve()
    document = read_examples()
    unknown = set(arguments.only or []) - {example["name"] for example in document["example"]}
    if unknown:
        parser.error(f"no example is named {', '.join(sorted(unknown))}")
    if arguments.page:
        return check_page(document)
    if not arguments.program.exists():
        parser.error(f"{arguments.program} is missing: build it with sh app/build.sh --target diefill, or install diefill")
    return run_all(document, arguments)


if __name__ == "__main__":
    sys.exit(main())
