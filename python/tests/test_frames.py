"""Tables of every kind with the states of their rows."""

import decimal
import fractions
import io
import re
import subprocess
import sys

import pytest

import couplet

np = pytest.importorskip("numpy")

KINDS = ("dict", "pandas", "polars", "table", "batch")
ANGLES = ("alpha_deg:deg", "phi:deg")


def made(kind, columns):
    """A table of a kind."""
    if kind == "dict":
        return columns
    if kind in ("table", "batch"):
        pyarrow = pytest.importorskip("pyarrow")
        return pyarrow.table(columns) if kind == "table" else pyarrow.RecordBatch.from_pydict(columns)
    return getattr(pytest.importorskip(kind), "DataFrame")(columns)


def cells(table):
    """The columns of a table as lists, with words for codes, and None for nothing."""
    if isinstance(table, dict):
        words = {"verdict": couplet.VERDICTS, "mode": couplet.MODES}
        lists = {name: list(column) for name, column in table.items()}
        for name, column in lists.items():
            of = next((words[end] for end in words if name.endswith(end)), None)
            lists[name] = [of[code] if code < 255 else None for code in column] if of else [None if cell == -128 else cell for cell in column]
    else:
        to_dict = getattr(table, "to_pydict", None) or (lambda: {name: table[name].to_list() for name in table.columns})
        lists = to_dict()
    return {name: [None if cell is None or cell != cell else cell for cell in map(plain, column)] for name, column in lists.items()}


def plain(cell):
    cell = cell.item() if hasattr(cell, "item") else cell
    return None if str(cell) == "<NA>" else cell


def told(of, name="thickness"):
    """The cells of the answer to one arch."""
    value = of.values.get(name)
    side = None if value is None else (value.upper > value.double) - (value.lower < value.double)
    return of.verdict, of.mode, value and value.double, side


def drawn(count, seed=1):
    random = np.random.default_rng(seed)
    return random.uniform(0.05, 2.9, count), random.uniform(0.01, 2.5, count)


@pytest.mark.parametrize("kind", KINDS)
def test_a_row_is_the_state_of_its_arch(kind):
    alpha, mu = drawn(40)
    alpha[3], mu[4] = 4.0, np.inf
    found = cells(couplet.add_states(made(kind, {"a": alpha, "mu": mu}), half_opening="a", friction="mu"))
    assert list(found) == ["a", "mu", "verdict", "mode", "thickness", "thickness_side", "reason"]
    assert (found["a"], found["mu"]) == (alpha.tolist(), mu.tolist())
    rows = list(zip(*(found[name] for name in ("verdict", "mode", "thickness", "thickness_side"))))
    for row, (a, m) in enumerate(zip(alpha.tolist(), mu.tolist())):
        if row == 3:
            assert rows[row] == ("refused", None, None, None)
            assert found["reason"][row] == "the half opening 4 is not between 0 and pi (180deg); did you mean 4deg?"
        else:
            assert rows[row] == told(couplet.state(a, m, digits=17)) and found["reason"][row] is None
    assert {"stands", "falls", "refused"} == set(found["verdict"])


@pytest.mark.parametrize("kind", KINDS)
def test_angles_with_their_unit_are_exact(kind):
    degrees, angles = [30.0, 80.0, 0.1, 140.0], [31.0, 45.0, 10.0, 20.5]
    table = made(kind, {"alpha_deg": degrees, "phi": angles})
    found = cells(couplet.add_states(table, half_opening=ANGLES[0], friction_angle=ANGLES[1]))
    for row, arch in enumerate(zip(degrees, angles)):
        # 0.1 is the double, which is no tenth.
        alpha, phi = (f"{fractions.Fraction(x).numerator}/{fractions.Fraction(x).denominator}deg" for x in arch)
        state = couplet.state(alpha, friction_angle=phi, digits=17)
        assert tuple(found[name][row] for name in ("verdict", "mode", "thickness", "thickness_side")) == told(state)
    # The nearest double of the radians is another arch.
    rounded = couplet.state(np.deg2rad(80.0).item(), 1, digits=30).thickness.text
    assert rounded != couplet.state("80deg", 1, digits=30).thickness.text


