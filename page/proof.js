// What is proved of the arch that is shown. The map's script finds where a root seems to be; the checker does not believe it.

/** Digits that are proved, where they are decided. */
const DIGITS = 10;
/** How far from the friction that is just enough others are proved not to be, and to be. */
const NEXT = 1e-7;
/** Seconds after which the command is shown instead. */
let patience = 2;

const frictionText = ({ friction, friction_angle }) => friction ?? (friction_angle && `tan(${friction_angle})`);

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

/** What more friction does for an arch that falls: nothing so wide stands at any, or how much is not enough and how much is. */
async function moreFriction({ weight, half_opening, span, rise, radius, measured_at }) {
  const arch = { weight, half_opening, span, rise, radius, measured_at }, delta = weight === "heyman" ? 0 : 1;
  const ask = async (friction, one) => {
    const answer = await prover.ask("prove", [encoded({ ...arch, friction, digits: DIGITS, ...one })]);
    return answer?.reason === undefined ? answer?.values : undefined;
  };
  const none = await ask("inf", tooWide(arch, Math.PI / 2)), needed = none ? null : leastFriction(delta, opening(arch), 2);
  if (needed === null) return { none };
  const [less, more] = [-NEXT, NEXT].map((off) => (Math.tan(needed) * (1 + off)).toPrecision(9)), found = solve({ ...arch, friction: more });
  const short = await ask(less, tooWide(arch, Math.atan(less)));
  return { short, enough: short && typeof found !== "string" ? await ask(more, { subject: found.mode, start: starts(found) }) : undefined };
}

/** What is asked about an arch: a place of the map has the half opening that was found for it, and is drawn only. */
function questions(given, found, wanted) {
  const { weight, half_opening, span, rise, radius, measured_at, thickness } = given;
  const shape = isPlace(given) ? { half_opening: String(found.halfOpening) } : { half_opening, span, rise, radius, measured_at, thickness };
  const friction = hasFriction(given) || !isPlace(given) ? frictionText(given) : String(Math.tan(found.phi));
  const modes = [found.mode, ...Object.keys(WORDS).filter((mode) => mode !== found.mode && mode !== "[s,s]")];
  const tries = typeof found !== "string" ? modes.map((subject) => ({ subject, start: starts(found) })) : found.startsWith("falls") ? falls(given)
    // What the map's script does not read is told by the reader of every door.
    : [{ subject: "[r,r,r]", start: {} }];
  return tries.map((one) => encoded({ weight, ...shape, friction, digits: DIGITS, ...one, ...wanted }));
}

/** The answer of the checker, with its subject or the reason why there is none. */
async function prove(given, found, wanted) {
  const late = setTimeout(() => prover.stop(), patience * 1000);
  const answer = await prover.ask("prove", questions(given, found, wanted));
  if (answer && answer.reason === undefined && typeof found === "string") answer.more = await moreFriction(given);
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

addEventListener("shown", ({ detail: { given, found, isKept, isFault } }) => {
  wait(given, typeof found !== "string", isKept);
  if (canProve) examine({ given, found, isAsked: !isFault && !(isPlace(given) && typeof found === "string") });
});

let canProve = false;
prover.ready().then(() => {
  canProve = true;
  draw = () => {};
  open();
}, (error) => say("proof", `Nothing is proved here: this browser does not run the checker (${error.message}).`, "open"));
open();
