// What the page shows of the arch under the cross: { weight, thickness or half_opening or span and rise, friction or
// friction_angle }, as texts that couplet reads too. The part of the address behind # holds the same.

const DEGREE = Math.PI / 180;
const WORDS = {
  "[r,r,r]": "hinges open at the crown, at the haunches and at the shoulders",
  "[s,r,r]": "the shoulders slide, and hinges open at the haunches and at the crown",
  "[r,r,s]": "hinges open at shoulders and haunches, and a joint above them slides",
  "[r,s,r]": "hinges open at shoulders and haunches, and a joint between them slides",
  "[r,s]": "half arches overturn about their shoulders, and an inner joint slides",
  "[r]": "half arches overturn about their shoulders",
  "[s,s]": "shoulders and inner joints slide, and more thickness does not help",
};
const at = (id) => document.getElementById(id);
const maps = [...document.querySelectorAll("[data-frames]")];
const map = () => maps.find((one) => !one.hidden);
const drawing = () => map().querySelector("svg");
const boxes = new Map(maps.map((one) => [one.id, one.querySelector("svg").viewBox.baseVal]).map(([id, box]) => [id, [box.x, box.y, box.width, box.height]]));
const whole = () => boxes.get(map().id);
let view = whole();

/** A number as couplet reads it: 0.1, 3/25, 80deg, pi/2, 2atan(3/5), inf. */
function read(text) {
  const [, tangent] = /^2atan\(([^()]*)\)$/.exec(text) ?? [];
  if (tangent !== undefined) return 2 * Math.atan(read(tangent));
  if (/^(inf|∞)$/i.test(text)) return Infinity;
  const [, number, unit, below] = /^(\d*\.?\d+(?:e-?\d+)?)?(deg|°|rad|pi)?(?:\/(\d+))?$/i.exec(text.replace(/\s/g, "")) ?? [];
  const factor = { deg: DEGREE, "°": DEGREE, pi: Math.PI }[unit?.toLowerCase()] ?? 1;
  return Number(number ?? (unit === "pi" ? 1 : NaN)) * factor / Number(below ?? 1);
}

/** A length in metres, as couplet reads it: 10m, 60cm, 33ft. */
function metres(text) {
  const [, number, unit] = /^(.*?)\s*(cm|mm|m|ft|in)$/.exec(text.trim()) ?? [];
  return number === undefined ? NaN : read(number) * { m: 1, cm: 0.01, mm: 0.001, ft: 0.3048, in: 0.0254 }[unit];
}

/** Whether the shape of an arch is given, and not its place on the map. */
const isShape = ({ half_opening, span }) => half_opening !== undefined || span !== undefined;

/** The half opening; with span and rise twice the arctangent of the rise by half the span. */
const opening = ({ half_opening, span, rise }) =>
  span === undefined ? read(half_opening) : 2 * Math.atan(2 * metres(rise ?? "") / metres(span));

/** As many of six digits as are sure, with a relative error; of thin arches doubles lose some more. */
function sure(x, error, digits = 6) {
  if (!(error < 0.5)) return "beyond doubles";
  const [low, high] = [1 - error, 1 + error].map((factor) => (x * factor).toPrecision(digits));
  return low === high || digits === 1 ? low : sure(x, error, digits - 1);
}

/** The angle of friction: given, also as the friction, or of its coefficient. */
const frictionAngle = ({ friction, friction_angle = "" }) =>
  friction === undefined || /(deg|°|rad)$/i.test(friction) ? read(friction ?? friction_angle) : Math.atan(read(friction));