@pytest.mark.parametrize("kind", KINDS)
def test_texts_are_what_they_say(kind):
    alpha = ["1.3", "80deg", " 2pi/3 ", "0x1.8p0", "", "x", "0.1..0.2", None]
    mu = ["0.5", "tan(35deg)", "inf", "1/3", "1", "1", "1", "1"]
    found = cells(couplet.add_states(made(kind, {"alpha": alpha, "mu": mu}), half_opening="alpha", friction="mu"))
    for row, arch in enumerate([("1.3", "0.5"), ("80deg", "tan(35deg)"), ("2pi/3", "inf"), (1.5, "1/3")]):
        assert (found["verdict"][row], found["mode"][row], found["thickness"][row]) == told(couplet.state(*arch, digits=17))[:3]
    assert found["verdict"][4:] == ["refused"] * 4
    assert found["reason"][4] == found["reason"][7] == "the half_opening is empty"
    assert found["reason"][5].startswith("'x' is not a number") and " is a range" in found["reason"][6]


def test_the_command_says_the_same():
    degrees, mu = [80.0, 30.5, 120.0, 200.0], ["0.25", "tan(31deg)", "1/2", "1"]
    table = {"alpha_deg": degrees, "mu": mu}
    found = cells(couplet.add_states(table, half_opening="alpha_deg:deg", friction="mu", quantities=["thickness", "thrust"]))
    text = "alpha_deg,mu\n" + "".join(f"{a},{m}\n" for a, m in zip(degrees, mu))
    columns = "--columns=alpha_deg=half_opening:deg,mu=friction,doubles"
    command = [sys.executable, "-m", "couplet", "states", "--digits=17", "--format=csv", columns, "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    import csv

    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert len(rows) == 4 and found["verdict"] == ["stands", "stands", "falls", "refused"]
    for row, said in enumerate(rows):
        for name in ("thickness", "thrust"):
            assert found[name][row] == (float(said[f"{name}_double"]) if said[f"{name}_double"] else None)
        assert found["mode"][row] == (said["mode"] or None)
    assert rows[3]["error"].replace("200.0deg", "200deg") == found["reason"][3]


def test_hard_arches_are_answered_as_alone():
    sample = couplet.sample(300, hard=True, seed=5)
    columns = {name: [row[name] for row in sample] for name in ("half_opening", "friction", "weight")}
    names = ["thickness", "thrust", "rotational_friction"]
    found = cells(couplet.add_states(columns, weight="weight", quantities=names))
    for row, arch in enumerate(zip(*columns.values())):
        alone = couplet.state(*arch[:2], weight=arch[2], digits=17)
        for name in names:
            told_alone = told(alone, name)
            assert (found["verdict"][row], found["mode"][row], found[name][row], found[f"{name}_side"][row]) == told_alone, arch
    assert len(set(found["mode"])) > 5


def test_numbers_that_are_no_doubles_stay_exact():
    pyarrow = pytest.importorskip("pyarrow")
    tenth = [decimal.Decimal("0.10"), None, decimal.Decimal("1.30")]
    other = couplet.state("0.1", "0.5", digits=30).thickness.text
    assert other != couplet.state(0.1, 0.5, digits=30).thickness.text
    table = pyarrow.table({"alpha": pyarrow.array(tenth, pyarrow.decimal128(5, 2)), "mu": pyarrow.array([1, 1, 1], pyarrow.int8())})
    polars = pytest.importorskip("polars")
    pandas = pytest.importorskip("pandas")
    tables = [table, polars.from_arrow(table), table.to_pandas(), {"alpha": [fractions.Fraction(1, 10), None, "1.3"], "mu": [1, 1, 1]}]
    tables.append(table.to_pandas(types_mapper=pandas.ArrowDtype))
    want = [couplet.state("0.1", 1, digits=17).thickness.double, None, couplet.state("1.3", 1, digits=17).thickness.double]
    for table in tables:
        found = cells(couplet.add_states(table, half_opening="alpha", friction="mu"))
        assert found["thickness"] == want and found["verdict"] == ["stands", "refused", "stands"], type(table)
    # A tenth beside a text, and whole numbers that are no doubles, of which only the text of the reason shows what was read.
    mixed = {"alpha": [0.1, "0.1"], "mu": [1, 1]}
    assert cells(couplet.add_states(mixed, half_opening="alpha", friction="mu"))["thickness"] == [
        couplet.state(tenth, 1, digits=17).thickness.double for tenth in (0.1, "0.1")]
    for large in (np.array([2**53 + 1, 1]), [2**53 + 1, 0.5], [2**70 + 1, 1]):
        found = couplet.add_states({"alpha": large, "mu": [1, 1]}, half_opening="alpha", friction="mu")
        assert f"the half opening {int(large[0])} is not" in found["reason"][0]
    long = {"alpha": np.array([1.25, 1.5], np.longdouble), "mu": np.array([1, 2], np.float16)}
    assert cells(couplet.add_states(long, half_opening="alpha", friction="mu"))["thickness"][0] == couplet.state(1.25, 1, digits=17).thickness.double


def test_a_cell_that_is_no_text_is_a_row():
    pandas = pytest.importorskip("pandas")
    alpha, mu, weight = ["1.3", "\ud800", "1.5", "1.6"], ["1", None, "2\udc00", "1"], ["heyman", "", "heyman", "\ud801"]
    for table in ({"alpha": alpha, "mu": mu, "w": weight}, pandas.DataFrame({"alpha": alpha, "mu": mu, "w": weight}, dtype=object)):
        found = cells(couplet.add_states(table, half_opening="alpha", friction="mu", weight="w"))
        assert found["verdict"] == ["stands", "refused", "refused", "refused"]
        said = " is no text: it has half a surrogate pair, which is no character"
        assert found["reason"] == [None, *(f"'{escape}'{said}" for escape in ("\\ud800", "2\\udc00", "\\ud801"))]


def test_rows_without_a_value_are_refused():
    pandas, polars, pyarrow = (pytest.importorskip(name) for name in ("pandas", "polars", "pyarrow"))
    alpha, mu = [1.3, None, 1.5, 2.0], [1, 2, None, 1]
    table = pyarrow.table({"alpha": alpha, "mu": mu})
    masked = {"alpha": np.ma.masked_array([1.3, 0, 1.5, 2.0], [0, 1, 0, 0]), "mu": np.ma.masked_array([1, 2, 9, 1], [0, 0, 1, 0])}
    frame = pandas.DataFrame({"alpha": pandas.array(alpha, "Float64"), "mu": pandas.array(mu, "Int64")})
    sliced = pyarrow.table({"alpha": [9.0, *alpha, None], "mu": [None, *mu, 9]}).slice(1, 4)
    chunked = pyarrow.concat_tables([table.slice(0, 1), table.slice(1, 2), table.slice(3)])
    batch = sliced.to_batches()[0]
    for table in (table, sliced, chunked, batch, polars.from_arrow(chunked), frame, masked, table.to_pandas(types_mapper=pandas.ArrowDtype)):
        found = cells(couplet.add_states(table, half_opening="alpha", friction="mu"))
        assert found["verdict"] == ["stands", "refused", "refused", "stands"], type(table)
        assert found["reason"] == [None, "the half_opening is empty", "the friction is empty", None]
        assert found["thickness"][0] == couplet.state(1.3, 1, digits=17).thickness.double and found["thickness"][1] is None


@pytest.mark.parametrize("kind", KINDS)
def test_a_thickness_is_assessed(kind):
    columns = {"alpha": [1.3, 1.3, 1.3], "mu": [0.5, 0.5, 0.5], "eta": [0.06, 0.05, 3.0]}
    names = ["geometric_safety", "least_thickness"]
    for given in (columns, {**columns, "eta": ["0.06", "0.05", "3"]}):
        found = cells(couplet.add_states(made(kind, given), half_opening="alpha", friction="mu", thickness="eta", quantities=names))
        assert "mode" not in found and found["verdict"] == ["stands", "falls", "refused"]
        if given is not columns:
            empty = couplet.add_states(made(kind, {**given, "eta": ["", " ", "x"]}), half_opening="alpha", friction="mu", thickness="eta")
            assert cells(empty)["verdict"] == ["refused"] * 3 and cells(empty)["reason"][:2] == ["the thickness is empty"] * 2
        eta = "0.06" if given is not columns else 0.06
        answer = couplet.assess(1.3, 0.5, eta, digits=17)
        assert [found[name][0] for name in names] == [answer.values[name].double for name in names]


@pytest.mark.parametrize("kind", KINDS)
def test_a_column_may_name_the_weight(kind):
    words = ["heyman", "milankovitch", "", "moon", None, "heyman"]
    for alpha in ([2.0] * 6, ["2"] * 6):
        found = cells(couplet.add_states(made(kind, {"a": alpha, "mu": [1.0] * 6, "w": words}), half_opening="a", friction="mu", weight="w"))
        heyman, usual = (couplet.state(2, 1, weight=weight, digits=17).thickness.double for weight in ("heyman", "milankovitch"))
        assert found["thickness"] == [heyman, usual, usual, None, usual, heyman]
        assert found["reason"][3] == "a weight is one of heyman, milankovitch"


@pytest.mark.parametrize("kind", KINDS)
def test_a_table_without_rows_has_the_same_columns(kind):
    table = made(kind, {"a": np.array([1.0, 1.2]), "mu": np.array([1.0, 0.01])})
    few = couplet.add_states(table, half_opening="a", friction="mu", quantities=["thrust", "asymmetric_thickness"], prefix="c_", suffix="_x")
    if kind == "dict":
        none = {name: column[:0] for name, column in table.items()}
    else:
        none = table[:0] if kind in ("pandas", "polars") else table.slice(0, 0)
    none = couplet.add_states(none, half_opening="a", friction="mu", quantities=["thrust", "asymmetric_thickness"], prefix="c_", suffix="_x")
    assert list(cells(none)) == list(cells(few)) == ["a", "mu", *(f"c_{name}_x" for name in (
        "verdict", "mode", "thrust", "thrust_side", "asymmetric_thickness", "asymmetric_thickness_side", "reason"))]
    if kind == "dict":
        assert [column.dtype for column in none.values()] == [column.dtype for column in few.values()]
    elif kind == "pandas":
        assert none.dtypes.equals(few.dtypes)
    else:
        assert none.schema == few.schema


def test_what_makes_no_sense_is_refused_in_one_line():
    table = {"alpha": [1.0], "mu": [1.0], "yes": [True], "alpha:deg": [1.0]}
    arch = {"half_opening": "alpha", "friction": "mu"}
    for changed, why in [
        ({"half_opening": "beta"}, "the table has no column 'beta'; its columns are 'alpha', 'mu', 'yes', 'alpha:deg'"),
        ({"half_opening": "beta:deg"}, "the table has no column 'beta'; "),
        ({"half_opening": "alpha:grad"}, "'grad' is no unit of half_opening: rad, deg, gon"),
        ({"friction": "yes"}, "the column 'yes' is of bool, which is neither numbers nor texts"),
        ({"friction_angle": "yes"}, "friction and friction_angle are both named: choose one"),
        ({"quantities": "thicknes"}, "a quantity is one of "),
        ({"quantities": "geometric_safety"}, "geometric_safety"),
        ({"weight": "moon"}, "the table has no column 'moon'"),
        ({"threads": -1}, "threads are a whole number"),
    ]:
        with pytest.raises(couplet.CoupletError) as raised:
            couplet.add_states(table, **{**arch, **changed})
        assert why in str(raised.value) and "\n" not in str(raised.value)
    with pytest.raises(couplet.CoupletError, match="the table has a column 'verdict'; with prefix='…' or suffix='…'"):
        couplet.add_states({**table, "verdict": [1]}, **arch)
    assert "own_verdict" in couplet.add_states({**table, "verdict": [1]}, **arch, prefix="own_")
    for name, field in [("tilt", "tilt"), ("Stones", "stones"), ("joints", "joints"), ("density", "density")]:
        why = f"'{name}' is not read here: couplet.assess({field}=…) answers it; under another name the column is handed on"
        with pytest.raises(couplet.CoupletError, match=re.escape(why)):
            couplet.add_states({**table, name: [0.1]}, **arch)
    with pytest.warns(UserWarning, match="frictions above 4 are coefficients") as warned:
        couplet.add_states({"alpha": [1.0], "mu": [31.0]}, **arch)
    assert warned[0].filename == __file__
    with pytest.warns(UserWarning, match="the friction 31 is a coefficient"):
        couplet.add_states({"alpha": ["1"], "mu": ["31"]}, **arch)
    of_angle = couplet.add_states({"alpha": [1.0], "mu": [31.0]}, half_opening="alpha", friction="mu:deg")
    assert float(of_angle["thickness"][0]) == couplet.state(1.0, "31deg").thickness.double
    assert "tilts" in couplet.add_states({**table, "tilts": [0.1], 3: [1]}, **arch)
    with pytest.raises(couplet.CoupletError, match="the column 'mu' has 2 rows, where others have 1"):
        couplet.add_states({"alpha": [1.0], "mu": [1.0, 2.0]}, **arch)
    with pytest.raises(couplet.CoupletError, match="2 dimensions"):
        couplet.add_states({"alpha": [[1.0]], "mu": [1.0]}, **arch)
    for nothing in (3, [1.0], np.zeros(3)):
        with pytest.raises(TypeError, match="a table is a frame of pandas or polars, one of Arrow or a dictionary of arrays, not"):
            couplet.add_states(nothing, **arch)
    with pytest.raises(TypeError, match="the friction is the name of a column, a str, not float"):
        couplet.add_states(table, half_opening="alpha", friction=0.5)
    # A name that the table has is that column.
    assert couplet.add_states(table, half_opening="alpha:rad", friction="mu")["verdict"].tolist() == [0]


def test_frames_of_pandas_keep_their_index_and_types():
    pandas = pytest.importorskip("pandas")
    index = pandas.MultiIndex.from_tuples([("b", 1), ("a", 2)], names=["x", "y"])
    frame = pandas.DataFrame({"alpha": [1.3, 1.4], "mu": pandas.array([1, 2], "Int8"), "day": pandas.to_datetime(["2026-01-01"] * 2).tz_localize("UTC")}, index=index)
    found = couplet.add_states(frame, half_opening="alpha", friction="mu")
    assert found.index.equals(index) and found[list(frame)].equals(frame)
    assert found["verdict"].dtype == pandas.CategoricalDtype(list(couplet.VERDICTS)) and found["thickness_side"].dtype == "Int8"
    assert list(frame) == ["alpha", "mu", "day"]
    with pytest.raises(couplet.CoupletError, match="two columns 'mu'"):
        couplet.add_states(pandas.concat([frame, frame[["mu"]]], axis=1), half_opening="alpha", friction="mu")
    words = frame.astype({"mu": str}).astype({"mu": "category"})
    assert couplet.add_states(words, half_opening="alpha", friction="mu")["thickness"].equals(found["thickness"])


def test_tables_of_arrow_keep_their_metadata_and_their_chunks():
    pyarrow = pytest.importorskip("pyarrow")
    schema = pyarrow.schema([pyarrow.field("alpha", pyarrow.float32(), metadata={"unit": "rad"}), ("mu", pyarrow.dictionary(pyarrow.int8(), pyarrow.string()))], {"from": "test"})
    table = pyarrow.table([[1.5, 1.25], pyarrow.array(["1/2", "inf"]).dictionary_encode().cast(schema.field("mu").type)], schema=schema)
    found = couplet.add_states(pyarrow.concat_tables([table, table]), half_opening="alpha", friction="mu")
    assert found.schema.metadata == {b"from": b"test"} and found.schema.field("alpha").equals(schema.field("alpha"), check_metadata=True)
    assert found["alpha"].num_chunks == 2 and found["thickness"].to_pylist()[:2] == found["thickness"].to_pylist()[2:]
    assert found["thickness"].to_pylist()[0] == couplet.state("1.5", "1/2", digits=17).thickness.double


class Stream:
    """Something that speaks Arrow's C interface and nothing else."""

    def __init__(self, table):
        self.table = table

    def __arrow_c_stream__(self, requested_schema=None):
        return self.table.__arrow_c_stream__(requested_schema)


class Array:
    """The same of one array."""

    __init__ = Stream.__init__

    def __arrow_c_array__(self, requested_schema=None):
        return self.table.__arrow_c_array__(requested_schema)


def test_what_speaks_arrow_is_read():
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table({"alpha": [1.3, None], "mu": [1.0, 1.0]})
    want = couplet.add_states(table, half_opening="alpha", friction="mu")
    assert couplet.add_states(Stream(table), half_opening="alpha", friction="mu").equals(want)
    found = couplet.add_states(Array(table.to_batches()[0]), half_opening="alpha", friction="mu")
    assert pyarrow.Table.from_batches([found]).equals(want)
    reader = couplet.add_states(table.to_reader(1), half_opening="alpha", friction="mu")
    assert reader.read_all().equals(want)


def test_many_rows_keep_their_order():
    count = 300_000
    random = np.random.default_rng(3)
    for alpha in (random.choice(np.linspace(0.2, 2.5, 50), count), random.uniform(0.2, 2.5, count)):
        mu = np.where(random.random(count) < 0.01, 0.05, np.inf)
        found = couplet.add_states({"alpha": alpha, "mu": mu}, half_opening="alpha", friction="mu", threads=0)
        some = random.integers(0, count, 2_000)
        want = couplet.states(alpha[some], mu[some])
        for name in ("verdict", "mode", "thickness"):
            assert found[name][some].tobytes() == want[name].tobytes()
        assert couplet.states(alpha, mu)["thickness"][some].tobytes() == want["thickness"].tobytes()


@pytest.mark.parametrize("kind", ["dict", "pandas", "polars"])
def test_nothing_is_imported_that_is_not_needed(kind):
    if kind != "dict":
        pytest.importorskip(kind)
    text = f"""
import sys
sys.modules["pyarrow"] = None
import couplet
assert not {{"numpy", "pandas", "polars"}} & {{*sys.modules}}
columns = {{"alpha": [1.3, 4.0], "mu": ["0.5", None]}}
table = columns if {kind!r} == "dict" else __import__({kind!r}).DataFrame(columns)
found = couplet.add_states(table, half_opening="alpha", friction="mu")
print(*[*found["reason"]], *[*found["thickness"]][:1])
"""
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "the friction is empty" in done.stdout and str(couplet.state(1.3, "0.5", digits=17).thickness.double) in done.stdout
