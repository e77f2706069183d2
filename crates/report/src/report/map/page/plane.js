// A plane of the map, drawn anew at any size and for any part of it: the domains and lines that the program drew, moved
// and stretched as the curves that they are, and around them axes, values, names and, where it shows more, insets.

const SVG = "http://www.w3.org/2000/svg";
const INK = "#222222", GUIDE = "#999999", CROSS = "#b3261e";
/** Sizes of fonts, the width of a line between domains, the rounding of a place in the whole plane, in its widths. */
const TICK = 13, NAMES = [13, 15], LINE = 2, ROUNDED = 1e-6;
/** An inset has this part of the frame, and shows a part at least so much larger, in frames at least so wide. */
const INSET = 0.34, LARGER = 2, ROOMY = 500;
/** Places that are looked at for the name of a domain, across and down, and the steps in which its room is measured. */
const GRID = [60, 50], FINER = 0.05;
/** The part of its ample size for which a name has to have room in its domain. */
const INSIDE = 0.7;

/** The width of a text, amply. */
const wide = (text, size) => size * [...text].reduce((sum, letter) => sum + (/[[\],.lr ]/.test(letter) ? 0.42 : 0.66), 0);
const stroke = (d, color = INK, width = 1.2) => `<path d="${d}" fill="none" stroke="${color}" stroke-width="${width}"/>`;
function label(text, x, y, { size = TICK, anchor = "middle", halo = false, turn = 0 } = {}) {
  const ground = halo ? ' paint-order="stroke" stroke="#ffffff" stroke-width="4"' : "", turned = turn ? ` transform="rotate(${turn} ${x} ${y})"` : "";
  return `<text x="${x.toFixed(2)}" y="${(y + 0.36 * size).toFixed(2)}" font-size="${size}" fill="${INK}" text-anchor="${anchor}"${ground}${turned}>${text}</text>`;
}
const nameSize = (frame) => NAMES[Number(frame.width >= ROOMY)];
const overlap = (a, b) => Math.abs(a.x - b.x) < a.half[0] + b.half[0] && Math.abs(a.y - b.y) < a.half[1] + b.half[1];

/** A rectangle of the picture, and the part of a plane that it shows: the ranges along both axes. */
class Frame {
  constructor(left, top, width, height, view) {
    Object.assign(this, { left, top, width, height, view, right: left + width, bottom: top + height });
  }

  at([x, y]) {
    const [[x0, x1], [y0, y1]] = this.view;
    return [this.left + (x - x0) / (x1 - x0) * this.width, this.bottom - (y - y0) / (y1 - y0) * this.height];
  }

  /** What lies at a place of the picture. */
  of([x, y]) {
    const [[x0, x1], [y0, y1]] = this.view;
    return [x0 + (x - this.left) / this.width * (x1 - x0), y0 + (this.bottom - y) / this.height * (y1 - y0)];
  }

  holds([x, y]) {
    return x >= this.left && x <= this.right && y >= this.top && y <= this.bottom;
  }

  outline() {
    return `M${this.left} ${this.top}H${this.right}V${this.bottom}H${this.left}Z`;
  }

  /** The box that it takes, with the labels of its ticks. */
  box() {
    return { x: (this.left + this.right) / 2 - 20, y: (this.top + this.bottom) / 2 + 10, half: [this.width / 2 + 28, this.height / 2 + 18] };
  }
}

/** The domains and lines in one frame: paths as letters and numbers, in parts of the whole plane from its upper left. */
class Layer {
  constructor(parent, groups, [width, height], id) {
    const clip = document.createElementNS(SVG, "clipPath");
    clip.id = `${id}-clip`;
    this.window = clip.appendChild(document.createElementNS(SVG, "path"));
    this.group = document.createElementNS(SVG, "g");
    this.group.setAttribute("clip-path", `url(#${clip.id})`);
    this.group.append(...groups);
    parent.append(clip, this.group);
    this.paths = [...this.group.querySelectorAll("g > path")].map((element) => {
      let isAcross = false;
      const tokens = element.getAttribute("d").match(/[MLCZ]|-?[\d.]+/g).map((token) => {
        if (/[A-Z]/.test(token)) return token;
        isAcross = !isAcross;
        return Number(token) / (isAcross ? width : height);
      });
      return { element, tokens, of: element.parentElement.dataset.of };
    });
  }