/** The numbers of an arch that was given in texts; a text if there is none. */
function solve(given) {
  const delta = given.weight === "heyman" ? 0 : 1;
  const phi = frictionAngle(given);
  if (!(phi > 0 && phi <= Math.PI / 2)) return "a friction is positive (0.6, inf), a friction angle up to 90deg";
  let eta = read(given.thickness ?? "");
  if (isShape(given)) {
    const alpha = opening(given);
    if (given.span !== undefined && !(alpha > 0)) return "a span and a rise are lengths (10m, 60cm, 33ft)";
    if (!(alpha > 0 && alpha < Math.PI)) return "a half opening is between 0 and 180deg";
    eta = least(delta, alpha, phi);
    if (eta === null) return "falls: no thickness is enough";
  }
  if (!(eta > 0 && eta <= 2)) return "a thickness is positive, and 2 at most";
  return { eta, phi, fac: 1 + delta * eta * eta / 12, ...widest(delta, eta, phi) };
}

function show(given, isKept) {
  if (given.weight !== map().id) choose(given.weight);
  const found = solve(given);
  const isArch = typeof found !== "string";
  at("summary").textContent = isArch ? `${found.mode}: ${WORDS[found.mode]}` : found;
  at("found").hidden = !isArch;
  document.querySelectorAll(".cross").forEach((cross) => cross.remove());
  if (isArch) {
    const { mode, eta, phi, halfOpening, rotation, sliding, thrust, isOnLine } = found;
    const number = (x) => sure(x, 1e-10 + 1e-14 / halfOpening ** 2);
    const angle = (rad) => `${number(rad)} rad, ${number(rad / DEGREE)}°`;
    const values = {
      mode: isOnLine ? `${mode}, on a line of the map` : mode,
      half_opening: angle(halfOpening),
      thickness: number(eta),
      friction: phi < Math.PI / 2 ? number(Math.tan(phi)) : "∞",
      friction_angle: angle(phi),
      thrust: number(thrust),
      rotation_joint: /r,r|,r\]/.test(mode) ? angle(rotation) : "none",
      sliding_joint: /,s/.test(mode) ? angle(sliding) : "none",
    };
    for (const [id, value] of Object.entries(values)) at(id).textContent = value;
    draw(found);
    cross(found);
  }
  const question = !isShape(given) ? "find half-opening" : given.thickness === undefined ? "state" : "assess";
  const options = Object.entries(given).map(([key, value]) => `--${key.replace("_", "-")} ${value}`);
  at("command").replaceChildren(...[`couplet ${question}`, ...options].flatMap((words) => {
    const span = document.createElement("span");
    span.textContent = words;
    return [span, " "];
  }));
  if (isKept) history.replaceState(null, "", `#${new URLSearchParams(given)}`);
  shown = found;
  // What else there is on a page may follow.
  dispatchEvent(new CustomEvent("shown", { detail: { given, found, isKept } }));
}
let shown;
let draw = (found) => { at("arch").innerHTML = arch(found); };

