"""Sweeps: the same bytes by every engine, and after every failure."""

import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import threading
from fractions import Fraction
from pathlib import Path

import pytest

import couplet

PLAN = """schema = "couplet.sweep/1"
chunk = 50
[sample]
count = 1000
"""


def written(output):
    """The name of the only sweep in a folder, its record and its parts."""
    (folder,) = (path for path in Path(output).iterdir() if path.is_dir())
    files = {file.name: file.read_bytes() for file in folder.iterdir()}
    return folder.name, files | {"record": folder.with_suffix(".json").read_bytes()}


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "plan.toml"
    path.write_text(PLAN)
    return path


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """What the command writes."""
    home = tmp_path_factory.mktemp("sweep")
    (home / "plan.toml").write_text(PLAN)
    line = [sys.executable, "-m", "couplet", "sweep", str(home / "plan.toml"), "-o", str(home / "out")]
    done = subprocess.run(line, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    return written(home / "out")


def test_the_bytes_are_those_of_the_command(plan, whole, tmp_path):
    told = []
    made = couplet.sweep(plan, tmp_path / "out", progress=lambda done, rows: told.append((done, rows)))
    assert written(tmp_path / "out") == whole
    assert (made.rows, made.computed, made.kept, made.lost) == (1000, 20, 0, [])
    assert sum(made.counts.values()) == 1000 and made.counts["stands"] > 100
    assert told[-1] == (1000, 1000) and len(told) == 20
    assert Path(made.folder) == tmp_path / "out" / whole[0]
    again = couplet.sweep(plan, str(tmp_path / "out"))
    assert (again.computed, again.kept, again.counts) == (0, 20, made.counts)
    found = made.verify(30, threads=2)
    assert (found["parts"], found["rows"], found["again"], found["certified"], found["faults"]) == (20, 1000, 30, 20, [])


def test_shares_are_the_whole(plan, whole, tmp_path):
    for share in [(3, 3), (1, 3), (2, 3)]:
        couplet.sweep(plan, tmp_path / "out", only=share, workers=1)
    assert written(tmp_path / "out") == whole


def test_processes_of_which_some_are_killed(plan, whole, tmp_path):
    killed = []

    def tell(done, rows):
        # Two in a row: the second is one of the new pool.
        if done >= 200 * (len(killed) + 1) and len(killed) < 2:
            child = multiprocessing.active_children()[0]
            os.kill(child.pid, signal.SIGKILL)
            killed.append(child.pid)

    made = couplet.sweep(plan, tmp_path / "out", "processes", workers=2, progress=tell)
    assert len(set(killed)) == 2 and made.rows == 1000
    assert written(tmp_path / "out") == whole


DRIVER = """
import sys, couplet
if __name__ == "__main__":
    couplet.sweep(sys.argv[1], sys.argv[2], "processes", workers=2, progress=lambda *done: print(*done, flush=True))
"""


def test_a_driver_that_is_killed(plan, whole, tmp_path):
    (tmp_path / "driver.py").write_text(DRIVER)
    line = [sys.executable, str(tmp_path / "driver.py"), str(plan), str(tmp_path / "out")]
    driver = subprocess.Popen(line, stdout=subprocess.PIPE, text=True)
    assert driver.stdout.readline()
    driver.kill()
    driver.communicate()
    made = couplet.sweep(plan, tmp_path / "out")
    assert made.kept >= 1 and made.rows == 1000
    assert written(tmp_path / "out") == whole


def test_ray(plan, whole, tmp_path):
    ray = pytest.importorskip("ray")
    try:
        couplet.sweep(plan, tmp_path / "out", "ray", workers=2)
    finally:
        ray.shutdown()
    assert written(tmp_path / "out") == whole


def test_dask(plan, whole, tmp_path):
    pytest.importorskip("distributed")
    couplet.sweep(plan, tmp_path / "out", "dask", workers=2)
    assert written(tmp_path / "out") == whole


def test_a_client_of_dask_with_a_worker_that_is_killed(plan, whole, tmp_path):
    distributed = pytest.importorskip("distributed")
    with distributed.Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        pids = client.run(os.getpid)

        def kill():
            os.kill(next(iter(pids.values())), signal.SIGKILL)

        threading.Timer(0.05, kill).start()
        couplet.sweep(plan, tmp_path / "out", client)
    assert written(tmp_path / "out") == whole


def test_a_plan_of_numbers_of_python(tmp_path):
    grid = {"half_opening": [Fraction(1, 3), 2.25, "80deg"], "friction": {"from": "0.1", "to": 1, "steps": 4}}
    made = couplet.sweep({"quantities": ["thrust"], "chunk": 4, "grid": grid}, tmp_path / "dict")
    text = (
        'schema = "couplet.sweep/1"\nquantities = "thrust"\nchunk = 4\n[grid]\n'
        'half_opening = ["1/3", "9/4", "80deg"]\nfriction = { from = 0.1, to = 1, steps = 4 }\n'
    )
    (tmp_path / "plan.toml").write_text(text)
    couplet.sweep(tmp_path / "plan.toml", tmp_path / "text")
    assert written(tmp_path / "dict") == written(tmp_path / "text")
    assert made.rows == 12
    np = pytest.importorskip("numpy")
    grid = {"half_opening": np.array([0.1, 0.5]), "friction": 1}
    record = couplet.sweep({"grid": grid}, tmp_path / "doubles").folder + ".json"
    assert "3602879701896397/36028797018963968" in Path(record).read_text()
    grid = {"half_opening": range(1, 3), "friction": np.int64(1)}
    made = couplet.sweep({"grid": grid, "chunk": np.int64(1)}, tmp_path / "integers")
    assert (made.rows, made.computed) == (2, 2)


def test_the_table_is_read_by_others(tmp_path):
    dataset = pytest.importorskip("pyarrow.dataset")
    parquet = pytest.importorskip("pyarrow.parquet")
    grid = {"half_opening": ["0.5", "80deg"], "friction": ["0.1", "0.3", "inf"]}
    folder = couplet.sweep({"grid": grid, "chunk": 3, "digits": 20}, tmp_path).folder
    rows = dataset.dataset(folder).to_table().to_pylist()
    assert [row["row"] for row in rows] == list(range(6))
    for row in rows:
        state = couplet.state(row["half_opening"], row["friction"], digits=20)
        assert (row["verdict"], row["mode"]) == (state.verdict, state.mode)
        if state.verdict == "stands":
            assert row["thickness_text"] == state.thickness.text
            assert row["thickness"] == state.thickness.double
            lower, upper = state.thickness.lower, state.thickness.upper
            assert row["thickness_side"] == (1 if lower == row["thickness"] else -1) and lower < upper
    part = next(Path(folder).glob("part-*"))
    notes = parquet.read_metadata(part).metadata
    assert notes[b"couplet.schema"] == b"couplet.sweep/1"


def by_polars(folder):
    return pytest.importorskip("polars").read_parquet(folder).to_dicts()


def by_pyarrow(folder):
    return pytest.importorskip("pyarrow.dataset").dataset(folder).to_table().to_pylist()


def by_pandas(folder):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    return pandas.read_parquet(folder).to_dict("records")


def by_duckdb(folder):
    found = pytest.importorskip("duckdb").execute(f"SELECT * FROM read_parquet('{folder}/**/*.parquet')")
    names = [column[0] for column in found.description]
    return [dict(zip(names, row)) for row in found.fetchall()]


def by_spark(folder):
    sql = pytest.importorskip("pyspark.sql")
    if shutil.which("java") is None:
        pytest.skip("no java")
    home = sql.SparkSession.builder.master("local[1]").config("spark.ui.enabled", "false")
    session = home.config("spark.sql.shuffle.partitions", "1").getOrCreate()
    try:
        table = session.read.option("recursiveFileLookup", "true").parquet(folder)
        return [row.asDict() for row in table.collect()]
    finally:
        session.stop()


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """A folder of a few parts, and one of more than a thousand, which are in folders of a thousand."""
    home = tmp_path_factory.mktemp("folders")
    few = {"grid": {"half_opening": [0.5, 1], "friction": [1, 2]}, "chunk": 2}
    many = {"grid": {"half_opening": 1, "friction": {"from": "0.5", "to": 1, "steps": 1001}}, "chunk": 1}
    return [couplet.sweep(few, home / "few").folder, couplet.sweep(many, home / "many").folder]


@pytest.mark.parametrize("read", [by_polars, by_pyarrow, by_pandas, by_duckdb, by_spark])
def test_a_folder_is_a_table_of(read, folders):
    for folder, count in zip(folders, (4, 1001)):
        rows = sorted(read(folder), key=lambda row: row["row"])
        assert [row["row"] for row in rows] == list(range(count))
        names = ["row", "weight", "half_opening", "friction", "half_opening_rad", "friction_double"]
        assert list(rows[0]) == [*names, "verdict", "mode", "thickness", "thickness_side", "reason"]
        assert {row["verdict"] for row in rows} == {"stands"}
        last = rows[-1]
        assert last["thickness"] == couplet.state(last["half_opening"], last["friction"]).thickness.double
    assert sorted(os.listdir(folders[1])) == ["000", "001"]


def test_a_reader_passes_over_row_groups_that_have_nothing(tmp_path):
    dataset = pytest.importorskip("pyarrow.dataset")
    grid = {"half_opening": {"from": "0.4", "to": "1.6", "steps": 13}, "friction": {"from": "0.3", "to": 2, "steps": 100_000}}
    folder = couplet.sweep({"grid": grid, "chunk": 1_300_000}, tmp_path).folder
    field = dataset.field

    def groups(condition=None):
        fragments = dataset.dataset(folder).get_fragments(filter=condition)
        return sum(len(fragment.split_by_row_group(condition)) for fragment in fragments)

    assert groups() == 3
    assert groups(field("half_opening_rad") == 0.6) == 1
    thinner = dataset.dataset(folder).to_table(columns=["thickness"], filter=field("half_opening_rad") < 1.35)
    assert groups(field("thickness") > max(filter(None, thinner["thickness"].to_pylist()))) == 1
    assert groups(field("friction_double") > 2) == 0
    assert groups(field("weight") == "heyman") == 0
    duckdb = pytest.importorskip("duckdb")
    line = f"SELECT stats_min_value FROM parquet_metadata('{folder}/*.parquet') WHERE path_in_schema = 'half_opening_rad'"
    assert sorted(float(row[0]) for row in duckdb.execute(line).fetchall()) == [0.4, 0.9, 1.4]


def test_what_is_no_text_is_refused_with_what_reads_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.parquet").write_bytes(b"PAR1\x15\x04")
    (tmp_path / "in.jsonl").write_text('{"alpha": 1, "mu": 1}\n{"alpha": 1, "mu": "x"}\n')
    made = couplet.sweep({"data": {"files": ["in.jsonl", "in.parquet"]}}, tmp_path / "out")
    assert made.counts == {"stands": 1, "falls": 0, "undecided": 0, "refused": 1}
    (fault,) = made.lost
    assert fault.startswith("in.parquet: it is Parquet; a sweep reads CSV and JSON lines") and "couplet.add_states" in fault


def test_what_is_no_part_is_named(tmp_path):
    plan = {"grid": {"half_opening": [0.5, 1], "friction": 1}, "chunk": 1}
    made = couplet.sweep(plan, tmp_path)
    part = next(Path(made.folder).glob("part-*"))
    (Path(made.folder) / "copy.parquet").write_bytes(part.read_bytes())
    assert made.verify()["faults"] == ["copy.parquet is no part of the sweep"]
    with pytest.raises(couplet.CoupletError, match="copy.parquet is no part of the sweep; take it away"):
        couplet.sweep(plan, tmp_path)


def test_bad_rows_are_rows(tmp_path):
    (tmp_path / "a.csv").write_text("alpha,mu\n1,1\nx,1\n")
    (tmp_path / "plan.toml").write_text('schema = "couplet.sweep/1"\n[data]\nfiles = ["a.csv", "b.csv"]\n')
    made = couplet.sweep(tmp_path / "plan.toml", tmp_path / "out")
    assert made.counts == {"stands": 1, "falls": 0, "undecided": 0, "refused": 1}
    assert made.lost == ["b.csv: no such file or folder"]


def test_what_is_listed_twice_counts_once(tmp_path):
    grid = {"half_opening": ["1", "1.0"], "friction": ["31deg", "tan(31deg)", 1]}
    with pytest.warns(UserWarning, match="listed twice and counts once") as warned:
        swept = couplet.sweep({"grid": grid}, tmp_path)
    assert len(warned) == 2 and sum(swept.counts.values()) == 2


def test_what_makes_no_sense(tmp_path, plan):
    for wrong, words in [
        (lambda: couplet.sweep({"grid": {"half_opening": 4, "friction": 1}}, tmp_path), "not between 0 and pi"),
        (lambda: couplet.sweep({}, tmp_path), "the plan has no arches"),
        (lambda: couplet.sweep(plan, tmp_path, "spark"), "an engine is one of None, processes, ray, dask"),
        (lambda: couplet.sweep(plan, tmp_path, only=(3, 2)), "only is (k, n)"),
        (lambda: couplet.sweep(plan, tmp_path, workers=-1), "threads are a whole number"),
        (lambda: couplet.sweep({"data": {"files": "\ud800"}}, tmp_path), "'\\ud800' is no text"),
        (lambda: couplet.sweep({"grid": {"\ud800": 1}}, tmp_path), "'\\ud800' is no text"),
        (lambda: couplet.sweep("\ud800", tmp_path), "'\\ud800' is no text"),
        (lambda: couplet.sweep(plan, "\ud800"), "is no text"),
    ]:
        with pytest.raises(couplet.CoupletError) as caught:
            wrong()
        assert words in str(caught.value)
    for key in [1, None, ("a",)]:
        with pytest.raises(TypeError, match=f"a key is a str, not {type(key).__name__}: "):
            couplet.sweep({key: 2}, tmp_path)
    with pytest.raises(FileNotFoundError):
        couplet.sweep(tmp_path / "none.toml", tmp_path)
    with pytest.raises(OSError, match="cannot write"):
        couplet.sweep(plan, "/dev/null/results")


def test_an_error_of_a_dictionary_names_its_key(tmp_path):
    alpha, mu = ["80deg"], ["0.1"]
    for plan, lines in [
        ({"grid": {"half_opening": ["80deg", 7], "friction": ["0.1", "-1"]}}, ["grid.half_opening: the half opening 7", "grid.friction: the friction -1"]),
        ({"grid": {"half_opening": alpha, "friction": {"from": 0, "to": 1, "stesp": 3}}}, ["grid.friction: friction has", "grid.friction.stesp: unknown"]),
        ({"quantities": ["thiknes"], "grid": {"half_opening": alpha, "friction": mu}}, ["quantities: quantities \"thiknes\""]),
        ({"grid": {"half_opening": alpha, "friction": mu}, "a b": 1}, ['a b: unknown key "a b"']),
        ({"weight": "heyman"}, ["the plan has no arches"]),
    ]:
        with pytest.raises(couplet.CoupletError) as caught:
            couplet.sweep(plan, tmp_path)
        said = str(caught.value).split("\n")
        assert len(said) == len(lines) and all(line.startswith(words) for line, words in zip(said, lines)), said
    with pytest.warns(UserWarning, match="^grid.friction: "):
        couplet.sweep({"grid": {"half_opening": alpha, "friction": ["0.1", "1/10"]}}, tmp_path)
    (tmp_path / "plan.toml").write_text('schema = "couplet.sweep/1"\nweight = 3\n')
    with pytest.raises(couplet.CoupletError, match="^line 1, column 1: "):
        couplet.sweep(tmp_path / "plan.toml", tmp_path)
