"""Many arches at once."""

import warnings
from fractions import Fraction

import pytest

import couplet

np = pytest.importorskip("numpy")

STANDS, FALLS, UNDECIDED, REFUSED = range(4)


def drawn(count, seed=1):
    random = np.random.default_rng(seed)
    return random.uniform(0.05, 2.9, count), random.uniform(0.01, 2.5, count)


def same(left, right):
    """Bit for bit, with what is no number; between the fields there may be anything."""
    if left.dtype.names:
        return left.dtype == right.dtype and all(same(left[name], right[name]) for name in left.dtype.names)
    return left.dtype == right.dtype and left.tobytes() == right.tobytes()


def test_a_row_is_the_state_of_its_arch():
    alpha, mu = drawn(60)
    alpha[:3], mu[:3] = [0.5, 2.62, 2.85], np.inf
    names = ["thickness", "thrust", "intrinsic_thrust", "rotation_joint", "sliding_joint"]
    found = couplet.states(alpha, mu, quantities=names)
    for row, a, m in zip(found, alpha.tolist(), mu.tolist()):
        state = couplet.state(a, m, digits=17, frictions=False)
        assert couplet.VERDICTS[row["verdict"]] == state.verdict
        assert (couplet.MODES[row["mode"]] if row["mode"] < 255 else None) == state.mode
        for name in names:
            value = state.values.get(name)
            told = (row[name], row[name + "_lower"], row[name + "_upper"])
            if value is None:
                assert np.isnan(told).all()
            else:
                assert told == (value.double, value.lower, value.upper)
    assert {STANDS, FALLS} == set(found["verdict"].tolist())


def test_an_asymmetric_thickness_is_there_if_it_is_asked():
    for thickness in (None, 0.55):
        found = couplet.states([2.3, 1.5], [1.05, 0.6], thickness, quantities=["asymmetric_thickness"])
        told = couplet.state(2.3, 1.05, digits=17).asymmetric_thickness.double
        assert found["asymmetric_thickness"][0] == told and np.isnan(found["asymmetric_thickness"][1])
    assert "asymmetric_thickness" not in couplet.states([2.3], [1.05]).dtype.names


def test_the_bounds_are_the_neighbours():
    found = couplet.states(*drawn(50))
    stands = found[found["verdict"] == STANDS]
    for row in stands:
        exact = Fraction(row["thickness"].item())
        assert row["thickness_lower"] <= row["thickness"] <= row["thickness_upper"]
        assert np.nextafter(row["thickness_lower"], 9) == row["thickness_upper"]
        assert exact in (Fraction(row["thickness_lower"].item()), Fraction(row["thickness_upper"].item()))


def test_a_grid_shares_its_half_openings_and_no_bit_depends_on_it():
    alpha = np.array([0.02, 0.5, 1.3962634, 2.2, 2.45, 2.6, 2.8])
    frictions = [couplet.state(a, "inf", digits=17) for a in alpha[:4].tolist()]
    thresholds = [
        bound
        for state in frictions
        for value in (state.sliding_friction, state.rotational_friction)
        for bound in (value.lower, value.double, value.upper)
    ]
    mu = np.array([0.0, 1e-9, 0.1, 0.3, 0.38, 0.8, 1.3, 2.0, 50.0, 1e300, np.inf, *thresholds])
    for weight in ["heyman", "milankovitch"]:
        grid = couplet.states(alpha[:, None], mu[None, :], weight=weight)
        assert grid.shape == (len(alpha), len(mu))
        turned = couplet.states(alpha[None, :], mu[:, None], weight=weight)
        assert same(np.ascontiguousarray(turned.T), grid)
        for i, a in enumerate(alpha):
            # So few rows of a half opening are proved one by one.
            for j in range(0, len(mu), 3):
                alone = couplet.states(a, mu[j : j + 3], weight=weight)
                assert same(alone, np.ascontiguousarray(grid[i, j : j + 3])), (weight, a, mu[j : j + 3])


def test_an_arch_with_a_thickness():
    names = ["geometric_safety", "least_thickness", "required_friction", "largest_thrust"]
    found = couplet.states(1.3, [0.5, 0.5, 0.1], [0.1, 0.01, 0.1], quantities=names)
    assert found["verdict"].tolist() == [STANDS, FALLS, FALLS]
    assert set(found["mode"].tolist()) == {255}
    assessed = couplet.assess(1.3, 0.5, 0.1, digits=17)
    for name in names:
        assert found[name][0] == assessed.values[name].double
    assert couplet.states(1.3, 0.5, 0.1).dtype.names[2] == "geometric_safety"


