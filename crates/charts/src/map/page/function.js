// The map as the graph of one function, in doubles: to each thickness and friction belongs the widest half opening that
// stands, and two questions tell how it collapses. Is the thrust set by the hinges or by an inner joint that slides?
// Does the shoulder slide or turn first? Every form is regular where arches are thin and where friction is unlimited.

/** Stumpff's function c_n(b), the sum of (-b)^k / (n + 2k)!: c_0(x²) = cos x, c_1(x²) = sin x / x. */
function stumpff(n, b) {
  let term = 1, sum = 0;
  for (let k = 2; k <= n; k++) term /= k;
  for (let k = n; k < n + 40; k += 2) {
    sum += term;
    if (Math.abs(term) < 1e-18 * Math.abs(sum)) break;
    term *= -b / ((k + 1) * (k + 2));
  }
  return sum;
}

/** Where a function that falls from a positive value vanishes. */
function zero(f, low, high) {
  for (let k = 0; k < 100; k++) {
    const middle = (low + high) / 2;
    if (middle === low || middle === high) break;
    if (f(middle) > 0) low = middle; else high = middle;
  }
  return (low + high) / 2;
}

/** More than the square of any rotational joint. */
const WIDEST = 2.4;

/** (2), (5): the thrust and the joint beta_r with three hinges; from the end of rotation on, none. */
function hinged(eta, fac) {
  const [c0, c1, c2, c3] = [0, 1, 2, 3].map((n) => (b) => stumpff(n, b));
  const rest = 2 - eta;
  const excess = (b) => 2 * eta * ((c1(b) + c0(b)) * rest - 2 * fac * c1(b)) - (b * rest) ** 2 * c2(b) * c3(b);
  if (!(excess(0) > 0)) return { thrust: 0, rotation: 0 };
  const b = zero(excess, 0, WIDEST);
  return { thrust: b * b * rest * c2(b) * c3(b) / (2 * eta * c1(b)), rotation: Math.sqrt(b) };
}

/** (18): the thrust and the joint beta_s with an inner joint that slides, phi = chi - sin chi cos chi. */
function slidingInside(phi) {
  if (phi >= Math.PI / 2) return { thrust: 0, sliding: 0 };
  const chi = zero((chi) => phi - 4 * chi ** 3 * stumpff(3, 4 * chi * chi), 0, Math.PI / 2);
  return { thrust: Math.cos(chi) ** 2, sliding: Math.sin(chi) * Math.cos(chi) };
}

/** (5): the joint at which the line of thrust touches the intrados; 0 if it does so at the crown. */
function touching(eta, thrust, fac) {
  const excess = 2 - thrust - 2 * fac / (2 - eta);
  if (!(excess > 0)) return 0;
  return Math.sqrt(zero((b) => excess * stumpff(1, b) - b * (stumpff(2, b) - stumpff(3, b)), 0, WIDEST));
}

/** (3): the half opening at which the line of thrust reaches the extrados at the shoulder. */
function turning(eta, thrust, joint, fac) {
  const normal = (beta) => thrust * Math.cos(beta) + beta * Math.sin(beta);
  const fall = (alpha) => 2 * Math.sin((alpha + joint) / 2) * Math.sin((alpha - joint) / 2);
  const room = (alpha) => eta * (normal(alpha) + normal(joint))
    + 2 * (alpha * Math.sin(alpha) - joint * Math.sin(joint) - (thrust + fac) * fall(alpha));
  return zero(room, joint, Math.PI);
}

/** (17): the half opening at which the shoulder slides. */
function slidingOut(thrust, phi) {
  return phi + zero((chi) => (phi + chi) * Math.cos(chi) - thrust * Math.sin(chi), 0, Math.PI / 2);
}

/** The widest half opening that stands, its mode, thrust and joints; `isOnLine` if doubles hardly tell the mode. */
function widest(delta, eta, phi) {
  const fac = 1 + delta * eta * eta / 12;
  const hinges = hinged(eta, fac), inner = slidingInside(phi);
  const slides = inner.thrust > hinges.thrust;
  const thrust = Math.max(inner.thrust, hinges.thrust);
  const rotation = slides ? touching(eta, thrust, fac) : hinges.rotation;
  const turns = turning(eta, thrust, rotation, fac), slips = slidingOut(thrust, phi);
  const between = slides ? (rotation === 0 ? "[r,s]" : rotation > inner.sliding ? "[r,r,s]" : "[r,s,r]")
    : thrust === 0 ? "[r]" : "[r,r,r]";
  const mode = slips < turns ? (slides ? "[s,s]" : "[s,r,r]") : between;
  const gaps = [turns - slips, thrust && inner.thrust - hinges.thrust, slides && slips > turns ? rotation - inner.sliding : 1];
  return {
    mode, thrust, rotation, sliding: inner.sliding, halfOpening: Math.min(turns, slips),
    isOnLine: thrust > 0 && gaps.some((gap) => Math.abs(gap) < 1e-9),
  };
}

/** The least thickness up to 2 of an arch; `null` if it falls at each. */
function least(delta, alpha, phi) {
  if (!(widest(delta, 2, phi).halfOpening >= alpha)) return null;
  return zero((eta) => alpha - widest(delta, eta, phi).halfOpening, 0, 2);
}

/** The least friction angle with which an arch of a thickness stands; `null` if it falls with each. */
function leastFriction(delta, alpha, eta) {
  if (!(widest(delta, eta, Math.PI / 2).halfOpening >= alpha)) return null;
  return zero((phi) => alpha - widest(delta, eta, phi).halfOpening, 0, Math.PI / 2);
}
