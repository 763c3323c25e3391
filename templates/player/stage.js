// The sheet: figures arranged for the shape of the window, and a camera that zooms and moves over them.
const one = (selector, root = document) => root.querySelector(selector);
const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const paper = one("#paper"), board = one("#board");
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const GAP = 700; // units of 0.01 mm between figures
const ZOOM = 1.6; // a small figure is shown so much larger beside a large one
const LARGEST = 0.065; // pixels a unit: larger, no figure is shown unasked

const stage = {
  camera: { x: 0, y: 0, w: 1000, h: 1000 },
  aim: null,
  spots: new Map(), // key of a figure → its box on the sheet
  whole: { x: 0, y: 0, w: 1000, h: 1000 },

  size() {
    return { w: Math.max(paper.clientWidth, 1), h: Math.max(paper.clientHeight, 1) };
  },

  narrow: () => matchMedia("(max-width: 47.5em), (max-aspect-ratio: 1/1)").matches,

  // Rows or columns of figures, in order: whichever fills most of this window; what is followed has whatever frame does so best.
  arrange(figures) {
    const cells = figures.some(({ polygon }) => polygon) && player.turning() && player.view === "auto" ? stage.cells(figures) : [null];
    let best = null;
    for (const cell of cells) {
      stage.sized(figures, cell);
      const found = stage.shelved(figures, cell);
      if (!best || found.filled > best.filled * 1.001) best = found;
    }
    stage.sized(figures, best.cell);
    stage.spots = new Map();
    for (const { figure, x, y } of best.places) {
      figure.node.setAttribute("transform", `translate(${Math.round(x - figure.zoom * figure.box[0])} ${Math.round(y - figure.zoom * figure.box[1])}) scale(${figure.zoom.toFixed(4)})`);
      figure.node.style.setProperty("--bold", ((player.turning() ? Math.sqrt(turn.data.figures[0].size) : 1) / Math.sqrt(figure.zoom)).toFixed(3));
      stage.spots.set(figure.key, { x, y, w: figure.zoom * figure.box[2], h: figure.zoom * figure.box[3] });
    }
    stage.whole = { x: -GAP / 2, y: -GAP / 2, w: best.w + GAP, h: best.h + GAP };
  },

  // Frames for what is followed, beside a mechanism of this size.
  cells(figures) {
    const side = Math.max(...figures.filter(({ polygon }) => !polygon).map(({ box }) => Math.sqrt(box[2] * box[3])), 6000);
    return [0.6, 0.8, 1, 1.25].flatMap((k) => [0.7, 1, 1.4, 2].map((flat) => ({ w: k * side * Math.sqrt(flat), h: k * side / Math.sqrt(flat) })));
  },

  sized(figures, cell) {
    if (player.turning()) for (const figure of figures) turn.fitted(figure, figure.polygon ? cell : null, stage.narrow() && figures.length > 1);
    const side = ({ box }) => Math.sqrt(box[2] * box[3]), most = Math.max(...figures.map(side));
    for (const figure of figures) figure.zoom = cell || figure.moves === false ? 1 : Math.min(most / side(figure), ZOOM);
  },

  // The shelves that show them largest; how much of the window they fill, a mechanism counting double.
  shelved(figures, cell) {
    const { w, h } = stage.size();
    let best = null;
    for (const across of [true, false]) {
      for (const cut of cuts(figures.length)) {
        const sheet = shelves(figures, cut, across), scale = Math.min(w / sheet.w, h / sheet.h);
        if (!best || scale > best.scale * 1.001) best = { ...sheet, scale, cell };
      }
    }
    const filled = figures.reduce((sum, { box, zoom, polygon }) => sum + (polygon ? 1 : 2) * zoom * zoom * box[2] * box[3], 0);
    return { ...best, filled: filled * best.scale ** 2 };
  },

  // Show these figures, or all, as large as the window allows.
  show(keys, at_once = false) {
    const boxes = keys.map((key) => stage.spots.get(key)).filter(Boolean);
    stage.fly(boxes.length ? hull(boxes) : stage.whole, at_once);
  },

  fly(box, at_once) {
    const { w, h } = stage.size(), right = stage.narrow() ? 0 : 58; // pixels of the zoom buttons
    const scale = Math.min((w - right) / box.w, h / box.h, LARGEST); // pixels a unit
    const to = { x: box.x - ((w - right) / scale - box.w) / 2, y: box.y - (h / scale - box.h) / 2, w: w / scale, h: h / scale };
    cancelAnimationFrame(stage.aim);
    stage.legible(scale);
    if (at_once || calm.matches) return stage.look(to);
    const from = { ...stage.camera }, start = performance.now();
    const move = (now) => {
      const t = Math.min(1, (now - start) / 320), k = eased(t);
      stage.look({ x: from.x + k * (to.x - from.x), y: from.y + k * (to.y - from.y), w: from.w + k * (to.w - from.w), h: from.h + k * (to.h - from.h) });
      if (t < 1) stage.aim = requestAnimationFrame(move);
    };
    stage.aim = requestAnimationFrame(move);
  },

  // Letters as large as they must be at so many pixels a unit.
  legible(scale) {
    if (letters.fit(scale) && player.turning()) turn.draw(player.place);
  },

  look(camera) {
    stage.camera = camera;
    board.setAttribute("viewBox", [camera.x, camera.y, camera.w, camera.h].map((v) => v.toFixed(1)).join(" "));
  },

  // Zoom about a point of the window (0..1 across, 0..1 down).
  zoom(factor, u = 0.5, v = 0.5) {
    cancelAnimationFrame(stage.aim);
    const c = stage.camera, w = Math.min(Math.max(c.w / factor, 600), stage.whole.w * 6), k = w / c.w;
    stage.look({ x: c.x + (1 - k) * u * c.w, y: c.y + (1 - k) * v * c.h, w, h: c.h * k });
    stage.legible(stage.size().w / w);
    player.free();
  },

  // A place in the window as a place on a figure.
  on(figure, x, y) {
    const spot = new DOMPoint(x, y).matrixTransform(figure.node.getScreenCTM().inverse());
    return [Math.round(spot.x), Math.round(spot.y)];
  },

  // Whether a figure can be seen at all.
  seen(key) {
    const b = stage.spots.get(key), c = stage.camera;
    return Boolean(b) && (b.x < c.x + c.w && c.x < b.x + b.w && b.y < c.y + c.h && c.y < b.y + b.h);
  },

  // Move by parts of the window.
  pan(u, v) {
    cancelAnimationFrame(stage.aim);
    const c = stage.camera;
    stage.look({ ...c, x: c.x - u * c.w, y: c.y - v * c.h });
    player.free();
  },
};

