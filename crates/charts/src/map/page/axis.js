// Ticks of an axis: round values, as many as have room, each with its text.

/** Multiples of 1, 2 or 5 times a power of ten, at most so many. */
function ticks([from, to], most) {
  const power = 10 ** Math.floor(Math.log10((to - from) / most));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((step) => (to - from) / step <= most);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const first = Math.ceil(from / step - 1e-9), last = Math.floor(to / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => [(first + k) * step, ((first + k) * step).toFixed(decimals)]);
}

/** Distance between two ticks of a friction, in pixels, and values of one step at most. */
const APART = 40, MANY = 2000;

/** Frictions along an axis of their angles in degrees, so many pixels long: the rounder a value, the sooner it has its tick. */
function frictionTicks([from, to], pixels) {
  const unit = pixels / (to - from), placed = to > 90 - 1e-9 ? [[90, "∞"]] : [];
  const [low, high] = [from, Math.min(to, 90 - APART / unit)].map((degrees) => Math.tan(degrees * DEGREE));
  for (const step of [1, 0, -1, -2, -3, -4].flatMap((order) => [5, 2, 1].map((factor) => factor * 10 ** order))) {
    const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
    if (last - first > MANY) break;
    for (let k = first; k <= last; k++) {
      const friction = Number((k * step).toPrecision(8)), degrees = Math.atan(friction) / DEGREE;
      if (placed.every(([other]) => Math.abs(other - degrees) * unit >= APART)) placed.push([degrees, String(friction)]);
    }
  }
  return placed;
}

/** Sorted places, moved as little as a pass each way does so that neighbours are apart, between two ends. */
function spread(places, gap, low, high) {
  const moved = [];
  for (const place of places) moved.push(Math.max(place, moved.length ? moved.at(-1) + gap : low));
  let end = high;
  for (let k = moved.length - 1; k >= 0; k--) {
    moved[k] = Math.min(moved[k], end);
    end = moved[k] - gap;
  }
  return moved;
}