/** The arch at its least thickness, with its hinges, its joints that slide, and its line of thrust. */
function arch({ mode, eta, fac, halfOpening: alpha, thrust, rotation, sliding, crownMoment }) {
  const [inner, outer] = [1 - eta / 2, 1 + eta / 2];
  const point = (r, beta) => `${(r * Math.sin(beta)).toFixed(4)} ${(-r * Math.cos(beta)).toFixed(4)}`;
  const line = (r) => Array.from({ length: 121 }, (_, k) => (k / 60 - 1) * alpha).map((beta) => point(r(beta), beta));
  const ring = [...line(() => outer), ...line(() => inner).reverse()];
  const normal = (beta) => thrust * Math.cos(beta) + beta * Math.sin(beta);
  const moment = crownMoment ?? inner * normal(rotation) - fac * (1 - Math.cos(rotation));
  // Without thrust the line comes to half of the centroids' radius at the crown.
  const forces = line((beta) => normal(beta) > 0 ? (moment + fac * (1 - Math.cos(beta))) / normal(beta) : fac / 2);
  const sides = (beta) => beta > 0 ? [-beta, beta] : [0];
  const hinge = (r, beta) => sides(beta).map((b) => `<path class="hinge" d="M${point(r, b)}h0"/>`).join("");
  const slip = (beta) => sides(beta).map((b) => `<path class="slip" d="M${point(inner, b)}L${point(outer, b)}"/>`).join("");
  const marks = [
    mode[1] === "s" ? slip(alpha) : mode ? hinge(outer, alpha) : "",
    /,s/.test(mode) ? slip(sliding) : "",
    /r,r|,r\]/.test(mode) ? hinge(inner, rotation) : "",
    /r,r\]/.test(mode) && mode !== "[r,r,s]" ? hinge(outer, 0) : "",
  ];
  const reach = outer * Math.sin(Math.min(alpha, Math.PI / 2)), low = Math.max(-inner * Math.cos(alpha), -outer * Math.cos(alpha));
  const margin = 0.08 * outer, box = [-reach - margin, -outer - margin, 2 * (reach + margin), low + outer + 2 * margin];
  const thrustLine = mode === "[s,s]" ? "" : `<path class="thrust" d="M${forces.join("L")}"/>`;
  return `<svg class="plain" viewBox="${box.map((x) => x.toFixed(4)).join(" ")}" aria-hidden="true"><path class="ring" d="M${ring.join("L")}Z"/>`
    + `${thrustLine}${marks.join("")}</svg>`;
}

// The map: frames are [x, y, width, height, phi from, to, eta from, to], the insets before the map itself.

const frames = () => JSON.parse(map().dataset.frames);

/** A cross in each frame that shows the point. */
function cross({ phi, eta }) {
  for (const [x, y, width, height, p0, p1, e0, e1] of frames()) {
    const [across, up] = [(phi / DEGREE - p0) / (p1 - p0), (eta - e0) / (e1 - e0)];
    if (across < 0 || across > 1 || up < 0 || up > 1) continue;
    const size = 9 * view[2] / whole()[2], place = [x + across * width, y + (1 - up) * height];
    const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
    path.setAttribute("class", "cross");
    path.setAttribute("d", `M${place[0] - size} ${place[1]}h${2 * size}m${-size} ${-size}v${2 * size}`);
    drawing().append(path);
  }
}

/** A number in steps of what a pixel of the page shows of a range, strictly above its beginning. */
function stepped(value, [from, to], size) {
  const pixel = (to - from) / size * view[2] / drawing().clientWidth;
  const decimals = Math.max(0, Math.ceil(-Math.log10(pixel)));
  return Math.min(Math.max(value, 10 ** -decimals), to).toFixed(decimals);
}

/** The arch at a place of a frame: friction angle in degrees, and thickness. */
function placed(degrees, eta, [, , width, height, p0, p1, e0, e1], isKept) {
  const angle = stepped(degrees, [p0, p1], width);
  const friction = Number(angle) === 90 ? { friction: "inf" } : { friction_angle: `${angle}deg` };
  show({ weight: map().id, thickness: stepped(eta, [e0, e1], height), ...friction }, isKept);
}

/** From the page to the drawing. */
function onDrawing(event) {
  return new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing().getScreenCTM().inverse());
}

function point(event, isKept) {
  const { x, y } = onDrawing(event);
  const frame = frames().find(([x0, y0, width, height]) => x >= x0 && x <= x0 + width && y >= y0 && y <= y0 + height);
  if (!frame) return;
  const [x0, y0, width, height, p0, p1, e0, e1] = frame;
  placed(p0 + (x - x0) / width * (p1 - p0), e1 - (y - y0) / height * (e1 - e0), frame, isKept);
}

/** Shows another part of the drawing, as large as this one times a factor, with a place of it kept or moved. */
function look(factor, { x, y }, [dx, dy] = [0, 0]) {
  const [, , width, height] = whole();
  const share = Math.min(1, Math.max(1 / 400, view[2] / width * factor)), ratio = share * width / view[2];
  const low = (start, place, move, size) => Math.min(Math.max(0, place - (place - start) * ratio - move), size * (1 - share));
  view = [low(view[0], x, dx, width), low(view[1], y, dy, height), width * share, height * share];
  drawing().setAttribute("viewBox", view.join(" "));
}

