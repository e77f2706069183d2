// What a plane is drawn with: strokes and texts, the frame that shows a part of it, and the domains and lines that the
// program drew, moved and stretched into a frame as the curves that they are.

const SVG = "http://www.w3.org/2000/svg";
const INK = "#222222";
/** The size of a font. */
const TICK = 13;

/** The width of a text, amply. */
const wide = (text, size) => size * [...text].reduce((sum, letter) => sum + (/[[\],.lr ]/.test(letter) ? 0.42 : 0.66), 0);
const stroke = (d, color = INK, width = 1.2) => `<path d="${d}" fill="none" stroke="${color}" stroke-width="${width}"/>`;

/** A text whose middle or one of whose ends is at a place, on white if it stands among lines. */
function label(text, x, y, { size = TICK, anchor = "middle", halo = false, turn = 0 } = {}) {
  const ground = halo ? ' paint-order="stroke" stroke="#ffffff" stroke-width="4"' : "", turned = turn ? ` transform="rotate(${turn} ${x} ${y})"` : "";
  return `<text x="${x.toFixed(2)}" y="${(y + 0.36 * size).toFixed(2)}" font-size="${size}" fill="${INK}" text-anchor="${anchor}"${ground}${turned}>${text}</text>`;
}

/** Whether two boxes, each a middle and halves of its width and height, lie over each other. */
const overlap = (a, b) => Math.abs(a.x - b.x) < a.half[0] + b.half[0] && Math.abs(a.y - b.y) < a.half[1] + b.half[1];

/** A number in steps of what a pixel shows of a range, strictly above zero. */
function stepped(value, [from, to], pixels) {
  const decimals = Math.max(0, Math.ceil(-Math.log10((to - from) / pixels)));
  return Math.min(Math.max(value, 10 ** -decimals), to).toFixed(decimals);
}

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