// Slow at both ends of a motion; t: 0 to 1.
const eased = (t) => t * t * (3 - 2 * t);

function hull(boxes) {
  const x = Math.min(...boxes.map((b) => b.x)), y = Math.min(...boxes.map((b) => b.y));
  const right = Math.max(...boxes.map((b) => b.x + b.w)), low = Math.max(...boxes.map((b) => b.y + b.h));
  return { x: x - GAP / 2, y: y - GAP / 2, w: right - x + GAP, h: low - y + GAP };
}

// Every way to cut n figures into shelves; beyond 10 figures, shelves of equal numbers.
function cuts(n) {
  if (n > 10) return Array.from({ length: n }, (_, k) => Array.from({ length: Math.ceil(n / (k + 1)) }, (_, i) => Math.min(k + 1, n - i * (k + 1))));
  const found = [];
  for (let bits = 0; bits < 1 << (n - 1); bits++) {
    const cut = [1];
    for (let i = 0; i < n - 1; i++) bits >> i & 1 ? cut.push(1) : cut[cut.length - 1]++;
    found.push(cut);
  }
  return found;
}

function shelves(figures, cut, across) {
  const long = (f) => f.zoom * (across ? f.box[2] : f.box[3]), deep = (f) => f.zoom * (across ? f.box[3] : f.box[2]);
  const groups = [];
  let i = 0, length = 0, depth = 0;
  for (const count of cut) {
    const inside = figures.slice(i, (i += count));
    const group = { inside, length: inside.reduce((sum, f) => sum + long(f), GAP * (count - 1)), depth: Math.max(...inside.map(deep)), at: depth };
    groups.push(group);
    length = Math.max(length, group.length);
    depth += group.depth + GAP;
  }
  const places = [];
  for (const group of groups) {
    let along = (length - group.length) / 2;
    for (const figure of group.inside) {
      const slack = group.depth - deep(figure), aside = group.at + (across ? slack : slack / 2); // titles of a row on one line
      places.push(across ? { figure, x: along, y: aside } : { figure, x: aside, y: along });
      along += long(figure) + GAP;
    }
  }
  return across ? { places, w: length, h: depth - GAP } : { places, w: depth - GAP, h: length };
}

// Mouse, pen and fingers; a press that hardly moves is no pan.
const pointers = new Map(), STILL = 5;
const spread = () => {
  const [a, b] = [...pointers.values()];
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, d: Math.hypot(a.x - b.x, a.y - b.y) };
};
paper.addEventListener("pointerdown", (event) => {
  paper.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, still: pointers.size === 0 });
  if (pointers.size === 1) trace.grab(event.clientX, event.clientY, event.pointerType === "mouse" ? 14 : 30);
});
paper.addEventListener("pointermove", (event) => {
  const own = pointers.get(event.pointerId);
  if (own && trace.held) return trace.pull(event.clientX, event.clientY);
  if (!own || (own.still && pointers.size === 1 && Math.hypot(event.clientX - own.x, event.clientY - own.y) < STILL)) return;
  const { w, h } = stage.size(), frame = paper.getBoundingClientRect();
  const before = pointers.size > 1 ? spread() : pointers.get(event.pointerId);
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  const after = pointers.size > 1 ? spread() : pointers.get(event.pointerId);
  if (after.x !== before.x || after.y !== before.y) stage.pan((after.x - before.x) / w, (after.y - before.y) / h);
  if (pointers.size > 1 && before.d > 0) stage.zoom(after.d / before.d, (after.x - frame.left) / w, (after.y - frame.top) / h);
});
for (const end of ["pointerup", "pointercancel"]) paper.addEventListener(end, (event) => {
  if (trace.held) trace.drop();
  else if (end === "pointerup" && pointers.size === 1 && pointers.get(event.pointerId)?.still) guess.press(event.clientX, event.clientY);
  pointers.delete(event.pointerId);
});
paper.addEventListener("wheel", (event) => {
  event.preventDefault();
  const frame = paper.getBoundingClientRect(), lines = event.deltaMode === 1 ? 16 : 1;
  stage.zoom(Math.exp(-event.deltaY * lines * 0.0016), (event.clientX - frame.left) / frame.width, (event.clientY - frame.top) / frame.height);
}, { passive: false });
paper.addEventListener("dblclick", () => player.fit());
paper.addEventListener("keydown", (event) => {
  const step = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
  if (!event.shiftKey || !step) return;
  stage.pan(...step);
  event.preventDefault();
  event.stopPropagation();
});
