// What the page shows: the planes of one weight, and the arch under the cross, which is one arch in all of them.

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
const planes = [...document.querySelectorAll("[data-plane]")].map((figure) => new Plane(figure));
const WEIGHTS = [...new Set(planes.map((one) => one.weight))], PLANES = [...new Set(planes.map((one) => one.plane))];
let weight = planes.find(({ figure }) => !figure.hidden).weight, large = PLANES[0];
const shownPlanes = () => planes.filter((one) => one.weight === weight);
const largePlane = () => shownPlanes().find((one) => one.plane === large);

/** As many of six digits as are sure, with a relative error; of thin arches doubles lose some more. */
function sure(x, error, digits = 6) {
  if (!(error < 0.5)) return "beyond doubles";
  const [low, high] = [1 - error, 1 + error].map((factor) => (x * factor).toPrecision(digits));
  return low === high || digits === 1 ? low : sure(x, error, digits - 1);
}

/** Shows an arch, or in words why there is none. */
function show(given, isKept) {
  given = { weight, ...given };
  if (given.weight !== weight) choose(given.weight);
  tellArch(given, solve(given), isKept);
  if (isKept) keep(given);
}

/** What is shown, as texts and as numbers. */
let shown = {};

function tellArch(given, found, isKept, isFault) {
  const isArch = typeof found !== "string";
  at("summary").textContent = isArch ? `${found.mode}: ${WORDS[found.mode]}` : found;
  at("found").hidden = !isArch;
  shownPlanes().forEach((one) => one.cross(isArch ? found : null));
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
  }
  // What is no arch has no command.
  const isAsked = isArch || found.startsWith("falls");
  at("with-command").hidden = !isAsked;
  if (isAsked) at("command").replaceChildren(...apart(command(given)));
  shown = { given, found };
  // What else there is on a page may follow.
  dispatchEvent(new CustomEvent("shown", { detail: { given, found, isKept, isFault } }));
}
let draw = (found) => { at("arch").innerHTML = arch(found); };

/** Words of a command, none of which is broken at the end of a line. */
function apart(words) {
  return words.flatMap((word) => {
    const span = document.createElement("span");
    span.textContent = word;
    return [span, " "];
  });
}

/** The address holds the arch that is shown, and the part of the large plane. */
function keep(given = shown.given) {
  const text = new URLSearchParams({ ...given, ...viewed() }).toString();
  history.replaceState(null, "", `#${text.replaceAll("%2F", "/")}`);
}

/** The part of the large plane that is shown, by the keys of an address, which are options of the command. */
function viewed() {
  const plane = largePlane(), axes = plane.labels.map((label) => `${label.split(" ")[0].replace("half", "half_opening")}_range`);
  const ranges = plane.isWhole() ? [] : plane.view.map((range, k) => [axes[k], range.map((end) => Number(end.toPrecision(6))).join("..")]);
  return { ...(large !== PLANES[0] && { plane: large }), ...Object.fromEntries(ranges) };
}

/** The part of a plane that the address names; a text if it is none. */
function partOf(plane, { half_opening_range, friction_range, thickness_range }) {
  const asked = { half: half_opening_range, friction: friction_range, thickness: thickness_range }, view = [];
  plane.labels.forEach((label, k) => {
    const name = label.split(" ")[0], [first, last] = plane.ranges[k], text = asked[name];
    delete asked[name];
    const [, from, to] = /^(\d*\.?\d+)\.\.(\d*\.?\d+)$/.exec(text ?? `${first}..${last}`) ?? [];
    view.push(first <= Number(from) && Number(from) < Number(to) && Number(to) <= last ? [Number(from), Number(to)]
      : `a part of the plane is two numbers, the smaller first, within ${first}..${last}, and not '${text}'`);
  });
  const other = Object.keys(asked).find((name) => asked[name] !== undefined);
  if (other) return `the plane ${plane.plane} has no axis of ${other.replace("half", "half opening")}`;
  const wrong = view.find((range) => typeof range === "string"), least = plane.least();
  if (wrong) return wrong;
  const narrow = view.findIndex(([from, to], k) => to - from < 0.999 * least[k]);
  return narrow < 0 ? view : `a range of the ${plane.labels[narrow]} is ${least[narrow].toPrecision(2)} wide at least: closer its lines are not proved`;
}

/** Shows what the address names, or what is wrong with it. */
function open() {
  const { arch, view, fault } = asked(WEIGHTS, PLANES);
  if (fault) return tellArch(arch, fault, false, true);
  if ((arch.weight ?? weight) !== weight) choose(arch.weight);
  enlarge(view.plane ?? PLANES[0]);
  const part = partOf(largePlane(), view);
  if (typeof part === "string") return tellArch(arch, part, false, true);
  largePlane().show(part);
  told();
  show(arch);
}

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

/** The weight whose planes are shown. */
function choose(name) {
  const view = largePlane().view;
  weight = name;
  planes.forEach((one) => one.figure.hidden = one.weight !== name);
  at(`choose-${name}`).checked = true;
  largePlane().show(view);
  shownPlanes().forEach((one) => one.draw());
}

