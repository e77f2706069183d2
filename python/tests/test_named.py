"""Keywords that several functions have, each list written once."""

import inspect

import pytest

import couplet
from couplet import _core, _named

ARCH = {*_core.fields(), "weight"}
OF_AN_ARCH = [couplet.state, couplet.assess, couplet.tilt, couplet.voussoirs, couplet.find, couplet.certify, couplet.draw]
PAPER = {"width", "font_size", "font", "no_caption", "no_title", "threads"}


@pytest.mark.parametrize("function", OF_AN_ARCH)
def test_a_function_of_an_arch_has_every_name_of_one(function):
    parameters = inspect.signature(function).parameters
    assert ARCH <= {*parameters}, ARCH - {*parameters}
    assert all(parameter.kind is not parameter.VAR_KEYWORD and parameter.annotation != parameter.empty for parameter in parameters.values())
    assert all(parameter.default is None for name, parameter in parameters.items() if name in ARCH - {"weight", "tilt"})
    assert parameters["weight"].default == "milankovitch" and function.__doc__ and function.__module__.startswith("couplet.")
    with pytest.raises(TypeError, match=rf"{function.__name__}\(\) got an unexpected keyword argument 'wieght'"):
        function(wieght="heyman")


@pytest.mark.parametrize("function", [couplet.draw, couplet.figure, couplet.map])
def test_a_picture_has_every_option_of_paper(function):
    assert PAPER <= {*inspect.signature(function).parameters}


def test_what_is_given_by_its_place_stands_first():
    @_named.named(_named.Beside, _named.Arches)
    def asked(what, thickness=None, *, deep=False, **arch):
        """Some words."""
        return what, thickness, deep, arch

    names = list(inspect.signature(asked).parameters)
    assert names[:3] == ["what", "thickness", "friction_angle"] and names[-1] == "deep" and asked.__doc__ == "Some words."
    assert asked.__qualname__.endswith("asked") and inspect.signature(asked).parameters["digits"].default == 30
    what, thickness, deep, arch = asked(1, 2, span="3m", deep=True)
    assert (what, thickness, deep, arch["span"], arch["rise"], arch["digits"]) == (1, 2, True, "3m", None, 30)
    with pytest.raises(TypeError, match="positional"):
        asked(1, 2, 3)
    with pytest.raises(TypeError, match="missing"):
        asked()
