// What is asked: texts that couplet reads too, and the part of the address behind # that holds the same.

const DEGREE = Math.PI / 180;
/** Keys of an arch, and of the part of a map that is shown, as options of couplet have them. */
const ARCH = ["weight", "half_opening", "span", "rise", "radius", "measured_at", "thickness", "friction", "friction_angle"];
const VIEW = ["plane", "half_opening_range", "friction_range", "thickness_range"];
/** The paper's letters are keys too. */
const LETTERS = new Map([["alpha", "half_opening"], ["mu", "friction"], ["phi", "friction_angle"], ["eta", "thickness"]]);
/** What is shown where nothing is asked. */
const USUAL = { half_opening: "80deg", friction: "0.6" };

/** What the address asks for, in texts; what is wrong with its keys is a fault. */
function asked(weights, planes) {
  const given = {}, wrong = [];
  for (const [letter, text] of new URLSearchParams(location.hash.slice(1))) {
    const key = LETTERS.get(letter) ?? letter;
    if (![...ARCH, ...VIEW].includes(key)) wrong.push(`an address has no key '${letter}'; its keys are ${[...ARCH, ...VIEW].join(", ")}`);
    else if (key in given) wrong.push(`${key} is given twice`);
    else given[key] = text;
  }
  for (const [key, names] of [["weight", weights], ["plane", planes]]) {
    if (given[key] !== undefined && !names.includes(given[key])) wrong.push(`the ${key} '${given[key]}' is none of this page, which has ${names.join(", ")}`);
  }
  if ("friction" in given && "friction_angle" in given) wrong.push("a friction and a friction angle are given; one of them is enough");
  const view = Object.fromEntries(VIEW.filter((key) => key in given).map((key) => [key, given[key]]));
  const arch = Object.fromEntries(ARCH.filter((key) => key in given).map((key) => [key, given[key]]));
  const usual = wrong.length || Object.keys(arch).some((key) => key !== "weight") ? {} : USUAL;
  return { arch: { ...usual, ...arch }, view, fault: wrong[0] };
}

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

const hasFriction = ({ friction, friction_angle }) => friction !== undefined || friction_angle !== undefined;

/** Whether what is given is a place of a plane, with nothing of an arch but its coordinates; over half opening and friction each is an arch. */
const isPlace = ({ half_opening, span, rise, radius, measured_at, thickness, ...rest }) =>
  thickness !== undefined && [span, rise, radius, measured_at].every((text) => text === undefined) && (half_opening === undefined) === hasFriction(rest);

/** The half opening; with span and rise twice the arctangent of the rise by half the span, of a radius the flatter arc. */
const opening = ({ half_opening, span = "", rise = "", radius = "" }) => {
  const [s, f, r] = [span, rise, radius].map(metres);
  if (s && f) return 2 * Math.atan(2 * f / s);
  if (half_opening !== undefined) return read(half_opening);
  return s ? Math.asin(s / 2 / r) : Math.acos(1 - f / r);
};

/** The angle of friction: given, also as the friction, or of its coefficient. */
const frictionAngle = ({ friction, friction_angle = "" }) =>
  friction === undefined || /(deg|°|rad)$/i.test(friction) ? read(friction ?? friction_angle) : Math.atan(read(friction));

/** A text as a shell reads it. */
const quoted = (text) => /^[\w.,/:+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

/** The command that answers what is asked. */
function command(given) {
  const question = isPlace(given) ? (hasFriction(given) ? "find half-opening" : "find friction") : given.thickness === undefined ? "state" : "assess";
  return [`couplet ${question}`, ...Object.entries(given).map(([key, value]) => `--${key.replace("_", "-")} ${quoted(value)}`)];
}

/** The numbers of an arch that was given in texts; a text if there is none. */
function solve(given) {
  const isArch = !isPlace(given), delta = given.weight === "heyman" ? 0 : 1;
  const alpha = opening(given), phi = frictionAngle(given), eta = read(given.thickness ?? "");
  if (given.span !== undefined && !(alpha > 0)) return "a span and a rise are lengths (10m, 60cm, 33ft)";
  if ((isArch || !hasFriction(given)) && !(alpha > 0 && alpha < Math.PI)) return "a half opening is between 0 and 180deg";
  if ((isArch || hasFriction(given)) && !(phi > 0 && phi <= Math.PI / 2)) return "a friction is positive (0.6, inf), a friction angle up to 90deg";
  if (!isArch && !(eta > 0 && eta <= 2)) return "a thickness is positive, and 2 at most";
  const at = (eta, phi) => ({ eta, phi, fac: 1 + delta * eta * eta / 12, ...widest(delta, eta, phi) });
  if (!isArch && hasFriction(given)) return at(eta, phi);
  const found = isArch ? least(delta, alpha, phi) : leastFriction(delta, alpha, eta);
  if (found === null) return `falls: no ${isArch ? "thickness" : "friction"} is enough`;
  return isArch ? at(found, phi) : at(eta, found);
}