def test_frictions_are_proved_if_they_are_asked_for():
    found = couplet.states([1.3, 1.3, 2.62], [0.5, 0.01, np.inf], quantities=["sliding_friction", "rotational_friction"])
    state = couplet.state(1.3, 0.5, digits=17)
    assert found["sliding_friction"].tolist()[:2] == [state.sliding_friction.double] * 2
    assert found["rotational_friction"][0] == state.rotational_friction.double
    assert found["rotational_friction"][2] == np.inf


def test_a_bad_row_is_a_row():
    found = couplet.states([1.0, 4.0, np.nan, 1.0, 1.0, -1.0, np.inf], [0.5, 0.5, 0.5, -1.0, np.nan, 0.5, 0.5])
    assert found["verdict"].tolist() == [STANDS] + [REFUSED] * 6
    assert np.isnan(found["thickness"][1:]).all()
    assert couplet.states(1.0, 0.5, [0.1, 0.0, 2.5, np.nan])["verdict"].tolist() == [STANDS] + [REFUSED] * 3
    masked = np.ma.masked_array([1.0, 1.0, 2.0], [False, True, False])
    assert couplet.states(masked, 0.5)["verdict"].tolist() == [STANDS, REFUSED, FALLS]
    # In a column too.
    assert couplet.states(1.0, [0.5, -0.5, np.nan, -np.inf, 0.6])["verdict"].tolist() == [STANDS] + [REFUSED] * 3 + [STANDS]


def test_shapes():
    assert couplet.states(1.0, 0.5).shape == ()
    assert couplet.states([], 0.5).shape == (0,)
    assert couplet.states(np.ones((2, 1, 3)), np.full((4, 1), 0.5)).shape == (2, 4, 3)
    found = couplet.states([1, 2], np.float32(0.5))
    assert same(found, couplet.states([1.0, 2.0], 0.5)), "whole numbers and short doubles are what they are"


@pytest.mark.parametrize(
    ("arrays", "sentence"),
    [
        ((["1.0"], 0.5), "no doubles"),
        (([Fraction(1, 3)], 0.5), "no doubles"),
        (([2**53 + 1], 0.5), "no doubles"),
        (([1.0], ["x"]), "the frictions are no doubles"),
        (([True], 0.5), "no doubles"),
        (([1, 2], [1, 2, 3]), "do not fit"),
        (([[1, 2], [3]], 1), "no array"),
    ],
)
def test_arrays_that_make_no_sense(arrays, sentence):
    with pytest.raises(couplet.CoupletError, match=sentence):
        couplet.states(*arrays)


def test_names_that_are_unknown():
    with pytest.raises(couplet.CoupletError, match="did you mean") as caught:
        couplet.states(1, 1, quantities=["thiknes"])
    # What is offered there is, and it is all that there is.
    offered = str(caught.value).split("one of ")[1].split(" (did")[0].split(", ")
    assert len(offered) == 8 and couplet.states(1, 1, quantities=offered).dtype.names[-1].endswith("_upper")
    with pytest.raises(couplet.CoupletError, match="there is no geometric_safety here"):
        couplet.states(1, 1, quantities="geometric_safety")
    with pytest.raises(couplet.CoupletError, match="a weight is one of"):
        couplet.states(1, 1, weight="mine")
    with pytest.raises(couplet.CoupletError, match="threads"):
        couplet.states(1, 1, threads=2000)
    assert couplet.states(1, 1, quantities=["eta", "thickness"]).dtype.names == (
        "verdict", "mode", "thickness", "thickness_lower", "thickness_upper"
    )  # fmt: skip


def test_threads_change_nothing():
    alpha, mu = drawn(700, 2)
    assert same(couplet.states(alpha, mu, threads=1), couplet.states(alpha, mu, threads=np.int64(3)))


def test_columns():
    alpha, mu = drawn(20, 3)
    columns = couplet.states_columns(alpha, mu)
    found = couplet.states(alpha, mu)
    assert list(columns) == ["half_opening", "friction", *found.dtype.names]
    assert all(same(columns[name], np.ascontiguousarray(found[name])) for name in found.dtype.names)
    assert same(columns["half_opening"], alpha) and columns["half_opening"] is not alpha
    assert "given_thickness" in couplet.states_columns(1.0, 0.5, 0.1)