  /** Draws them in a frame, of which the whole plane has these ranges. */
  place(frame, [[x0, x1], [y0, y1]]) {
    const [left, top] = frame.at([x0, y1]), [right, bottom] = frame.at([x1, y0]);
    this.window.setAttribute("d", frame.outline());
    for (const { element, tokens } of this.paths) {
      let d = "", isAcross = false;
      for (const token of tokens) {
        if (typeof token === "string") d += token;
        else d += ((isAcross = !isAcross) ? left + token * (right - left) : top + token * (bottom - top)).toFixed(2) + " ";
      }
      element.setAttribute("d", d);
    }
  }
}

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

class Plane {
  constructor(figure) {
    this.figure = figure;
    Object.assign(this, figure.dataset, JSON.parse(figure.dataset.around));
    // { weight, plane; labels, ranges, off, landmarks, insets, domains, levels, levels_label, marks } are the program's.
    this.view = this.ranges;
    this.known = new Map();
    this.svg = figure.querySelector("svg");
    const { width, height } = this.svg.viewBox.baseVal, id = `${this.weight}-${this.plane}`;
    const groups = [...this.svg.querySelectorAll("g[id]")];
    for (const group of groups) group.dataset.of = group.id.slice(id.length + 1);
    this.svg.id = id;
    this.svg.setAttribute("aria-label", `${this.svg.querySelector("title").textContent}: arrow keys move the cross, + and - bring it closer, 0 shows all`);
    this.svg.setAttribute("role", "application");
    this.svg.setAttribute("tabindex", "0");
    const copies = this.insets.map(() => groups.map((group) => {
      const copy = group.cloneNode(true);
      copy.removeAttribute("id");
      copy.querySelectorAll("pattern").forEach((pattern) => pattern.remove());
      return copy;
    }));
    this.svg.replaceChildren();
    this.ground = this.part("rect");
    this.main = new Layer(this.svg, groups, [width, height], id);
    this.around = this.part("g");
    this.larger = copies.map((copy, k) => {
      const all = this.part("g");
      const ground = all.appendChild(document.createElementNS(SVG, "rect"));
      const layer = new Layer(all, copy, [width, height], `${id}-${k}`);
      return { all, ground, layer, around: all.appendChild(document.createElementNS(SVG, "g")) };
    });
    this.over = this.part("g");
    this.crosses = this.part("g");
  }

  part(tag) {
    return this.svg.appendChild(document.createElementNS(SVG, tag));
  }

  isWhole() {
    return this.view === this.ranges;
  }

  isFriction(axis) {
    return this.labels[axis].startsWith("friction");
  }

  /** Draws all of it, as wide as its figure. */
  draw() {
    const width = this.figure.clientWidth;
    if (!width) return;
    const [hasTop, hasRight] = [this.isFriction(0), this.isFriction(1)];
    const left = 68, right = hasRight ? 68 : 50, top = hasTop ? 48 : 34, below = 46;
    const high = Math.round(Math.min(0.8 * (width - left - right), 0.8 * innerHeight));
    const frame = new Frame(left, top, width - left - right, high, this.view), height = top + high + below;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("width", width);
    this.svg.setAttribute("height", height);
    Object.entries({ width, height, fill: "#ffffff" }).forEach((pair) => this.ground.setAttribute(...pair));
    this.main.place(frame, this.ranges);
    for (const { element, of } of [...this.main.paths, ...this.larger.flatMap(({ layer }) => layer.paths)]) {
      element.parentElement.setAttribute("display", of.startsWith("level-") && !Plane.hasLevels ? "none" : "inline");
    }
    const insets = this.placeInsets(frame);
    this.frames = [...insets.map(({ frame }) => frame), frame];
    const taken = insets.map(({ frame }) => frame.box());
    this.around.innerHTML = stroke(frame.outline(), INK, 1.4) + this.axes(frame, hasTop, hasRight);
    const values = Plane.hasLevels ? this.values(frame, hasTop, hasRight) : { svg: "", taken: [] };
    const guides = insets.map(({ part, frame: to }) => this.guide(frame, part, to)).join("");
    this.over.innerHTML = values.svg + guides + this.names(frame, [...taken, ...values.taken], this.drawnIn(insets)) + this.marked(frame);
    this.cross();
  }

