// The names in a frame: of landmarks and of domains, each where it has room.

/** Sizes of fonts, in frames that are narrow and from some width on not. */
const NAMES = [13, 15], ROOMY = 500;
/** Places that are looked at for the name of a domain, across and down, and the steps in which its room is measured. */
const GRID = [60, 50], FINER = 0.05;
/** The part of its ample size for which a name has to have room in its domain. */
const INSIDE = 0.7;

/** Places of a frame, to look for the one around which a domain has most room. */
class Grid {
  constructor(frame) {
    this.frame = frame;
    this.step = [frame.width / GRID[0], frame.height / GRID[1]];
  }

  /** The middle of the largest label of these proportions in a domain, off some boxes, and its size in labels; nothing if the domain is not seen. */
  roomiest(outline, boxes, half) {
    const { left, top } = this.frame, [dx, dy] = this.step, sums = new Uint16Array((GRID[0] + 1) * (GRID[1] + 1));
    const at = (column, row) => ({ x: left + (column + 0.5) * dx, y: top + (row + 0.5) * dy });
    const free = [];
    for (let row = 0; row < GRID[1]; row++) {
      const { y } = at(0, row), crossed = [];
      outline.forEach((q, k) => {
        const p = outline[k - 1];
        if (p && q && (p[1] > y) !== (q[1] > y)) crossed.push(p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]));
      });
      for (let column = 0, along = 0; column < GRID[0]; column++) {
        const { x } = at(column, row), isInside = crossed.filter((other) => other < x).length % 2 === 1;
        const isFree = isInside && !boxes.some((box) => Math.abs(box.x - x) < box.half[0] && Math.abs(box.y - y) < box.half[1]);
        along += Number(isFree);
        sums[(row + 1) * (GRID[0] + 1) + column + 1] = sums[row * (GRID[0] + 1) + column + 1] + along;
        if (isFree) free.push([column, row]);
      }
    }
    const fits = ([column, row], size) => {
      const [across, down] = [size * half[0] / dx, size * half[1] / dy];
      const [a, b] = [Math.floor(column + 0.5 - across), Math.ceil(column + 0.5 + across)], [c, d] = [Math.floor(row + 0.5 - down), Math.ceil(row + 0.5 + down)];
      if (a < 0 || c < 0 || b > GRID[0] || d > GRID[1]) return false;
      const sum = (column, row) => sums[row * (GRID[0] + 1) + column];
      return sum(b, d) - sum(a, d) - sum(b, c) + sum(a, c) === (b - a) * (d - c);
    };
    let room = 0, best = free[0];
    for (const place of free) {
      while (fits(place, room + FINER)) [room, best] = [room + FINER, place];
    }
    return best && { ...at(...best), room };
  }
}

/** Names that are put into a frame one after the other, off some boxes and each other. */
class Names {
  constructor(plane, frame, boxes) {
    Object.assign(this, { plane, frame, boxes: [...boxes], size: NAMES[Number(frame.width >= ROOMY)] });
  }

  /** All of them; those of domains that are named are added. */
  all(named) {
    return this.landmarks() + this.edge() + this.domains(named);
  }

  /** Discs of landmarks, with names where these have room: next to each other S and J share one. */
  landmarks() {
    let svg = "";
    const { frame, boxes, size } = this, seen = this.plane.landmarks.filter(([, at]) => frame.holds(frame.at(at)));
    const place = (name) => seen.find(([of]) => of === name)?.[1];
    const [s, j] = ["S", "J"].map((name) => place(name) && frame.at(place(name)));
    const areClose = s && j && Math.hypot(s[0] - j[0], s[1] - j[1]) < 2 * size;
    seen.forEach(([, at]) => {
      const [x, y] = frame.at(at);
      svg += `<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="4.5" fill="${INK}" stroke="#ffffff"/>`;
      boxes.push({ x, y, half: [5, 5] });
    });
    for (const [name, at, away] of seen) {
      if (areClose && name === "J") continue;
      const text = areClose && name === "S" ? "S, J" : name, [x, y] = frame.at(at), half = [wide(text, size) / 2, 0.6 * size];
      const spots = [1, 1.8].flatMap((far) => [[1, 1], [1, -1], [-1, 1], [-1, -1]].map(([across, up]) => {
        const [dx, dy] = [across * far * away[0], up * far * away[1]];
        return { x: x + dx * size + Math.sign(dx) * (half[0] - size / 2), y: y + dy * size, half };
      }));
      const spot = spots.find((box) => this.isFree(box));
      if (!spot) continue;
      boxes.push(spot);
      svg += label(text, spot.x, spot.y, { size, halo: true });
    }
    return svg;
  }

  /** Names of domains, where these have most room, else beside them with a line unless they are named elsewhere; those that are named are added. */
  domains(named) {
    const { plane, frame, boxes, size } = this, grid = new Grid(frame), known = new Set(named);
    let svg = "";
    for (const [of, text] of plane.domains.filter(([of]) => of !== "domain-r")) {
      const half = [wide(text, size) / 2, 0.7 * size], best = grid.roomiest(plane.points(of).map((point) => point && frame.at(point)), boxes, half);
      if (!best || best.room < INSIDE && known.has(of)) continue;
      let spot = { x: best.x, y: best.y, half };
      if (best.room < INSIDE) {
        const turns = [36, 50, 70, 95, 120].flatMap((far) => Array.from({ length: 24 }, (_, k) => [far * Math.cos(k * Math.PI / 12), far * Math.sin(k * Math.PI / 12)]));
        const spots = turns.map(([dx, dy]) => ({ x: best.x + dx, y: best.y + dy, half }));
        spot = spots.find((box) => this.isFree(box));
        if (!spot) continue;
        svg += stroke(`M${best.x.toFixed(1)} ${best.y.toFixed(1)}L${spot.x.toFixed(1)} ${spot.y.toFixed(1)}`, INK, 1);
      }
      boxes.push(spot);
      named.add(of);
      svg += label(text, spot.x, spot.y, { size, halo: true });
    }
    return svg;
  }

  /** Overturning is the edge of unlimited friction, and has its name beside the middle of what is seen of it. */
  edge() {
    const { plane, frame, boxes, size } = this, [, text] = plane.domains.find(([of]) => of === "domain-r"), half = [wide(text, size) / 2, 0.7 * size];
    const seen = plane.plane === "opening-thickness" ? [] : plane.points("domain-r").filter((point) => point && frame.holds(frame.at(point)));
    const middle = seen.length / 2, order = seen.map((_, k) => k).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
    const spot = order.map((k) => frame.at(seen[k])).map(([x, y]) => plane.isFriction(0) ? { x: x - half[0] - 8, y, half } : { x, y: y + 16, half })
      .find((box) => this.isFree(box));
    if (!spot) return "";
    boxes.push(spot);
    return label(text, spot.x, spot.y, { size, halo: true });
  }

  /** Whether a text has room in the frame, off what has its place. */
  isFree(box) {
    const isWithin = [-1, 1].every((side) => this.frame.holds([box.x + side * box.half[0], box.y + side * box.half[1]]));
    return isWithin && this.boxes.every((other) => !overlap(box, other));
  }
}
