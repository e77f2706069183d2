"""Engines that read, share out and write tables, each by its own recipe (docs/python.md, "Engines")."""

import functools
import os
import sys

import pytest

import couplet

np = pytest.importorskip("numpy")

COLUMNS = {"half_opening": "alpha", "friction": "mu"}
ROWS = 3_000


def drawn():
    random = np.random.default_rng(7)
    table = {"id": np.arange(ROWS), "alpha": random.uniform(0.05, 3.2, ROWS), "mu": random.uniform(0.0, 2.5, ROWS)}
    table["alpha"][5] = 4.0
    return table


def expected():
    found = couplet.add_states(drawn(), **COLUMNS)
    words = [[*names, None] for names in (couplet.VERDICTS, couplet.MODES)]
    verdicts, modes = ([names[code if code < 255 else -1] for code in found[of].tolist()] for names, of in zip(words, ("verdict", "mode")))
    numbers = [None if x != x else x for x in found["thickness"].tolist()]
    sides = [None if side == -128 else side for side in found["thickness_side"].tolist()]
    return list(zip(range(ROWS), verdicts, modes, numbers, sides, found["reason"].tolist()))


def rows(table):
    """The rows of a table of Arrow as ``expected`` has them."""
    names = ("id", "verdict", "mode", "thickness", "thickness_side", "reason")
    columns = [[None if x != x else x for x in table.column(name).to_pylist()] for name in names]
    return sorted(zip(*columns))


def of_pandas(frame):
    pyarrow = pytest.importorskip("pyarrow")
    return rows(pyarrow.Table.from_pandas(frame))


def test_polars_plans():
    polars = pytest.importorskip("polars")
    plan = couplet.add_states(polars.DataFrame(drawn()).lazy(), **COLUMNS)
    want = expected()
    is_new = tuple(map(int, polars.__version__.split(".")[:2])) >= (1, 25)
    for named in ({"engine": "in-memory"}, {"engine": "streaming"}) if is_new else ({},):
        found = plan.collect(**named)
        assert found.select("id", "verdict", "mode", "thickness", "thickness_side", "reason").sort("id").rows() == want
        stands = plan.filter(polars.col("verdict") == "stands").select("id", "thickness").sort("id").collect(**named)
        assert stands.rows() == [(row[0], row[3]) for row in want if row[1] == "stands"]


def test_polars_batches():
    polars = pytest.importorskip("polars")
    states = functools.partial(couplet.add_states, **COLUMNS)
    frame = polars.DataFrame(drawn())
    schema = states(frame.clear()).schema
    found = frame.lazy().map_batches(states, schema=schema, predicate_pushdown=False, projection_pushdown=False).collect()
    assert found.equals(states(frame)) and found.schema == schema


def test_duckdb():
    duckdb = pytest.importorskip("duckdb")
    pyarrow = pytest.importorskip("pyarrow")
    given = pyarrow.table(drawn())
    base = duckdb.connect()
    reader = base.sql("SELECT id, alpha, mu FROM given").to_arrow_reader(500) if hasattr(duckdb.DuckDBPyRelation, "to_arrow_reader") else base.sql(
        "SELECT id, alpha, mu FROM given").fetch_record_batch(500)
    states = couplet.add_states(reader, **COLUMNS)
    assert isinstance(states, pyarrow.RecordBatchReader)
    other = duckdb.connect()
    found = other.sql("SELECT verdict, count(*) AS rows, max(thickness) AS thickest FROM states GROUP BY verdict ORDER BY verdict").fetchall()
    want = expected()
    of = {verdict: [row for row in want if row[1] == verdict] for verdict in sorted({row[1] for row in want})}
    assert found == [(verdict, len(all), max((row[3] for row in all if row[3]), default=None)) for verdict, all in of.items()]


def test_dask_partitions():
    dask = pytest.importorskip("dask.dataframe")
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(drawn())
    states = dask.from_pandas(frame, npartitions=4).map_partitions(couplet.add_states, **COLUMNS)
    assert list(states.columns) == ["id", "alpha", "mu", "verdict", "mode", "thickness", "thickness_side", "reason"]
    with pytest.raises(TypeError, match="a DataFrame is asked to map its batches: data.map_partitions"):
        couplet.add_states(dask.from_pandas(frame, npartitions=4), **COLUMNS)
    meta = couplet.add_states(frame[:0], **COLUMNS)
    for found in (states, dask.from_pandas(frame, npartitions=4).map_partitions(couplet.add_states, **COLUMNS, meta=meta)):
        computed = found.compute(scheduler="threads")
        assert of_pandas(computed) == expected()
        assert computed.dtypes["verdict"] == meta.dtypes["verdict"] == found.dtypes["verdict"]


@pytest.fixture(scope="module")
def ray():
    os.environ.update(RAY_USAGE_STATS_ENABLED="0", RAY_DATA_DISABLE_PROGRESS_BARS="1")
    ray = pytest.importorskip("ray")
    pytest.importorskip("ray.data")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    yield ray
    ray.shutdown()


@pytest.mark.parametrize("kind", ["pyarrow", "pandas", "numpy"])
def test_ray_batches(ray, kind):
    pyarrow = pytest.importorskip("pyarrow")
    data = ray.data.from_arrow(pyarrow.table(drawn())).repartition(5)
    states = data.map_batches(couplet.add_states, fn_kwargs=COLUMNS, batch_format=kind, batch_size=500)
    found = pyarrow.concat_tables([pyarrow.table(ray.get(block)) for block in states.to_arrow_refs()], promote_options="permissive")
    assert found.num_rows == ROWS
    if kind == "numpy":
        order = np.argsort(found["id"].to_numpy())
        want = couplet.add_states(drawn(), **COLUMNS)
        for name in ("verdict", "mode", "thickness", "thickness_side"):
            assert found[name].to_numpy()[order].tobytes() == want[name].tobytes(), name
    else:
        assert rows(found) == expected()


def test_a_worker_of_ray_that_is_killed_loses_nothing(ray, tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    first = tmp_path / "killed"

    def states(batch):
        try:
            first.touch(exist_ok=False)
        except FileExistsError:
            return couplet.add_states(batch, **COLUMNS)
        os._exit(1)

    data = ray.data.from_arrow(pyarrow.table(drawn())).repartition(6)
    found = data.map_batches(states, batch_format="pyarrow").to_arrow_refs()
    assert rows(pyarrow.concat_tables(ray.get(found))) == expected()
    assert first.exists()


@pytest.fixture(scope="module")
def spark():
    sql = pytest.importorskip("pyspark.sql")
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    try:
        session = sql.SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false").getOrCreate()
    except Exception as error:
        pytest.skip(f"Spark does not start: {error}")
    yield session
    session.stop()


def test_spark(spark):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    frame = spark.createDataFrame(pandas.DataFrame(drawn())).repartition(4)
    schema = "id long, alpha double, mu double, verdict string, mode string, thickness double, thickness_side byte, reason string"

    def states(batches):
        for batch in batches:
            yield couplet.add_states(batch, half_opening="alpha", friction="mu")

    for found in (frame.mapInArrow(states, schema), frame.mapInPandas(states, schema)):
        names = ("id", "verdict", "mode", "thickness", "thickness_side", "reason")
        told = [tuple(None if row[name] != row[name] else row[name] for name in names) for row in found.collect()]
        assert sorted(told) == expected()