  /** Domains whose names stand in an inset. */
  drawnIn(insets) {
    const named = new Set();
    for (const { frame, larger } of insets) {
      larger.around.innerHTML = stroke(frame.outline()) + this.inner(frame) + this.names(frame, [], named, named);
    }
    return named;
  }

  /** The ticks of an inset. */
  inner(frame) {
    const across = ticks(frame.view[0], 4), up = ticks(frame.view[1], 4);
    return this.scale(frame, across, ([x]) => [x, frame.bottom, 0, -5, 0, 12]) + this.scale(frame, up, ([, y]) => [frame.left, y, 5, 0, -6, 0]);
  }

  /** Ticks at places of an axis, each with its stroke and its text. */
  scale(frame, all, at) {
    return all.map(([value, text]) => {
      const [x, y, dx, dy, tx, ty] = at(frame.at([value, value]));
      return stroke(`M${x.toFixed(2)} ${y.toFixed(2)}l${dx} ${dy}`) + label(text, x + tx, y + ty, { anchor: tx < 0 ? "end" : tx > 0 ? "start" : "middle" });
    }).join("");
  }

  axes(frame, hasTop, hasRight) {
    const { left, right, top, bottom, width, height } = frame, [across, up] = this.labels, middle = [left + width / 2, top + height / 2];
    const bottomTicks = ticks(frame.view[0], Math.min(10, Math.max(3, width / 50))), leftTicks = ticks(frame.view[1], Math.max(3, height / 45));
    let svg = this.scale(frame, bottomTicks, ([x]) => [x, bottom, 0, -5, 0, 14]) + this.scale(frame, leftTicks, ([, y]) => [left, y, 5, 0, -6, 0]);
    svg += label(across, middle[0], bottom + 35, { size: 14 }) + label(up, 11, middle[1], { size: 14, turn: -90 });
    const coefficient = "friction coefficient μ = tan φ";
    if (hasTop) svg += this.scale(frame, frictionTicks(frame.view[0], width), ([x]) => [x, top, 0, 5, 0, -13]) + label(coefficient, middle[0], 12, { size: 14 });
    if (hasRight) svg += this.scale(frame, frictionTicks(frame.view[1], height), ([, y]) => [right, y, -5, 0, 6, 0]) + label(coefficient, right + 57, middle[1], { size: 14, turn: -90 });
    return svg;
  }

  /** Insets that show a part of what is seen larger, in a corner where they do not cover it. */
  placeInsets(frame) {
    const shown = [];
    this.insets.forEach((part, k) => {
      const larger = this.larger[k], [low, high] = [0, 1].map((end) => frame.at(part.map((range) => range[end])));
      const size = [INSET * frame.width, INSET * frame.height], covered = [high[0] - low[0], low[1] - high[1]];
      const isSeen = frame.holds(low) && frame.holds(high) && frame.width >= ROOMY && covered.every((length, k) => LARGER * length <= size[k]);
      const of = { x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2, half: covered.map((length) => length / 2 + 12) };
      const corners = isSeen ? [[0, 0], [0, 1], [1, 0], [1, 1]].map(([across, up]) => new Frame(
        across ? frame.right - size[0] - 14 : frame.left + 56, up ? frame.bottom - size[1] - 34 : frame.top + 24, ...size, part)) : [];
      const at = corners.find((corner) => [of, ...shown.map((one) => one.frame.box())].every((box) => !overlap(corner.box(), box)));
      larger.all.setAttribute("display", at ? "inline" : "none");
      if (!at) return;
      const { x, y, half } = at.box();
      Object.entries({ x: x - half[0], y: y - half[1], width: 2 * half[0], height: 2 * half[1], fill: "#ffffff" }).forEach((pair) => larger.ground.setAttribute(...pair));
      larger.layer.place(at, this.ranges);
      shown.push({ part, frame: at, larger });
    });
    return shown;
  }

