// What this page has beyond the map: proofs, made and checked by the program's own checker in WebAssembly, and files to
// check. The map's script finds where a root seems to be; the checker does not believe it.

/** Digits that are proved, where they are decided. */
const DIGITS = 10;
/** As many bytes as the command reads. */
const MOST_BYTES = 64 * 2 ** 20;
let engine = null;

async function load() {
  const bytes = Uint8Array.from(atob(at("wasm").textContent.trim()), (letter) => letter.charCodeAt(0));
  engine = (await WebAssembly.instantiate(bytes)).instance.exports;
}

/** Calls a function of the checker with bytes; one that stops, as for want of memory, is loaded anew. */
function call(name, bytes) {
  try {
    const place = engine.input(bytes.length);
    new Uint8Array(engine.memory.buffer, place, bytes.length).set(bytes);
    const length = engine[name]();
    return JSON.parse(new TextDecoder().decode(new Uint8Array(engine.memory.buffer, engine.output(), length)));
  } catch (error) {
    engine = null;
    load();
    return { accepted: false, sentence: `not checked: the checker stopped (${error.message})`, reason: "the checker stopped" };
  }
}

const frictionText = ({ friction, friction_angle }) => friction ?? `tan(${friction_angle})`;

/** The numbers of the map's script by the names of the checker's unknowns. */
function starts({ halfOpening, eta, thrust, rotation, sliding, phi }) {
  return { half_opening: halfOpening, thickness: eta, thrust, rotation_joint: rotation, sliding_joint: sliding, friction: Math.min(Math.tan(phi), 1e9) };
}

/** What seems to decide that no thickness is enough, the likelier first. */
function falls(given) {
  const alpha = read(given.half_opening), delta = given.weight === "heyman" ? 0 : 1;
  const phi = given.friction === undefined ? read(given.friction_angle) : Math.atan(read(given.friction));
  const least = zero((phi) => alpha - slidingOut(slidingInside(phi).thrust, phi), 1e-9, Math.PI / 2);
  const inner = slidingInside(phi), fac = 1 + delta / 3;
  const slides = { subject: "slides", start: starts({ ...slidingInside(least), phi: least, halfOpening: alpha, eta: 2, rotation: 0 }) };
  const wide = { subject: "too_wide", start: starts({ ...inner, phi, halfOpening: turning(2, inner.thrust, 0, fac), eta: 2, rotation: 0 }) };
  return phi < least ? [slides, wide] : [wide, slides];
}

/** What is proved of an arch: the answer of the checker with its subject, or the first reason why there is none. */
function prove(given, found, file = false) {
  if (!engine) return { reason: "the checker is not loaded" };
  const isArch = typeof found !== "string";
  const modes = isArch ? [found.mode, ...Object.keys(WORDS).filter((mode) => mode !== found.mode && mode !== "[s,s]")] : [];
  const tries = isArch ? modes.map((subject) => ({ subject, start: starts(found) })) : falls(given);
  let reason = null;
  for (const { subject, start } of tries) {
    const question = { weight: given.weight, half_opening: given.half_opening, friction: frictionText(given), subject, start, digits: DIGITS, file };
    const answer = call("prove", new TextEncoder().encode(JSON.stringify(question)));
    if (answer.values) return { ...answer, subject };
    reason ??= answer.reason;
  }
  return { reason };
}

const SHOWN = ["mode", "thickness", "thrust", "rotation_joint", "sliding_joint"];

function say(id, text, state) {
  at(id).textContent = text;
  at(id).hidden = text === "";
  at(id).classList.toggle("is-proved", state === "proved");
  at(id).classList.toggle("is-open", state === "open");
}

/** The texts of the arch, with the numbers that are proved in place of those in doubles. */
function tell({ given, found }) {
  const isArch = typeof found !== "string", isGiven = given.half_opening !== undefined;
  SHOWN.forEach((id) => at(id).classList.remove("proved"));
  at("save").hidden = true;
  at("take").hidden = isGiven || !isArch;
  at("saved").textContent = "";
  say("verdict", "");
  at("thickness").previousElementSibling.textContent = isGiven ? "least thickness η = t/r" : "thickness η = t/r";
  if (!isArch && !found.startsWith("falls")) return say("proof", "", "open");
  if (!isGiven) return say("proof", "Candidate, not proved: the half opening of this place was found in doubles.", "open");
  const answer = prove(given, found);
  if (!answer.values) {
    say("proof", `Candidate, not proved: ${answer.reason}.`, "open");
    return;
  }
  const { values, subject, digits } = answer;
  at("save").hidden = false;
  if (!isArch) {
    const limit = subject === "slides" ? `the friction is below ${values.friction}, which this half opening needs` : `the half opening is beyond ${values.half_opening} rad, at which a thickness of 2 is just enough`;
    return say("proof", `Proved here: it stands at no thickness, as ${limit}.`, "proved");
  }
  at("mode").textContent = subject;
  at("summary").textContent = `${subject}: ${WORDS[subject]}`;
  for (const id of ["thickness", "thrust"]) if (values[id]) at(id).textContent = values[id];
  for (const id of ["rotation_joint", "sliding_joint"]) {
    at(id).textContent = values[id] ? `${values[id]} rad${values[`${id}_degrees`] ? `, ${values[`${id}_degrees`]}°` : ""}` : "none";
  }
  SHOWN.forEach((id) => at(id).classList.toggle("proved", id === "mode" || values[id] !== undefined));
  say("proof", `Proved here: the mode, and each number with ✓, correctly rounded to ${digits} digits.`, "proved");
  if (given.thickness !== undefined) assess(read(given.thickness), values.thickness, digits, found);
}

