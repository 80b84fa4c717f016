"""Measure memory and time for a large class: of a run that resumes, of one late file, and of the report.

    python benchmarks/size.py                      1,000, 10,000 and 70,000 submissions: 5,000 students times 14
    python benchmarks/size.py --sizes 1000 5000

Four submissions to each assignment are really graded: the solution, two wrong ones, and the stub. The results of all
others are copied from that of the same text; the grader makes their pages. Then each command runs as a process. Prints
a table and writes results/size.json: wall time and processor time, s, and the peak memory of the coordinator.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import record
from tqdm import tqdm

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import overlays
from tam570_grader.grading import batch
from tam570_grader.grading.submissions import submissions
from tam570_grader.release.stubs import stub
from tam570_grader.results.records import read
from tam570_grader.sandbox.zygote import ResourceLimits

OUTPUT = record.FOLDER / "size.json"
COURSE = assignments.find()
SLUGS = assignments.slugs(COURSE)
WORKS = 4  # on each assignment
SEED = 570
# runs a command and prints its cost in the last line
RUN = """
import json, resource, sys, time
from tam570_grader.cli import main
started = time.perf_counter()
code = main(sys.argv[1:])
used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
most = [int(line.split()[1]) for line in open("/proc/self/status") if line.startswith("VmHWM")]
print(json.dumps({"seconds": time.perf_counter() - started, "mib": most[0] / 1024,
                  "cpu_seconds": sum(usage.ru_utime + usage.ru_stime for usage in used)}), file=sys.stderr)
sys.exit(code)
"""


def works(slug):
    """Return the texts of the submissions to an assignment."""
    solution = (COURSE / "solutions" / f"{slug}.py").read_text()
    wrong = list(overlays(assignments.checks_folder(COURSE, slug)).values())
    return [solution, *(f"{solution}\n\n{text}" for text in (wrong[0], wrong[-1])), stub(solution)]


def class_of(size, folder):
    """Write `size` submissions, one student's to all assignments after another's; return how to grade them."""
    texts = {slug: works(slug) for slug in SLUGS}
    for number in range(size):
        student, slug = number // len(SLUGS), SLUGS[number % len(SLUGS)]
        path = folder / f"student{student:04}" / slug / f"{slug}.py"
        path.parent.mkdir(parents=True)
        path.write_text(texts[slug][student % WORKS])
    return batch.RunConfig(
        COURSE, submissions([folder], SLUGS), SEED, 1, ResourceLimits(cpu=60, call=10)
    )  # integers, as on the command line


def graded():
    """Grade the works; return their results by assignment and number."""
    with tempfile.TemporaryDirectory() as folder:
        config = class_of(WORKS * len(SLUGS), Path(folder))
        lines = tqdm(batch.records(config), total=len(config.submissions), desc="grading", leave=False, disable=None)
        return {work_of(result.student, result.assignment): result for result in map(read, lines)}


def work_of(student, slug):
    return slug, int(student.removeprefix("student")) % WORKS


def write_journal(config, results, folder):
    """Write `results.jsonl` as a run leaves it."""
    folder.mkdir()
    with open(folder / "results.jsonl", "w") as file:
        for student, slug, digest in batch.digests(config):
            result = replace(results[work_of(student, slug)], student=student, digest=digest)
            file.write(json.dumps(result.record()) + "\n")


def measured(*arguments):
    """Run a command; return its seconds and memory."""
    command = [sys.executable, "-c", RUN, *map(str, arguments)]
    done = subprocess.run(command, cwd=COURSE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(f"{arguments[0]} failed: {done.stderr}")
    return json.loads(done.stderr.splitlines()[-1])


def costs(size, results):
    """Measure each command on a class of this size, in the order in which an instructor runs them."""
    with tempfile.TemporaryDirectory() as folder:
        handed_in, out = Path(folder) / "submitted", Path(folder) / "out"
        write_journal(class_of(size, handed_in), results, out)
        stored = (out / "results.jsonl").read_bytes()
        grade = "grade", handed_in, "--out", out, "--jobs", "1"
        commands = {"all pages": measured(*grade), "resume": measured(*grade)}
        assert (out / "results.jsonl").read_bytes() == stored, "something was graded again"
        late = handed_in / "late" / SLUGS[0] / f"{SLUGS[0]}.py"
        late.parent.mkdir(parents=True)
        late.write_text(works(SLUGS[0])[0])
        commands |= {"late file": measured(*grade), "report": measured("report", out)}
        megabytes = (out / "report.html").stat().st_size / 1e6
    return {"submissions": size, "journal_mb": len(stored) / 1e6, "page_mb": megabytes, **commands}


def print_rows(rows):
    for row in rows:
        print(f"{row['submissions']} submissions, {row['journal_mb']:.1f} MB of results, page {row['page_mb']:.2f} MB")
        for command, cost in row.items():
            if isinstance(cost, dict):
                print(
                    f"  {command:10} {cost['seconds']:8.1f} s  {cost['cpu_seconds']:8.1f} s of the processor"
                    f"  {cost['mib']:6.0f} MiB"
                )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", type=int, nargs="+", default=[1000, 10000, 70000], metavar="N")
    options = parser.parse_args()
    results, rows = graded(), []
    for size in tqdm(sorted(options.sizes), desc="classes", leave=False, disable=None):
        rows.append(costs(size, results))
        record.write(OUTPUT, rows=rows)
    print_rows(rows)


if __name__ == "__main__":
    main()
