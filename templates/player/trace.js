// Ways of points, points that lie off the sheet, and the drive in one's hand.
const trace = {
  chosen: new Set(), // letters whose way is shown
  EDGE: 260, // units that an arrow at the edge takes
  held: null, // the point that is being dragged: figure, point

  // A chip for each letter that moves.
  load() {
    const found = new Map();
    for (const figure of turn.figures) for (const point of figure.points) if (!found.has(point.letter)) found.set(point.letter, point);
    const home = one("#ways");
    home.hidden = !found.size;
    for (const [letter, { type, say: [zh, en] }] of found) {
      const chip = document.createElement("button");
      chip.type = "button";
      chip.dataset.letter = letter;
      chip.setAttribute("aria-pressed", "false");
      Object.assign(chip.dataset, { zh, en });
      chip.setAttribute("aria-label", player.word(zh, en));
      chip.innerHTML = trace.letter(type);
      chip.onclick = () => trace.choose(letter, chip);
      home.append(chip);
    }
  },

  choose(letter, chip) {
    const on = !trace.chosen.delete(letter);
    if (on) trace.chosen.add(letter);
    chip.setAttribute("aria-pressed", String(on));
    for (const figure of turn.figures) trace.ways(figure);
  },

  // The whole way of each chosen point, smooth through its places.
  ways(figure) {
    const paths = figure.points.filter(({ letter }) => trace.chosen.has(letter)).map(({ at }) => `<path class="way" d="${trace.path(at)}"/>`);
    figure.ways.innerHTML = paths.join("");
  },

  path(at) {
    let d = "", pen = false;
    const n = at.length, end = turn.data.round ? n : n - 1;
    for (let i = 0; i <= end; i++) {
      const spot = at[i % n];
      if (!spot) { pen = false; continue; }
      if (!pen || i === 0) d += `M${spot[0]} ${spot[1]}`;
      else for (let k = 1; k <= 4; k++) { const z = trace.spot({ at }, i - 1 + k / 4); if (z) d += `L${z[0].toFixed(0)} ${z[1].toFixed(0)}`; }
      pen = true;
    }
    return d;
  },

  // Where a point is at an index, at the scale of the given place.
  spot(point, index) {
    if (turn.whole(index)) return point.at[turn.wrap(Math.round(index))];
    const { around, t } = turn.about(index), [p, a, b, q] = around.map((i) => (i === null ? null : point.at[i]));
    return a && b ? [0, 1].map((k) => smooth(p && p[k], a[k], b[k], q && q[k], t)) : null;
  },

  // What lies beyond the frame has an arrow at its edge with the letter; what can be dragged has a ring.
  draw(figure, index) {
    const times = turn.times(figure, index), [x, y, w, h] = figure.frame, size = letters.times(letters.LETTER, figure.seen || { px: 1, base: 1 }), far = [], grips = [];
    figure.off = [];
    for (const point of figure.points) {
      const spot = trace.spot(point, index)?.map((part) => part * times);
      if (!spot) continue;
      const inside = spot[0] > x && spot[0] < x + w && spot[1] > y && spot[1] < y + h;
      if (!inside && !figure.cell) { figure.off.push(point.letter); far.push(trace.edge(figure, spot, point, size)); }
      else if (trace.drives(figure)) grips.push(`<circle class="${point.drives ? "grip" : "hold"}" cx="${spot[0].toFixed(0)}" cy="${spot[1].toFixed(0)}" r="${Math.round(260 * size)}" data-letter="${point.letter}"/>`);
    }
    figure.far.innerHTML = far.join("");
    figure.ways.setAttribute("transform", `scale(${times})`);
    figure.ways.style.setProperty("--times", times);
    figure.grips.innerHTML = grips.join("");
  },

  // What lies off the sheet: beyond a frame, or lettered at the ends of two lines that go there.
  tell(near) {
    const found = new Map();
    for (const figure of turn.figures.filter(({ node, key }) => node.style.display !== "none" && key.startsWith("mechanism"))) {
      for (const { type } of figure.points.filter(({ letter }) => figure.off.includes(letter))) found.set(trace.text(type), type);
      for (const set of figure.sets) {
        const types = pieces((set.moving[near] || {})[TEXT]).filter(({ name }) => name[0] === "t").map(({ name }) => name.split(".")[0]), texts = types.map(trace.text);
        texts.forEach((text, i) => { if (/^P\d/.test(text) && texts.indexOf(text) !== i) found.set(text, types[i]); });
      }
    }
    one("#off").hidden = !found.size;
    one("#off-list").innerHTML = [...found.values()].map(trace.letter).join(" ");
  },

  text: (type) => document.getElementById(type).textContent,
  letter(type) {
    const { w, h } = letters.of(type);
    return `<svg viewBox="-40 ${-h - 60} ${w + 80} ${h + 220}" style="height:${((h + 220) / 350).toFixed(2)}em;width:${((w + 80) / 350).toFixed(2)}em"><use href="#${type}"/></svg>`;
  },
  drives: (figure) => figure.key === "mechanism",

  edge(figure, spot, { type }, size) {
    const [x, y, w, h] = figure.frame, cx = x + w / 2, cy = y + h / 2, dx = spot[0] - cx, dy = spot[1] - cy;
    const k = Math.min((w / 2 - 60) / Math.abs(dx || 1e-9), (h / 2 - 60) / Math.abs(dy || 1e-9)), tip = [cx + k * dx, cy + k * dy], turned = Math.atan2(dy, dx) * 180 / Math.PI, box = letters.of(type);
    const back = 420 * size + box.w * size / 2, at = [tip[0] - back * Math.cos(turned * Math.PI / 180), tip[1] - back * Math.sin(turned * Math.PI / 180)];
    return `<path class="edge" d="M0 0l${-trace.EDGE} -90v180z" transform="translate(${tip[0].toFixed(0)} ${tip[1].toFixed(0)}) rotate(${turned.toFixed(1)})"/><use href="#${type}" transform="translate(${(at[0] - box.w * size / 2).toFixed(0)} ${(at[1] + box.h * size / 2).toFixed(0)}) scale(${size})"/>`;
  },

  // A press near a point that moves takes hold of it.
  grab(x, y, reach) {
    if (!player.turning()) return false;
    let best = null;
    for (const figure of turn.figures.filter((one) => trace.drives(one) && one.node.style.display !== "none")) {
      const spot = stage.on(figure, x, y), unit = Math.hypot(stage.on(figure, x + 1, y)[0] - spot[0], 0) || 1;
      for (const point of figure.points) {
        const at = trace.spot(point, player.place), off = at ? Math.hypot(at[0] - spot[0], at[1] - spot[1]) / unit - (point.drives ? 6 : 0) : Infinity;
        if (off < reach && (!best || off < best.off)) best = { figure, point, off };
      }
    }
    trace.held = best;
    root.toggleAttribute("data-held", Boolean(best));
    if (best) player.stop();
    return Boolean(best);
  },

  // The place nearest to the finger on the way of the point that is held, and not far from where it is now.
  pull(x, y) {
    const { figure, point } = trace.held, spot = stage.on(figure, x, y), n = turn.count(), FINE = 8;
    let best = null;
    for (let step = 0; step < n * FINE; step++) {
      const index = step / FINE, at = trace.spot(point, index);
      if (!at || !turn.data.round && index > n - 1) continue;
      const away = Math.abs(index - player.place), leap = turn.data.round ? Math.min(away, n - away) : away;
      const cost = Math.hypot(at[0] - spot[0], at[1] - spot[1]) + 25 * Math.max(0, leap - 1);
      if (!best || cost < best.cost) best = { index, cost };
    }
    if (best) player.go(best.index, false);
  },

  drop() {
    trace.held = null;
    root.removeAttribute("data-held");
    player.speak(player.place);
  },
};