/** An arch of a given thickness beside its least one: exactly from that on it stands. */
function assess(eta, text, digits, found) {
  if (!(eta > 0 && eta <= 2)) return say("verdict", "A thickness is positive, and 2 at most.", "open");
  const least = Number(text), near = 10 ** (1 - digits), ratio = eta / least;
  const fac = 1 + (found.fac - 1) * (eta / found.eta) ** 2;
  at("arch").innerHTML = arch({ ...found, mode: "", eta, fac, crownMoment: middleMoment(found, eta, fac) });
  const safety = `geometric safety ${sure(ratio, near, 4)}, the thickness by the least one`;
  if (ratio > 1 + near) say("verdict", `It stands, proved: ${safety}. The drawing has one of the lines of thrust that fit; the numbers are those at the least thickness.`, "proved");
  else if (ratio < 1 - near) say("verdict", `It does not stand, proved: ${safety}. No line of thrust fits; the numbers are those at the least thickness.`, "proved");
  else say("verdict", "Too near to the least thickness to tell here; couplet assess does.", "open");
}

/** The crown moment in the middle of those with which a line of thrust fits, or fails by the least. */
function middleMoment({ thrust, halfOpening }, eta, fac) {
  const joints = Array.from({ length: 121 }, (_, k) => k / 120 * halfOpening);
  const moment = (r) => (beta) => r * (thrust * Math.cos(beta) + beta * Math.sin(beta)) - fac * (1 - Math.cos(beta));
  return (Math.max(...joints.map(moment(1 - eta / 2))) + Math.min(...joints.map(moment(1 + eta / 2)))) / 2;
}

let last = null;
addEventListener("shown", ({ detail }) => {
  last = detail;
  tell(detail);
  const { half_opening, friction, friction_angle, thickness } = detail.given;
  const put = (id, text) => { if (document.activeElement !== at(id)) at(id).value = text; };
  // From a place of the map a slider goes on with its half opening.
  const place = half_opening ?? detail.found.halfOpening?.toFixed(6);
  const isThick = half_opening !== undefined && thickness !== undefined;
  if (place !== undefined) {
    put("ask-half-opening", place);
    put("slide-half-opening", read(place) / DEGREE);
  }
  put("ask-thickness", isThick ? thickness : "");
  put("slide-thickness", isThick ? read(thickness) : 0);
  put("ask-friction", friction ?? friction_angle);
  put("slide-friction", Math.min(friction === undefined ? Math.tan(read(friction_angle)) : read(friction), 2));
});

function fields() {
  const [half_opening, friction, thickness] = ["ask-half-opening", "ask-friction", "ask-thickness"].map((id) => at(id).value.trim());
  const isAngle = /deg|°/i.test(friction);
  return { weight: map().id, half_opening, ...(isAngle ? { friction_angle: friction } : { friction }), ...(thickness && { thickness }) };
}

for (const [name, text] of [["half-opening", (x) => `${x}deg`], ["friction", (x) => x], ["thickness", (x) => (Number(x) ? x : "")]]) {
  const slider = at(`slide-${name}`), moved = (isKept) => {
    at(`ask-${name}`).value = text(slider.value);
    show(fields(), isKept);
  };
  slider.addEventListener("input", () => moved(false));
  slider.addEventListener("change", () => moved(true));
}
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

at("save").addEventListener("click", () => {
  const { certificate, reason } = prove(last.given, last.found, true);
  if (!certificate) return void (at("saved").textContent = `not proved in the second arithmetic: ${reason}`);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([certificate], { type: "application/json" }));
  link.download = "arch.json";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  at("saved").textContent = `arch.json: ${call("check", new TextEncoder().encode(certificate)).sentence}`;
});

/** The sentence of a file, after its name. */
async function checkFile(file) {
  const line = document.createElement("li");
  line.textContent = `${file.name}: being checked`;
  at("checked").prepend(line);
  await ready;
  // The line is drawn before a long file is checked.
  await new Promise((resolve) => setTimeout(resolve, 20));
  const isLong = file.size > MOST_BYTES;
  const verdict = isLong ? { accepted: false, sentence: `refused: the file has more than ${MOST_BYTES} bytes` }
    : engine ? call("check", new Uint8Array(await file.arrayBuffer())) : { accepted: false, sentence: "not checked: the checker is not loaded" };
  line.textContent = `${file.name}: ${verdict.sentence}`;
  line.className = verdict.accepted ? "is-proved" : "is-refused";
}

async function checkFiles(files) {
  for (const file of [...files]) await checkFile(file);
}

at("files").addEventListener("change", ({ target }) => checkFiles(target.files).then(() => target.value = ""));
// A file that misses the field is not opened in place of the page.
addEventListener("dragover", (event) => { event.preventDefault(); at("drop").classList.add("is-over"); });
addEventListener("dragleave", () => at("drop").classList.remove("is-over"));
addEventListener("drop", (event) => {
  event.preventDefault();
  at("drop").classList.remove("is-over");
  checkFiles(event.dataTransfer.files);
});

const ready = load().catch((error) => say("proof", `Nothing is proved here: this browser does not run WebAssembly (${error.message}).`, "open"));
ready.then(() => { if (engine) show(asked()); });