  /** The part that an inset shows, and a line to it from the nearest corner. */
  guide(frame, part, to) {
    const [left, bottom] = frame.at(part.map(([low]) => low)), [right, top] = frame.at(part.map(([, high]) => high));
    const [x, y] = [left > to.right ? left : right, top > to.bottom ? top : bottom], [tx, ty] = [left > to.right ? to.right : to.left, top > to.bottom ? to.bottom : to.top];
    return stroke(`M${x} ${y}L${tx} ${ty}`, GUIDE, 1) + stroke(`M${left} ${top}H${right}V${bottom}H${left}Z`, INK, 1);
  }

  /** Values of levels where these leave the frame, by its right or its upper edge; within it if an axis is there. */
  values(frame, hasTop, hasRight) {
    const ends = { right: [], top: [] };
    for (const [id, text] of this.levels) {
      const end = this.leaves(id, frame, hasTop ? ["right", "top"] : ["top", "right"]);
      if (end) ends[end.side].push({ place: end.place, text });
    }
    const taken = [];
    let svg = "";
    for (const [side, all] of Object.entries(ends)) {
      all.sort((a, b) => a.place - b.place);
      const isRight = side === "right", isWithin = isRight ? hasRight : hasTop, [low, high] = isRight ? [frame.top, frame.bottom] : [frame.left, frame.right];
      const gap = isRight ? 15 : Math.max(0, ...all.map(({ text }) => wide(text, TICK))) + 2;
      const room = isWithin || !isRight ? gap / 2 : 0, moved = spread(all.map(({ place }) => place), gap, low + room, high - room);
      all.forEach(({ place, text }, k) => {
        const off = isWithin ? -12 : 14, half = wide(text, TICK) / 2;
        const [x, y] = isRight ? [frame.right + off, moved[k]] : [moved[k], frame.top - off];
        if (isWithin) taken.push({ x, y, half: [half, 8] });
        else svg += stroke(isRight ? `M${frame.right} ${place}L${x - 3} ${y}` : `M${place} ${frame.top}L${x} ${y + 7}`, GUIDE, 1);
        svg += label(text, x, y - (isRight || isWithin ? 0 : 2), { anchor: isRight ? (isWithin ? "end" : "start") : "middle", halo: isWithin });
      });
    }
    return { svg, taken };
  }

  /** Where a level leaves the frame for the last time, by the first of two edges where it does. */
  leaves(id, frame, sides) {
    const points = this.points(id).map((point) => point && frame.at(point)), near = 1e-6 * frame.width;
    for (const side of sides) {
      const [edge, axis] = side === "right" ? [frame.right, 0] : [frame.top, 1];
      for (let k = points.length - 1; k > 0; k--) {
        const [a, b] = [points[k - 1], points[k]];
        if (!a || !b || (a[axis] - edge) * (b[axis] - edge) > 0 && Math.abs(b[axis] - edge) > near) continue;
        const share = a[axis] === b[axis] ? 1 : Math.min(1, Math.max(0, (edge - a[axis]) / (b[axis] - a[axis]))), other = 1 - axis;
        const place = a[other] + share * (b[other] - a[other]);
        const [low, high] = axis === 0 ? [frame.top, frame.bottom] : [frame.left, frame.right];
        if (place >= low && place <= high) return { side, place };
      }
    }
    return null;
  }