/** The plane that is shown large. */
function enlarge(plane) {
  large = plane;
  planes.forEach((one) => one.figure.classList.toggle("large", one.plane === plane));
  at("levels-label").textContent = largePlane().levels_label;
  shownPlanes().forEach((one) => one.draw());
}

/** The command that draws what the large plane shows. */
function told() {
  const options = Object.entries({ weight, plane: large, ...viewed() }).map(([key, value]) => `--${key.replaceAll("_", "-")} ${value}`);
  at("map-command").replaceChildren(...apart(["couplet map", ...options, ...(Plane.hasLevels ? [] : ["--bare"]), "-o map.svg"]));
}

/** After another part is shown. */
let later;
function moved() {
  told();
  clearTimeout(later);
  later = setTimeout(keep, 200);
}

/** Hands out a picture as a file. */
function save(svg, name) {
  const copy = svg.cloneNode(true), { width, height } = svg.viewBox.baseVal;
  Object.entries({ xmlns: SVG, width, height, "font-family": "DejaVu Sans, Verdana, sans-serif" }).forEach((pair) => copy.setAttribute(...pair));
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const fingers = new Map();

function point(plane, event, isKept) {
  const place = plane.on(event), frame = plane.frames.find((frame) => frame.holds(place));
  if (frame) show(plane.given(frame, frame.of(place)), isKept);
}

/** One pointer reads a plane, and drags it with a button down; two fingers drag and stretch it. */
function move(plane, event) {
  const before = fingers.get(event.pointerId);
  if (before) fingers.set(event.pointerId, event);
  if (before && (event.pointerType === "mouse" || fingers.size === 2)) {
    const [from, to] = [plane.on(before), plane.on(event)], part = 1 / fingers.size;
    const other = [...fingers.values()].find((finger) => finger.pointerId !== event.pointerId);
    const away = (finger) => Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY);
    plane.look(other ? away(before) / Math.max(away(event), 1) : 1, to, [(to[0] - from[0]) * part, (to[1] - from[1]) * part]);
    moved();
  } else {
    point(plane, event, false);
  }
}

const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const CLOSER = 0.7;

function key(plane, event) {
  const frame = plane.frames.at(-1), steps = KEYS[event.key];
  const factor = { "+": CLOSER, "-": 1 / CLOSER, 0: Infinity }[event.key];
  if (steps && typeof shown.found !== "string") {
    const far = event.shiftKey ? 20 : 4, [x, y] = plane.placeOf(shown.found), [[x0, x1], [y0, y1]] = frame.view;
    show(plane.given(frame, [x + steps[0] * far * (x1 - x0) / frame.width, y + steps[1] * far * (y1 - y0) / frame.height]), true);
  } else if (factor) {
    plane.look(factor, plane.middle());
    moved();
  } else {
    return;
  }
  event.preventDefault();
}

for (const plane of planes) {
  const { svg, figure } = plane;
  svg.addEventListener("pointermove", (event) => move(plane, event));
  svg.addEventListener("pointerdown", (event) => { fingers.set(event.pointerId, event); point(plane, event, true); });
  for (const end of ["pointerup", "pointercancel", "pointerleave"]) {
    svg.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  svg.addEventListener("wheel", (event) => {
    plane.look(2 ** (event.deltaY / 300), plane.on(event));
    moved();
    event.preventDefault();
  }, { passive: false });
  svg.addEventListener("keydown", (event) => key(plane, event));
  figure.querySelector(".larger").addEventListener("click", () => {
    enlarge(plane.plane);
    moved();
    largePlane().svg.focus();
  });
}
for (const name of WEIGHTS) at(`choose-${name}`).addEventListener("change", () => show({ ...shown.given, weight: name }, true));
for (const [id, factor] of [["closer", CLOSER], ["farther", 1 / CLOSER], ["all", Infinity]]) {
  at(id).addEventListener("click", () => {
    largePlane().look(factor, largePlane().middle());
    moved();
  });
}
at("levels").addEventListener("change", ({ target }) => {
  Plane.hasLevels = target.checked;
  shownPlanes().forEach((one) => one.draw());
  told();
});
at("save-map").addEventListener("click", () => save(largePlane().svg, "map.svg"));
at("save-arch").addEventListener("click", () => save(at("arch").querySelector("svg"), "arch.svg"));
at("ask").addEventListener("submit", (event) => {
  event.preventDefault();
  const [half_opening, friction] = ["ask-half-opening", "ask-friction"].map((id) => at(id).value);
  show({ weight, half_opening, friction }, true);
});
addEventListener("shown", ({ detail: { given } }) => {
  for (const [id, text] of [["ask-half-opening", given.half_opening], ["ask-friction", given.friction ?? given.friction_angle]]) {
    if (text !== undefined && document.activeElement !== at(id)) at(id).value = text;
  }
});
addEventListener("hashchange", open);
new ResizeObserver(() => shownPlanes().forEach((one) => one.draw())).observe(document.querySelector(".planes"));
enlarge(large);
open();
