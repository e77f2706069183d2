#!/usr/bin/env python3
"""Executes the notebooks of this folder and compares what they print with what is stored; with --write stores it anew.

What is stored has no trace of the machine: no times, no counters, no versions, cells named by their place. A cell prints
what is proved, and then its text is compared letter by letter; or it computes in the doubles of this machine, has the
tag `doubles`, and then its words are compared, and its numbers up to a factor of ten: they depend on the
processor and on the versions of SciPy and NumPy. Of a picture only that it is there.
"""

import re
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
NOTEBOOKS = sorted(HERE.glob("*.ipynb"))

METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?", re.IGNORECASE)
# A tagged cell may be wrong by so much: doubles that are far apart are another result.
FACTOR = 10


def executed(path):
    """The notebook, run from its first cell to its last by a new kernel in an empty folder, without traces of that."""
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(path, as_version=4)
    with tempfile.TemporaryDirectory() as folder:
        client = NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": folder}})
        client.execute()
    return cleaned(notebook)


def cleaned(notebook):
    """The notebook as it is stored."""
    notebook.metadata = METADATA
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for place, cell in enumerate(notebook.cells, 1):
        cell.id = f"cell-{place}"
        tags = cell.metadata.get("tags", [])
        cell.metadata = {"tags": tags} if tags else {}
        if cell.cell_type == "code":
            cell.execution_count = None
            cell.outputs = [output for output in map(_output, merged(cell.outputs)) if output]
    return notebook


def merged(outputs):
    """Pieces of one stream, which come as the kernel sends them, are one."""
    whole = []
    for output in outputs:
        last = whole[-1] if whole else {}
        if output.output_type == "stream" == last.get("output_type") and output.name == last.name:
            last.text += output.text
        else:
            whole.append(output)
    return whole


def _output(output):
    if output.output_type == "stream":
        return output
    if "execution_count" in output:
        output.execution_count = None
    output.metadata = {}
    return output


def texts(cell):
    """What a code cell prints, and the kinds of its pictures."""
    found = []
    for output in cell.get("outputs", []):
        if output.output_type == "stream":
            found.append((output.name, output.text))
        elif output.output_type == "error":
            found.append(("error", f"{output.ename}: {output.evalue}"))
        else:
            pictures = sorted(kind for kind in output.data if kind.startswith("image/"))
            # A picture's own text is the place of an object in memory.
            found.append(("picture", " ".join(pictures)) if pictures else ("text", output.data.get("text/plain", "")))
    return found


def alike(stored, made):
    """Whether two texts in doubles are one result: the same words, and each number within a factor of ten."""
    # A longer number moves what stands beside it, and so spaces do not count.
    if NUMBER.sub("#", stored).split() != NUMBER.sub("#", made).split():
        return False
    pairs = zip(NUMBER.findall(stored), NUMBER.findall(made))
    return all(_near(float(one), float(other)) for one, other in pairs)


def _near(one, other):
    return one == other or (one * other > 0 and 1 / FACTOR <= one / other <= FACTOR)


def differences(stored, made):
    """What two runs of one notebook say differently, a line each."""
    found = []
    for old, new in zip(stored.cells, made.cells, strict=True):
        if old.cell_type != "code":
            continue
        same = alike if "doubles" in old.metadata.get("tags", []) else str.__eq__
        before, now = texts(old), texts(new)
        kinds = [kind for kind, _ in before] == [kind for kind, _ in now]
        if not kinds or not all(same(one, other) for (_, one), (_, other) in zip(before, now)):
            found.append(f"{old.id}: stored {before}, now {now}")
    return found


def main(arguments):
    import nbformat

    write = arguments == ["--write"]
    if arguments and not write:
        print("usage: run.py [--write]", file=sys.stderr)
        return 2
    wrong = 0
    for path in NOTEBOOKS:
        made = executed(path)
        if write:
            nbformat.write(made, path)
        else:
            for line in differences(nbformat.read(path, as_version=4), made):
                print(f"{path.name}: {line}")
                wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