  /** Points along the paths of a group, in the units of the axes, with nothing before each piece. */
  points(id) {
    if (this.known.has(id)) return this.known.get(id);
    const [[x0, x1], [y0, y1]] = this.ranges, found = [];
    for (const { tokens } of this.main.paths.filter(({ of }) => of === id)) {
      let letter = "", numbers = [], pen = null, start = 0;
      for (const token of tokens) {
        if (typeof token === "string") {
          letter = token;
          if (letter === "M") start = found.push(null);
          if (letter === "Z") found.push(found[start]);
          continue;
        }
        numbers.push(token);
        if (numbers.length < (letter === "C" ? 6 : 2)) continue;
        const [a, b, c] = [numbers.slice(0, 2), numbers.slice(2, 4), numbers.slice(4)];
        const along = (t) => [0, 1].map((k) => (1 - t) ** 3 * pen[k] + 3 * (1 - t) ** 2 * t * a[k] + 3 * (1 - t) * t * t * b[k] + t ** 3 * c[k]);
        const more = letter === "C" ? [along(0.25), along(0.5), along(0.75), c] : [a];
        found.push(...more.map(([u, v]) => [x0 + u * (x1 - x0), y1 - v * (y1 - y0)]));
        [pen, numbers] = [more.at(-1), []];
      }
    }
    this.known.set(id, found);
    return found;
  }

