// Fields and sliders for the arch, and the address that holds it.

const FIELDS = { half_opening: "ask-half-opening", span: "ask-span", rise: "ask-rise", thickness: "ask-thickness" };
const isMeasured = () => at("by-span").checked;

/** The fields of the shape that is given in this way. */
function shapes(isBySpan) {
  at("by-span").checked = isBySpan;
  at("by-half-opening").checked = !isBySpan;
  document.querySelectorAll(".by-half-opening").forEach((one) => one.hidden = isBySpan);
  document.querySelectorAll(".by-span").forEach((one) => one.hidden = !isBySpan);
}

/** A length that was typed without its unit is in metres. */
const withUnit = (text) => /^[\d./]+$/.test(text) ? `${text}m` : text;

function fields() {
  const text = (id) => at(id).value.trim();
  const friction = text("ask-friction"), thickness = text("ask-thickness");
  const measured_at = at("ask-circle").value;
  const measures = { span: withUnit(text("ask-span")), rise: withUnit(text("ask-rise")), ...(measured_at !== "intrados" && { measured_at }) };
  const shape = isMeasured() ? measures : { half_opening: text("ask-half-opening") };
  return { weight: map().id, ...shape, friction, ...(thickness && { thickness }) };
}

/** Half thicknesses from a circle outwards to the centreline. */
const TO_CENTRELINE = { intrados: 1, centreline: 0, extrados: -1 };

/** A thickness as a part of the radius of the centreline. */
function ratio({ span, rise, measured_at = "intrados", thickness }) {
  const length = metres(thickness), [half, up] = [metres(span ?? "") / 2, metres(rise ?? "")];
  const radius = (half * half + up * up) / (2 * up) + TO_CENTRELINE[measured_at] * length / 2;
  return Number.isNaN(length) ? read(thickness.replace(/r$/, "")) : length / radius;
}

/** Beside lengths a ratio says that it is one. */
const asRatio = (text) => isMeasured() && text && !/[a-z]$/.test(text) ? `${text}r` : text;

addEventListener("shown", ({ detail: { given, found } }) => {
  const { half_opening, span, measured_at, friction, friction_angle, thickness } = given;
  const put = (id, text) => { if (document.activeElement !== at(id)) at(id).value = text; };
  shapes(span !== undefined);
  // From a place of the map a slider goes on with its half opening.
  const place = half_opening ?? (span === undefined ? found.halfOpening?.toFixed(6) : undefined);
  if (place !== undefined) {
    put("ask-half-opening", place);
    put("slide-half-opening", read(place) / DEGREE);
  }
  for (const name of ["span", "rise"]) if (given[name] !== undefined) put(FIELDS[name], given[name]);
  at("ask-circle").value = measured_at ?? "intrados";
  const isThick = isShape(given) && thickness !== undefined;
  put("ask-thickness", isThick ? thickness : "");
  put("slide-thickness", isThick ? ratio(given) : 0);
  put("ask-friction", friction ?? friction_angle ?? "");
  put("slide-friction", Math.min(Math.tan(frictionAngle(given)), 2));
});

for (const [name, text] of [["half-opening", (x) => `${x}deg`], ["friction", (x) => x], ["thickness", (x) => (Number(x) ? asRatio(x) : "")]]) {
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
    at("ask-thickness").value = asRatio(at("ask-thickness").value.trim());
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
  const { weight, friction, friction_angle } = last.given;
  show({ weight, half_opening: last.found.halfOpening.toFixed(6), ...(friction === undefined ? { friction_angle } : { friction }) }, true);
});
