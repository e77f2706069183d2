// A plane of the map, drawn anew at any size and for any part of it: around its domains and lines axes, values, names
// and, where it shows more, insets.

const GUIDE = "#999999", CROSS = "#b3261e";
/** The width of a line between domains, and the rounding of a place in the whole plane, in its widths. */
const LINE = 2, ROUNDED = 1e-6;
/** An inset has this part of the frame, and shows a part at least so much larger. */
const INSET = 0.34, LARGER = 2;

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
    const left = 68, isRoomy = width >= ROOMY, right = hasRight ? (isRoomy ? 68 : 36) : 50, top = hasTop ? 48 : 34, below = 46;
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
    this.around.innerHTML = stroke(frame.outline(), INK, 1.4) + this.axes(frame, hasTop, hasRight, isRoomy);
    const values = Plane.hasLevels ? this.values(frame, hasTop, hasRight) : { svg: "", taken: [] };
    const guides = insets.map(({ part, frame: to }) => this.guide(frame, part, to)).join("");
    this.over.innerHTML = values.svg + guides + new Names(this, frame, [...taken, ...values.taken]).all(this.drawnIn(insets)) + this.marked(frame);
    this.cross();
  }

  /** Domains whose names stand in an inset. */
  drawnIn(insets) {
    const named = new Set();
    for (const { frame, larger } of insets) {
      larger.around.innerHTML = stroke(frame.outline()) + this.inner(frame) + new Names(this, frame, []).all(named);
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

  axes(frame, hasTop, hasRight, hasRoom) {
    const { left, right, top, bottom, width, height } = frame, [across, up] = this.labels, middle = [left + width / 2, top + height / 2];
    const bottomTicks = ticks(frame.view[0], Math.min(10, Math.max(3, width / 50))), leftTicks = ticks(frame.view[1], Math.max(3, height / 45));
    let svg = this.scale(frame, bottomTicks, ([x]) => [x, bottom, 0, -5, 0, 14]) + this.scale(frame, leftTicks, ([, y]) => [left, y, 5, 0, -6, 0]);
    svg += label(across, middle[0], bottom + 35, { size: 14 }) + label(up, 11, middle[1], { size: 14, turn: -90 });
    const coefficient = "friction coefficient μ = tan φ";
    if (hasTop) svg += this.scale(frame, frictionTicks(frame.view[0], width), ([x]) => [x, top, 0, 5, 0, -13]) + label(coefficient, middle[0], 12, { size: 14 });
    if (hasRight) svg += this.scale(frame, frictionTicks(frame.view[1], height), ([, y]) => [right, y, -5, 0, 6, 0]) + (hasRoom ? label(coefficient, right + 57, middle[1], { size: 14, turn: -90 }) : "");
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
    for (const [side, found] of Object.entries(ends)) {
      const isRight = side === "right", isWithin = isRight ? hasRight : hasTop, [low, high] = isRight ? [frame.top, frame.bottom] : [frame.left, frame.right];
      const gap = isRight ? 15 : Math.max(0, ...found.map(({ text }) => wide(text, TICK))) + 2;
      // Of more than have room some have no value.
      const each = Math.ceil(found.length * gap / (high - low)), all = found.sort((a, b) => a.place - b.place).filter((_, k) => k % each === 0);
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

  /** The arches that the program marked, with their numbers. */
  marked(frame) {
    return this.marks.map(([at, given, isBox], k) => {
      if (isBox) return this.box(frame, at, given, k + 1);
      const [x, y] = frame.at(at);
      if (!frame.holds([x, y])) return "";
      const end = given && frame.at(given), whisker = end ? stroke(`M${x} ${y}V${Math.max(frame.top, Math.min(frame.bottom, end[1]))}`, INK, 1.4) : "";
      return `<g>${whisker}<circle cx="${x}" cy="${y}" r="9" fill="#ffffff" stroke="${INK}" stroke-width="1.4"/>${label(k + 1, x, y, { size: 12 })}</g>`;
    }).join("");
  }

  /** The box of a range, as far as a frame shows it, with its number beside it. */
  box(frame, first, last, number) {
    const [x, y] = [0, 1].map((k) => [first[k], last[k]].sort((a, b) => a - b));
    const [low, high] = [0, 1].map((k) => [x, y].map((ends, axis) => k
      ? Math.min(ends[1], frame.view[axis][1]) : Math.max(ends[0], frame.view[axis][0])));
    if (low[0] > high[0] || low[1] > high[1]) return "";
    const [left, bottom] = frame.at(low), [right, top] = frame.at(high), middle = (top + bottom) / 2;
    const at = frame.holds([right + 24, middle]) ? right + 12 : left - 12;
    return `<g><rect x="${left}" y="${top}" width="${right - left}" height="${bottom - top}" fill="${INK}" fill-opacity="0.16" stroke="${INK}" stroke-width="1.4"/>`
      + `<circle cx="${at}" cy="${middle}" r="9" fill="#ffffff" stroke="${INK}" stroke-width="1.4"/>${label(number, at, middle, { size: 12 })}</g>`;
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

  /** The shortest ranges that are shown: there what is proved of a line is as wide as the line. */
  least() {
    const { width, height } = this.frames.at(-1);
    return this.off.map((off, k) => (off + ROUNDED * (this.ranges[k][1] - this.ranges[k][0])) * [width, height][k] / LINE);
  }

  /** Shows another part, as large as this one times a factor, with a place of it kept or moved. */
  look(factor, place, [dx, dy] = [0, 0]) {
    const frame = this.frames.at(-1), kept = frame.of(place), least = this.least();
    const far = Math.max(...this.view.map(([low, high], k) => (high - low) / (this.ranges[k][1] - this.ranges[k][0])));
    const near = Math.max(...this.view.map(([low, high], k) => least[k] / (high - low)));
    const ratio = Math.min(1 / far, Math.max(factor, Math.min(1, near)));
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