  /** Discs and names of landmarks, and the names of domains: where there is most room, else beside the domain with a line. */
  names(frame, taken, known, named = new Set()) {
    let svg = "";
    const seen = this.landmarks.filter(([, at]) => frame.holds(frame.at(at))), boxes = [...taken];
    const place = (name) => seen.find(([of]) => of === name)?.[1];
    const [s, j] = ["S", "J"].map((name) => place(name) && frame.at(place(name)));
    const size = nameSize(frame), areClose = s && j && Math.hypot(s[0] - j[0], s[1] - j[1]) < 2 * size;
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
      const spot = spots.find((box) => this.isFree(frame, box, boxes));
      if (!spot) continue;
      boxes.push(spot);
      svg += label(text, spot.x, spot.y, { size, halo: true });
    }
    return svg + this.domainNames(frame, boxes, known, named);
  }

  domainNames(frame, boxes, known, named) {
    const size = nameSize(frame), grid = new Grid(frame);
    let svg = this.edgeName(frame, size, boxes);
    for (const [of, text] of this.domains.filter(([of]) => of !== "domain-r")) {
      const half = [wide(text, size) / 2, 0.7 * size], best = grid.roomiest(this.points(of).map((point) => point && frame.at(point)), boxes, half);
      if (!best || best.room < INSIDE && known.has(of)) continue;
      let spot = { x: best.x, y: best.y, half };
      if (best.room < INSIDE) {
        const turns = [36, 50, 70, 95, 120].flatMap((far) => Array.from({ length: 24 }, (_, k) => [far * Math.cos(k * Math.PI / 12), far * Math.sin(k * Math.PI / 12)]));
        const spots = turns.map(([dx, dy]) => ({ x: best.x + dx, y: best.y + dy, half }));
        spot = spots.find((box) => this.isFree(frame, box, boxes));
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
  edgeName(frame, size, boxes) {
    const [, text] = this.domains.find(([of]) => of === "domain-r"), half = [wide(text, size) / 2, 0.7 * size];
    const seen = this.plane === "opening-thickness" ? [] : this.points("domain-r").filter((point) => point && frame.holds(frame.at(point)));
    const middle = seen.length / 2, order = seen.map((_, k) => k).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
    const spot = order.map((k) => frame.at(seen[k])).map(([x, y]) => this.isFriction(0) ? { x: x - half[0] - 8, y, half } : { x, y: y + 16, half })
      .find((box) => this.isFree(frame, box, boxes));
    if (!spot) return "";
    boxes.push(spot);
    return label(text, spot.x, spot.y, { size, halo: true });
  }

  /** Whether a text has room in a frame, off what has its place. */
  isFree(frame, box, boxes) {
    const isWithin = [-1, 1].every((side) => frame.holds([box.x + side * box.half[0], box.y + side * box.half[1]]));
    return isWithin && boxes.every((other) => !overlap(box, other));
  }

  /** The arches that the program marked, with their numbers. */
  marked(frame) {
    return this.marks.map(([at, given], k) => {
      const [x, y] = frame.at(at);
      if (!frame.holds([x, y])) return "";
      const end = given && frame.at(given), whisker = end ? stroke(`M${x} ${y}V${Math.max(frame.top, Math.min(frame.bottom, end[1]))}`, INK, 1.4) : "";
      return `<g>${whisker}<circle cx="${x}" cy="${y}" r="9" fill="#ffffff" stroke="${INK}" stroke-width="1.4"/>${label(k + 1, x, y, { size: 12 })}</g>`;
    }).join("");
  }

  /** Shows an arch with a cross in every frame that has its place. */
  cross(arch = this.arch) {
    this.arch = arch;
    if (!this.frames) return;
    const at = arch && this.placeOf(arch);
    this.crosses.innerHTML = at ? this.frames.filter((frame) => frame.holds(frame.at(at))).map((frame) => {
      const [x, y] = frame.at(at);
      return `<path class="cross" d="M${x - 9} ${y}H${x + 9}M${x} ${y - 9}V${y + 9}" fill="none" stroke="${CROSS}" stroke-width="2"/>`;
    }).join("") : "";
  }

  /** The place of an arch in the units of the axes. */
  placeOf({ halfOpening, phi, eta }) {
    const all = { half: halfOpening / DEGREE, friction: phi / DEGREE, thickness: eta };
    return this.labels.map((label) => all[label.split(" ")[0]]);
  }

  /** What is asked at a place of a frame, rounded to a pixel of it. */
  given(frame, values) {
    const given = { weight: this.weight };
    this.labels.forEach((label, k) => {
      const range = frame.view[k], text = stepped(values[k], range, k ? frame.height : frame.width);
      if (label.startsWith("half")) given.half_opening = `${text}deg`;
      else if (label.startsWith("thickness")) given.thickness = text;
      else if (Number(text) >= 90) given.friction = "inf";
      else given.friction_angle = `${text}deg`;
    });
    return given;
  }

  /** From the page to the drawing. */
  on({ clientX, clientY }) {
    const { left, top } = this.svg.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** Shows another part, as large as this one times a factor, with a place of it kept or moved. */
  look(factor, place, [dx, dy] = [0, 0]) {
    const frame = this.frames.at(-1), kept = frame.of(place), size = this.ranges.map(([low, high]) => high - low);
    // Nowhere closer than where what is proved of a line is as wide as the line.
    const pixels = [frame.width, frame.height], off = this.off.map((off, k) => (off / size[k] + ROUNDED) * pixels[k]);
    const shares = this.view.map(([low, high], k) => (high - low) / size[k]);
    const ratio = Math.min(1 / Math.max(...shares), Math.max(factor, Math.min(1, Math.max(...off) / LINE / Math.max(...shares))));
    const moved = [dx / frame.width, -dy / frame.height];
    this.show(this.view.map(([low, high], k) => {
      const length = (high - low) * ratio, start = kept[k] - (kept[k] - low) * ratio - moved[k] * length, [first, last] = this.ranges[k];
      const from = Math.min(Math.max(start, first), last - length);
      return [from, from + length];
    }));
  }

  /** Shows a part, or all. */
  show(view) {
    const isWhole = view.every(([low, high], k) => low <= this.ranges[k][0] + 1e-9 && high >= this.ranges[k][1] - 1e-9);
    this.view = isWhole ? this.ranges : view;
    this.draw();
  }

  middle() {
    const { left, top, width, height } = this.frames.at(-1);
    return [left + width / 2, top + height / 2];
  }
}
Plane.hasLevels = true;

/** A number in steps of what a pixel shows of a range, strictly above zero. */
function stepped(value, [from, to], pixels) {
  const decimals = Math.max(0, Math.ceil(-Math.log10((to - from) / pixels)));
  return Math.min(Math.max(value, 10 ** -decimals), to).toFixed(decimals);
}
