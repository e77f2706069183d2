"""What mypy says of calls: an error that is expected and does not come is one too. It is read, and not run."""

from __future__ import annotations

from typing_extensions import assert_type

import couplet

assert_type(couplet.state("80deg", "0.6"), couplet.State)
assert_type(couplet.state(friction="0.6", span="10m", rise="3m", stones=11), couplet.State)
assert_type(couplet.assess("80deg", friction_angle="31deg", thickness=0.1, digits=9), couplet.Assessment)
assert_type(couplet.tilt("80deg", "0.6", "0.15", "5deg", stones=11), couplet.Tilted)
assert_type(couplet.voussoirs("80deg", "0.6", 11), couplet.Voussoirs)
assert_type(couplet.voussoirs("80deg", "0.6", range(2, 9)), list[couplet.Voussoirs])
assert_type(couplet.find("boundary", ("rrs", "rsr"), friction=1.6), couplet.Found)
assert_type(couplet.draw(("78deg", "80deg"), "0.6", thickness=0.1, width="84mm"), couplet.Picture)
assert_type(couplet.state("80deg", "0.6").thickness, "couplet.Certified | None")
assert_type(couplet.constants("T")["thickness"].double, float)
survey = couplet.assess(("79deg", "81deg"), "0.6", (0.1, 0.12))
assert_type(survey, "couplet.Assessment | couplet.Survey")
for landmark in couplet.LANDMARKS:
    couplet.constants(landmark, "heyman")

couplet.state("80deg")  # type: ignore[call-overload]
couplet.state("80deg", "0.6", wieght="heyman")  # type: ignore[call-overload]
couplet.state("80deg", "0.6", thickness=0.1)  # type: ignore[call-overload]
couplet.assess("80deg", "0.6")  # type: ignore[call-overload]
couplet.find("halfopening", friction=1)  # type: ignore[call-overload]
couplet.find("half_opening")  # type: ignore[call-overload]
couplet.find("boundary", friction=1)  # type: ignore[call-overload]
couplet.constants("Q")  # type: ignore[arg-type]
couplet.draw("80deg", "0.6", colour="red")  # type: ignore[call-arg]
couplet.map(plane="friction")  # type: ignore[arg-type]
couplet.certify(half_opening=1)  # type: ignore[call-overload]
couplet.state("80deg", "0.6").verdict == "stand"  # type: ignore[comparison-overlap]