const middle = () => ({ x: view[0] + view[2] / 2, y: view[1] + view[3] / 2 });
const fingers = new Map();

/** One pointer reads the map, and drags it with a button down; two fingers drag and stretch it. */
function move(event) {
  const before = fingers.get(event.pointerId);
  if (before) fingers.set(event.pointerId, event);
  if (before && (event.pointerType === "mouse" || fingers.size === 2)) {
    const [from, to] = [onDrawing(before), onDrawing(event)], shift = 1 / fingers.size;
    const other = [...fingers.values()].find((finger) => finger.pointerId !== event.pointerId);
    const away = (finger) => Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY);
    look(other ? away(before) / Math.max(away(event), 1) : 1, to, [(to.x - from.x) * shift, (to.y - from.y) * shift]);
  } else {
    point(event, false);
  }
}

const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function key(event) {
  const frame = frames().at(-1), steps = KEYS[event.key];
  if (steps && typeof shown !== "string") {
    const [, , width, height, p0, p1, e0, e1] = frame, far = (event.shiftKey ? 20 : 4) * view[2] / drawing().clientWidth;
    placed(shown.phi / DEGREE + steps[0] * far * (p1 - p0) / width, shown.eta + steps[1] * far * (e1 - e0) / height, frame, true);
  } else if (event.key === "+") {
    look(0.7, middle());
  } else if (event.key === "-") {
    look(1 / 0.7, middle());
  } else if (event.key === "0") {
    look(Infinity, middle());
  } else {
    return;
  }
  event.preventDefault();
}

function choose(weight) {
  maps.forEach((one) => one.hidden = one.id !== weight);
  at(`choose-${weight}`).checked = true;
  look(1, middle());
}

/** What the address asks for; the paper's letters are keys too. */
function asked() {
  const given = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  for (const [letter, name] of [["alpha", "half_opening"], ["mu", "friction"], ["phi", "friction_angle"], ["eta", "thickness"]]) {
    if (given[letter] !== undefined) given[name] = given[letter];
    delete given[letter];
  }
  const weight = (maps.find((one) => one.id === given.weight) ?? maps.at(-1)).id;
  const usual = Object.keys(given).some((name) => name !== "weight") ? {} : { half_opening: "80deg", friction: "0.6" };
  return { ...usual, ...given, weight };
}

for (const one of maps) {
  const title = one.querySelector("title");
  one.querySelector("svg").setAttribute("aria-label", title.textContent);
  // A browser would show it beside the pointer.
  title.remove();
  one.addEventListener("pointermove", move);
  one.addEventListener("pointerdown", (event) => { fingers.set(event.pointerId, event); point(event, true); });
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) {
    one.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  one.addEventListener("wheel", (event) => { look(2 ** (event.deltaY / 300), onDrawing(event)); event.preventDefault(); }, { passive: false });
  one.addEventListener("keydown", key);
  at(`choose-${one.id}`).addEventListener("change", () => show({ ...asked(), weight: one.id }, true));
}
at("closer").addEventListener("click", () => look(0.7, middle()));
at("farther").addEventListener("click", () => look(1 / 0.7, middle()));
at("all").addEventListener("click", () => look(Infinity, middle()));
at("ask").addEventListener("submit", (event) => {
  event.preventDefault();
  const [half_opening, friction] = ["ask-half-opening", "ask-friction"].map((id) => at(id).value);
  const isAngle = /deg|°/i.test(friction);
  show({ weight: map().id, half_opening, ...(isAngle ? { friction_angle: friction } : { friction }) }, true);
});
addEventListener("hashchange", () => show(asked()));
show(asked());