def test_data_frames():
    alpha, mu = drawn(20, 4)
    columns = couplet.states_columns(alpha, mu)
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(columns)
    assert same(couplet.states(frame["half_opening"], frame["friction"]), couplet.states(alpha, mu))
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame(columns)
    assert same(couplet.states(frame["half_opening"], frame["friction"]), couplet.states(alpha, mu))
    arrow = pytest.importorskip("pyarrow")
    table = arrow.table(columns)
    assert same(couplet.states(table["half_opening"], table["friction"]), couplet.states(alpha, mu))


def test_progress():
    told = []
    couplet.states(*drawn(600, 5), progress=lambda done, all_: told.append((done, all_)))
    assert told[-1] == (600, 600) and len(told) > 1
    pytest.importorskip("tqdm")
    couplet.states(1.0, [0.5, 0.6], progress=True)


def test_a_note_is_given_once_a_call():
    # More rows than a piece has, each with a friction of its own.
    mu, note = np.linspace(5, 50, 1500), "frictions above 4 are coefficients"
    frame = {"half_opening": ["1"] * len(mu), "friction": [str(friction) for friction in mu.tolist()]}
    for question, words in [
        (lambda: couplet.states(1.3, mu), note),
        (lambda: couplet.states_columns(1.3, mu, 0.1), note),
        (lambda: couplet.finds("half_opening", friction=mu), "the friction 5 is a coefficient"),
        (lambda: couplet.add_states({"half_opening": np.full(len(mu), 1.3), "friction": mu}), note),
        (lambda: couplet.add_states(frame), "the friction 5.0 is a coefficient"),
    ]:
        with warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter("always")
            question()
        assert [warning.filename for warning in warned] == [__file__] and str(warned[0].message).startswith(words)


def test_what_is_found_over_arrays():
    mu, eta = np.array([0.3, 0.5, np.inf]), np.array([0.001, 0.2])
    found = couplet.finds("half_opening", friction=mu[None, :], thickness=eta[:, None])
    assert found.shape == (2, 3)
    for (i, j), row in np.ndenumerate(found):
        one = couplet.find("half_opening", friction=float(mu[j]), thickness=float(eta[i]), digits=17)
        assert couplet.FOUND[row["verdict"]] == one.verdict == "found"
        assert (row["value"], row["value_lower"], row["value_upper"]) == (one.value.double, one.value.lower, one.value.upper)
    found = couplet.finds("friction", half_opening=[1.3, 1.3, 4.0, np.nan], thickness=[0.1, 0.01, 0.1, 0.1], threads=2)
    assert [couplet.FOUND[code] for code in found["verdict"]] == ["found", "nothing", "refused", "refused"]
    assert np.isnan(found["value"][1:]).all() and np.isnan(found["value_upper"][1:]).all()
    assert couplet.FOUND[couplet.finds("boundary", "rsr/rs", half_opening=1.0)["verdict"].item()] == "nothing"
    line = couplet.finds("boundary", ("[r,r,s]", "[r,s,r]"), friction=np.array([1.6, 1.7]))
    assert line["value"][0] == couplet.find("boundary", "rrs/rsr", friction=1.6, digits=17).value.double
    told = []
    assert couplet.finds("friction", half_opening=np.full(600, 1.3), progress=lambda *done: told.append(done)).shape == (600,)
    assert told == [(512, 600), (600, 600)] and couplet.finds("friction", half_opening=[]).shape == (0,)


@pytest.mark.parametrize(
    ("question", "sentence"),
    [
        (lambda: couplet.finds("friction"), "half_opening is missing"),
        (lambda: couplet.finds("friction", half_opening=[1.0], friction=0.5), "friction does not belong here"),
        (lambda: couplet.finds("boundary", friction=[1.0]), "the pair of modes is missing"),
        (lambda: couplet.finds("thrust", friction=[1.0]), "what is found is one of"),
        (lambda: couplet.finds("friction", half_opening=["1"]), "the half openings are no doubles"),
        (lambda: couplet.finds("friction", half_opening=[1, 2], thickness=[1, 2, 3]), "do not fit each other"),
        (lambda: couplet.finds("friction", half_opening=[1.0], weight="mine"), "a weight is one of"),
        (lambda: couplet.finds("friction", half_opening=[1.0], threads=-1), "threads"),
    ],
)
def test_searches_that_make_no_sense(question, sentence):
    with pytest.raises(couplet.CoupletError, match=sentence):
        question()
