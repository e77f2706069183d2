// Fields and sliders for the arch, and the address that holds it.

const FIELDS = { half_opening: "ask-half-opening", radius: "ask-radius", span: "ask-span", rise: "ask-rise" };
const typedIn = (id) => at(id).value.trim();
/** Whether the arch has a size: its span and rise, or its radius. */
const isMeasured = () => at("by-span").checked || typedIn("ask-radius") !== "";

/** The fields of the shape that is given in this way. */
function shapes(isBySpan) {
  at("by-span").checked = isBySpan;
  at("by-half-opening").checked = !isBySpan;
  document.querySelectorAll(".by-half-opening").forEach((one) => one.hidden = isBySpan);
  document.querySelectorAll(".by-span").forEach((one) => one.hidden = !isBySpan);
  at("circle").hidden = !isMeasured();
}

/** A length that was typed without its unit is in metres. */
const withUnit = (text) => /^[\d./]+$/.test(text) ? `${text}m` : text;

function fields() {
  const friction = typedIn("ask-friction"), thickness = typedIn("ask-thickness"), radius = typedIn("ask-radius"), circle = at("ask-circle").value;
  const shape = at("by-span").checked ? { span: withUnit(typedIn("ask-span")), rise: withUnit(typedIn("ask-rise")) }
    : { half_opening: typedIn("ask-half-opening"), ...(radius && { radius: withUnit(radius) }) };
  const measured_at = isMeasured() && circle !== "intrados" ? { measured_at: circle } : {};
  return { weight, ...shape, ...measured_at, friction, ...(thickness && { thickness }) };
}

/** Half thicknesses from a circle outwards to the centreline. */
const TO_CENTRELINE = { intrados: 1, centreline: 0, extrados: -1 };

/** A thickness as a part of the radius of the centreline. */
function ratio({ radius, span, rise, measured_at = "intrados", thickness }) {
  const length = metres(thickness), [half, up] = [metres(span ?? "") / 2, metres(rise ?? "")];
  const measured = radius === undefined ? (half * half + up * up) / (2 * up) : metres(radius);
  return Number.isNaN(length) ? read(thickness.replace(/r$/, "")) : length / (measured + TO_CENTRELINE[measured_at] * length / 2);
}

/** A friction from its angle in degrees, to three digits; at the end of the slider it is unlimited. */
const coefficient = (degrees) => degrees < 90 ? String(Number(Math.tan(degrees * DEGREE).toPrecision(3))) : "inf";

/** A half opening in degrees, as frictions of places are, to four decimals. */
const rounded = (alpha) => `${(alpha / DEGREE).toFixed(4)}deg`;

/** A friction that is enough where its least angle was found, to six digits. */
const enough = (phi) => phi < Math.PI / 2 ? (Math.ceil(Math.tan(phi) * 1e6) / 1e6).toFixed(6) : "inf";

/** Beside lengths a ratio says that it is one. */
const asRatio = (text) => isMeasured() && text && !/[a-z]$/.test(text) ? `${text}r` : text;

addEventListener("shown", ({ detail: { given, found, isFault } }) => {
  if (isFault) return;
  const { half_opening, span, measured_at, friction, friction_angle, thickness } = given;
  const put = (id, text) => { if (document.activeElement !== at(id)) at(id).value = text; };
  put("ask-radius", given.radius ?? "");
  shapes(span !== undefined);
  // From a place of the map a slider goes on with its half opening and its friction.
  const place = half_opening ?? (span === undefined ? found.halfOpening && rounded(found.halfOpening) : undefined);
  if (place !== undefined) {
    put("ask-half-opening", place);
    put("slide-half-opening", read(place) / DEGREE);
  }
  for (const name of ["span", "rise"]) if (given[name] !== undefined) put(FIELDS[name], given[name]);
  at("ask-circle").value = measured_at ?? "intrados";
  const isThick = !isPlace(given) && thickness !== undefined;
  put("ask-thickness", isThick ? thickness : "");
  put("slide-thickness", isThick ? ratio(given) || 0 : 0);
  const phi = hasFriction(given) ? frictionAngle(given) : found.phi;
  put("ask-friction", friction ?? friction_angle ?? (phi ? enough(phi) : ""));
  if (phi) put("slide-friction", phi / DEGREE);
  at("slide-friction").setAttribute("aria-valuetext", typedIn("ask-friction"));
});

for (const [name, text] of [["half-opening", (x) => `${x}deg`], ["friction", (x) => coefficient(Number(x))], ["thickness", (x) => (Number(x) ? asRatio(x) : "")]]) {
  const slider = at(`slide-${name}`), moved = (isKept) => {
    at(`ask-${name}`).value = text(slider.value);
    show(fields(), isKept);
  };
  slider.addEventListener("input", () => moved(false));
  slider.addEventListener("change", () => moved(true));
}
for (const [id, isBySpan] of [["by-half-opening", false], ["by-span", true]]) {
  at(id).addEventListener("change", () => {
    shapes(isBySpan);
    at("ask-thickness").value = asRatio(typedIn("ask-thickness"));
    show(fields(), true);
  });
}
at("ask-circle").addEventListener("change", () => show(fields(), true));
// The thickness is one of the fields here.
at("ask").addEventListener("submit", (event) => {
  event.preventDefault();
  event.stopImmediatePropagation();
  show(fields(), true);
}, { capture: true });

at("take").addEventListener("click", () => {
  const { weight, half_opening, friction, friction_angle } = last.given, { halfOpening, phi } = last.found;
  const given = friction_angle === undefined ? { friction: friction ?? enough(phi) } : { friction_angle };
  show({ weight, half_opening: half_opening ?? rounded(halfOpening), ...given }, true);
});
