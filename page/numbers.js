// The arch that is shown, in words and as a table: what is proved, and what is a candidate.

/** The rows of numbers that the map's script fills. */
const ROWS = ["mode", "half_opening", "thickness", "friction", "friction_angle", "thrust", "rotation_joint", "sliding_joint"];
/** Those that only this page has. */
const MORE = ["given_thickness", "geometric_safety", "radius_m", "given_thickness_m", "least_thickness_m"];

function say(id, text, state) {
  at(id).textContent = text;
  at(id).hidden = text === "";
  at(id).classList.toggle("is-proved", state === "proved");
  at(id).classList.toggle("is-open", state === "open");
}

/** A row of the table, and how its number is known. */
function row(id, text, how) {
  if (text !== undefined) at(id).textContent = text;
  at(id).classList.toggle("proved", how === "proved");
  at(id).classList.toggle("candidate", how === "candidate");
  at(id).parentElement.hidden = how === undefined;
  at(id).nextElementSibling.textContent = how ?? "";
}

/** Until the answer comes every number is a candidate. */
function wait(given, isArch, isKept) {
  at("least").textContent = isPlace(given) ? "thickness η = t/r" : "least thickness η = t/r";
  ROWS.forEach((id) => row(id, undefined, "candidate"));
  MORE.forEach((id) => row(id));
  say("verdict", "");
  at("save").hidden = at("certify").hidden = true;
  at("take").hidden = !isPlace(given) || !isArch;
  at("saved").textContent = "";
  // Who listens hears where a slider has come to, and not each step.
  at("proof-panel").setAttribute("aria-busy", String(isKept === false));
}

/** The texts of the arch, with the numbers that are proved in place of those in doubles. */
function tell({ given, found, isAsked }, answer) {
  const isArch = typeof found !== "string", values = answer?.values;
  if (answer?.drawing) draws(answer.drawing, at("summary").textContent);
  else if (isArch) at("arch").innerHTML = arch(found);
  at("moving").hidden = !/<animate/.test(answer?.drawing ?? "");
  at("found").hidden = !isArch;
  if (!isAsked) return say("proof", "", "open");
  const sought = hasFriction(given) ? "half opening" : "friction";
  if (isPlace(given)) return say("proof", isArch ? `Candidates (≈), not proved: the ${sought} of this place was found in doubles.` : "", "open");
  if (answer.command === null) return refuse(answer.reason);
  at("certify").hidden = !answer.command;
  at("certify-command").textContent = answer.command ?? "";
  if (!values) return say("proof", unproved(isArch, answer), "open");
  at("save").hidden = false;
  const { subject, digits } = answer;
  if (!isArch) {
    const limit = subject === "slides" ? `it slides with less friction than ${values.friction}`
      : `the half opening is beyond ${values.half_opening} rad, at which a thickness of 2 is just enough`;
    return say("proof", `Proved here: it stands at no thickness, as ${limit}${beyond(answer.more)}.`, "proved");
  }
  at("summary").textContent = `${subject}: ${WORDS[subject]}`;
  const angle = (name) => values[name] && `${values[name]} rad${values[`${name}_degrees`] ? `, ${values[`${name}_degrees`]}°` : ""}`;
  const texts = {
    mode: subject, half_opening: angle("given_half_opening"), thickness: values.thickness, friction: values.given_friction,
    friction_angle: values.given_friction_angle_degrees && `${values.given_friction_angle_degrees}°`, thrust: values.thrust,
  };
  for (const [id, text] of Object.entries(texts)) if (text) row(id, text, "proved");
  for (const id of ["rotation_joint", "sliding_joint"]) row(id, angle(id) ?? "none", "proved");
  for (const id of MORE) if (values[id]) row(id, values[id], "proved");
  const moves = [answer.may_move, answer.note && `Note: ${answer.note}.`].filter(Boolean).map((text) => ` ${text}`).join("");
  say("proof", `Proved here: each number with ✓, correctly rounded to ${digits} digits or, where it ends or fewer are certain, fewer.${moves}`, "proved");
  if (given.thickness !== undefined) assess(answer, values.geometric_safety);
}

/** Why nothing is proved of an arch, and what to do. */
function unproved(isArch, { command, reason }) {
  const what = isArch ? "Candidates (≈), not proved here" : "Not proved here";
  if (!command) return `${what}: ${reason}.`;
  const why = isArch ? "for this arch, very thin or next to a line of the map, the 31 digits with which the page computes are too few" : "the page finds no candidate for it";
  return `${what}: ${why}. The command below proves it, with as many digits as that takes.`;
}

/** What can be read as no arch is none, whatever the map's script makes of it: the sentence is that of every door. */
function refuse(reason) {
  at("summary").textContent = reason;
  at("found").hidden = true;
  at("with-command").hidden = at("moving").hidden = true;
  say("proof", "", "open");
}

/** What more friction would do, as far as that is proved. */
function beyond({ none, short, enough }) {
  if (none) return `, and beyond a half opening of ${none.half_opening} rad nothing stands at any friction`;
  if (!short) return "";
  return `, and with a friction of ${short.given_friction} it would have to be thicker than twice its radius${enough ? `; ${enough.given_friction} is enough` : ""}`;
}

/** An arch of a given thickness beside its least one: exactly from that on it stands. */
function assess({ stands, meaning, has_line: hasLine }, safety) {
  const times = safety ? `; its thickness is ${safety} times the least` : "";
  const table = "Mode, thrust and joints in the table are those at the least thickness.";
  const line = hasLine ? " The line of thrust that is drawn fits, which is proved too." : "";
  if (stands === true) say("verdict", `It stands, proved: ${meaning}${times}.${line} ${table}`, "proved");
  else if (stands === false) say("verdict", `It falls, proved${times}. No line of thrust fits. ${table}`, "proved");
  else say("verdict", "Undecided: the thickness is too near to the least one to tell here; couplet assess does.", "open");
}
