// What is proved of the arch that is shown. The map's script finds where a root seems to be; the checker does not believe it.

/** Digits that are proved, where they are decided. */
const DIGITS = 10;
/** Seconds after which the command is shown instead. */
let patience = 2;

const frictionText = ({ friction, friction_angle }) => friction ?? `tan(${friction_angle})`;

/** The numbers of the map's script by the names of the checker's unknowns. */
function starts({ halfOpening, eta, thrust, rotation, sliding, phi }) {
  return { half_opening: halfOpening, thickness: eta, thrust, rotation_joint: rotation, sliding_joint: sliding, friction: Math.min(Math.tan(phi), 1e9) };
}

/** What seems to decide that no thickness is enough, the likelier first. */
function falls(given) {
  const alpha = opening(given), phi = frictionAngle(given);
  const least = zero((phi) => alpha - slidingOut(slidingInside(phi).thrust, phi), 1e-9, Math.PI / 2);
  const slides = { subject: "slides", start: starts({ ...slidingInside(least), phi: least, halfOpening: alpha, eta: 2, rotation: 0 }) };
  return phi < least ? [slides, tooWide(given, phi)] : [tooWide(given, phi), slides];
}

/** That with this friction a thickness of 2 is not enough. */
function tooWide({ weight }, phi) {
  const inner = slidingInside(phi), fac = 1 + (weight === "heyman" ? 0 : 1) / 3;
  return { subject: "too_wide", start: starts({ ...inner, phi, halfOpening: turning(2, inner.thrust, 0, fac), eta: 2, rotation: 0 }) };
}

/** Why more friction does not help an arch that slides: nothing stands so wide, or not with a little more than it slides with. */
function helpless({ weight, half_opening, span, rise, measured_at }, { values }) {
  const more = (Number(values.friction) * (1 + 1e-8)).toPrecision(10);
  const question = (friction, phi) => encoded({ weight, half_opening, span, rise, measured_at, friction, digits: DIGITS, ...tooWide({ weight }, phi) });
  return [question("inf", Math.PI / 2), question(more, Math.atan(more))];
}

/** What is asked about an arch: a place of the map has the half opening that was found for it, and is drawn only. */
function questions(given, found, wanted) {
  const { weight, half_opening, span, rise, measured_at, thickness } = given;
  const shape = isShape(given) ? { half_opening, span, rise, measured_at, thickness } : { half_opening: String(found.halfOpening) };
  const modes = typeof found === "string" ? [] : [found.mode, ...Object.keys(WORDS).filter((mode) => mode !== found.mode && mode !== "[s,s]")];
  const tries = typeof found === "string" ? falls(given) : modes.map((subject) => ({ subject, start: starts(found) }));
  return tries.map((one) => encoded({ weight, ...shape, friction: frictionText(given), digits: DIGITS, ...one, ...wanted }));
}

/** The answer of the checker, with its subject or the reason why there is none. */
async function prove(given, found, wanted) {
  const late = setTimeout(() => prover.stop(), patience * 1000);
  const answer = await prover.ask("prove", questions(given, found, wanted));
  if (answer?.subject === "slides") answer.helpless = await prover.ask("prove", helpless(given, answer));
  clearTimeout(late);
  return answer ?? { reason: `the proof takes longer than ${patience} seconds here` };
}

let last = null, next = null, isBusy = false;

/** Proves what is shown; of what comes in the meantime only the last. */
async function examine(detail) {
  last = next = detail;
  if (isBusy) return;
  isBusy = true;
  while (next) {
    const now = next;
    next = null;
    const wanted = { drawing: "moving" };
    const answer = now.isAsked ? await prove(now.given, now.found, wanted) : null;
    if (now === last) tell(now, answer);
  }
  isBusy = false;
  dispatchEvent(new Event("told"));
}

addEventListener("shown", ({ detail: { given, found, isKept } }) => {
  const isArch = typeof found !== "string";
  wait(given, isArch, isKept);
  if (!canProve) return;
  examine({ given, found, isAsked: isArch || found.startsWith("falls") });
});

let canProve = false;
prover.ready().then(() => {
  canProve = true;
  draw = () => {};
  show(asked());
}, (error) => say("proof", `Nothing is proved here: this browser does not run the checker (${error.message}).`, "open"));
show(asked());
