// The finished figures for every place of the drive; read from the page when they are first wanted. Between two places they are blended.
const SVG = "http://www.w3.org/2000/svg", TEXT = "8"; // the layer of letters
const turn = {
  data: null,
  figures: [],
  start: 0, // index of the given place

  load() {
    if (turn.data || !one("#motion")) return;
    turn.data = JSON.parse(one("#motion").textContent);
    turn.start = turn.data.start;
    turn.values = turn.data.shown.map((shown) => parseFloat(shown.replace("−", "-")));
    turn.unit = turn.data.shown[0].replace(/^[−\d.]+/, "");
    const home = one("#turned");
    home.style.setProperty("--bold", Math.sqrt(turn.data.figures[0].size)); // lines as much stronger as letters are larger
    turn.figures = turn.data.figures.map(turn.figure);
    for (const figure of turn.figures) home.append(figure.node);
    trace.load();
    curve.load();
  },

  figure(figure, number) {
    const node = shape("g", { "data-key": figure.key }), [x, y, w, h] = figure.clip, rect = `x="${x}" y="${y}" width="${w}" height="${h}"`;
    node.innerHTML = `<clipPath id="clip${number}"><rect ${rect}/></clipPath><rect class="frame" ${rect}/><g clip-path="url(#clip${number})"><g class="lens"><g class="ways"></g><g class="inside"></g><g class="grips"></g></g></g><g class="far"></g>${figure.captions.map(({ svg, other }) => `<g class="caption ${other ? "other" : ""}">${svg}</g>`).join("")}`;
    const inside = one(".inside", node), captions = [...node.children].slice(4);
    const sets = figure.sets.map((set) => {
      const group = shape("g", set.lang ? { class: set.lang } : {}), layers = new Map(), used = new Set(Object.keys(set.still));
      for (const layers_at of set.moving) for (const layer in layers_at || {}) used.add(layer);
      for (const layer of [...used].sort((a, b) => a - b)) {
        const still = shape("g", { class: "still" }), moving = shape("g", {});
        if (layer !== TEXT) still.innerHTML = drawn(pieces(set.still[layer])); // letters change with the view
        group.append(still, moving);
        layers.set(layer, moving);
      }
      inside.append(group);
      return { still: set.still, moving: set.moving, layers };
    });
    return {
      key: figure.key, box: figure.box, own: figure.box, clip: figure.clip, frame: figure.clip, cell: null, node, inside, captions, scale: figure.scale, sizes: figure.captions.map(({ times }) => times), sets, points: figure.points, polygon: figure.polygon,
      lens: one(".lens", node), ways: one(".ways", node), far: one(".far", node), grips: one(".grips", node), near: 1,
      title: figure.size * Math.max(...captions.flatMap((caption) => all("use", caption).map((use) => letters.of(use.getAttribute("href").slice(1)).w))),
      moves: sets.some((set) => set.moving.some((layers_at) => layers_at && Object.keys(layers_at).length)),
    };
  },

  count: () => turn.data.shown.length,
  whole: (index) => Math.abs(index - Math.round(index)) < 1e-3,
  wrap: (index) => (turn.data.round ? (index % turn.count() + turn.count()) % turn.count() : Math.min(Math.max(index, 0), turn.count() - 1)),

  // How many times as large as at the given place a figure is drawn at an index, where its scale is another.
  times: (figure, index) => figure.sizes[figure.scale[turn.wrap(Math.round(index))]],

  // The places about an index, as far as there are any: before, from, to, after; and how far it is on the way.
  about(index) {
    const from = Math.floor(index), there = (at) => (turn.data.round ? turn.wrap(at) : at >= 0 && at < turn.count() ? at : null);
    return { around: [from - 1, from, from + 1, from + 2].map(there), t: index - from };
  },

  draw(index) {
    const near = turn.wrap(Math.round(index)), { around, t } = turn.whole(index) ? { around: [null, near, null, null], t: 0 } : turn.about(index);
    for (const figure of turn.figures) {
      if (figure.node.style.display === "none") continue;
      figure.captions.forEach((caption, i) => (caption.style.display = i === figure.scale[near] ? "" : "none"));
      const size = turn.look(figure, index);
      const [before, from, to, after] = around.map((at) => (at === null || figure.scale[at] !== figure.scale[near] ? null : at));
      for (const set of figure.sets) {
        const here = set.moving[near], at = (i) => (i === null ? null : set.moving[i]);
        figure.inside.style.display = here ? "" : "none";
        const ends = t && at(from) && at(to) ? [at(before), at(from), at(to), at(after)] : null;
        if (here) for (const [layer, node] of set.layers) {
          const moving = ends ? blended(ends.map((one) => one && pieces(one[layer])), t) : pieces(here[layer]);
          node.innerHTML = drawn(layer === TEXT ? [...pieces(set.still[TEXT]), ...moving] : moving, size);
        }
      }
      trace.draw(figure, index);
    }
    trace.tell(near);
    one("#degrees").textContent = turn.shown(index);
    turn.read(index, near);
    curve.draw(index);
  },

  // Followed, a polygon fills its frame at every place; seen with all others it keeps its size. How its letters are seen then.
  look(figure, index) {
    const seen = figure.seen || { px: 0.05, base: 0.05 }, { around: [, from, to], t } = turn.about(index);
    figure.near = 1;
    let at = "";
    if (figure.cell) {
      const [a, b] = [from, to].map((i) => (i === null ? null : turn.taken(figure, i))), one_of = a || b;
      const box = a && b ? a.map((v, k) => v + t * (b[k] - v)) : one_of;
      if (box) {
        const [x, y, w, h] = figure.frame, grown = letters.big(seen) ? letters.times(letters.LETTER, seen) : 1;
        figure.near = Math.min((w - turn.MARGIN * grown) / Math.max(box[2] - box[0], 1), (h - turn.MARGIN * grown) / Math.max(box[3] - box[1], 1), turn.NEAREST);
        at = `translate(${(x + w / 2 - figure.near * (box[0] + box[2]) / 2).toFixed(1)} ${(y + h / 2 - figure.near * (box[1] + box[3]) / 2).toFixed(1)}) scale(${figure.near.toFixed(4)})`;
      }
    }
    figure.lens.setAttribute("transform", at);
    figure.lens.style.setProperty("--bold", (figure.node.style.getPropertyValue("--bold") || 1) / Math.sqrt(figure.near));
    return { px: seen.px * figure.near, base: seen.base * Math.min(figure.near ** 0.2, figure.near) };
  },
  MARGIN: 500, NEAREST: 2.5, // units round what is followed; times

  // What a figure takes at a place, by its letters and points: left, top, right, bottom.
  taken(figure, index) {
    figure.boxes = figure.boxes || new Map();
    if (!figure.boxes.has(index)) {
      const xs = [], ys = [];
      for (const set of figure.sets) for (const text of [set.still[TEXT], (set.moving[index] || {})[TEXT]]) for (const { name, numbers: [x, y] } of pieces(text)) if (name[0] === "t") { const { w, h } = letters.of(name.split(".")[0]); xs.push(x, x + w); ys.push(y - h, y + h / 4); }
      for (const set of figure.sets) for (const layer of [2, 4, 6]) for (const { numbers: [x, y] } of pieces((set.moving[index] || {})[layer])) { xs.push(x); ys.push(y); }
      for (const { at } of figure.points) if (at[index]) { const [x, y] = at[index].map((part) => part * turn.times(figure, index)); xs.push(x); ys.push(y); }
      figure.boxes.set(index, xs.length ? [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)] : null);
    }
    return figure.boxes.get(index);
  },

  // The frame of a figure: its own, or a cell in which it is followed; its title goes with it, and the scale unless it stands close to others.
  TITLE: 0.6, // of what stands under a figure
  fitted(figure, cell, close) {
    const [x, y, w, h] = figure.clip, [bx, by, bw, bh] = figure.own, under = (by + bh - y - h) * (close ? turn.TITLE : 1);
    figure.cell = cell;
    figure.frame = cell ? [x + w / 2 - cell.w / 2, y + h - cell.h, cell.w, cell.h] : figure.clip;
    const wide = Math.max(figure.frame[2] + 2 * (x - bx > 0 ? Math.min(x - bx, 200) : 200), figure.title);
    figure.box = cell ? [x + w / 2 - wide / 2, figure.frame[1] - 200, wide, cell.h + 200 + under] : [bx, by, bw, y + h + under - by];
    for (const rect of all(":scope > rect, :scope > clipPath > rect", figure.node)) ["x", "y", "width", "height"].forEach((name, k) => rect.setAttribute(name, Math.round(figure.frame[k])));
  },

  // What is read at a place; between two places about so much, of what is exact.
  read(index, near) {
    const chinese = root.dataset.lang === "zh";
    all("#turn tbody tr").forEach((row, i) => {
      const [zh, en, way_zh, way_en, exact] = turn.data.readings[near][i], about = turn.whole(index) ? null : curve.about(i, index);
      const cells = turn.whole(index) ? [chinese ? zh : en, chinese ? way_zh : way_en, exact] : ["", "", about === null ? "" : `≈ ${curve.text(about)}`];
      cells.forEach((text, k) => (row.children[k + 1].innerHTML = text));
    });
  },

  // What the drive's datum reads: as written at a place, by proportion between two.
  shown(index) {
    if (turn.whole(index)) return turn.data.shown[turn.wrap(Math.round(index))];
    const { around: [, from, to], t } = turn.about(index), a = turn.values[from];
    const ahead = turn.unit === "°" ? ((turn.values[to] - a + 540) % 360) - 180 : turn.values[to] - a, value = a + t * ahead;
    return `${+(turn.unit === "°" ? (value + 360) % 360 : value).toFixed(1)}${turn.unit}`.replace("-", "−");
  },

  // Words for a screen reader: the angle and every reading, about so much between two places.
  said(index) {
    const language = player.lang() === "zh" ? 0 : 1, near = turn.wrap(Math.round(index));
    const rows = all("#turn tbody tr").map((row, i) => {
      const { drawn, aloud } = turn.data.curves[i], texts = [...row.cells].map((cell) => cell.textContent.trim()), about = turn.whole(index) ? null : curve.about(i, index);
      const size = about !== null ? player.word("约 ", "about ") + curve.text(about) : turn.whole(index) && drawn.length && drawn[near] !== null ? `${+drawn[near].toPrecision(4)}`.replace("-", "−") : texts[1];
      const unit = drawn.length && size ? aloud[language] : "";
      return [one(".pick", row).getAttribute("aria-label"), size, unit, turn.data.aloud[texts[2]] ?? texts[2]].filter(Boolean).join(" ");
    });
    return `${turn.shown(index)}. ${rows.join("; ")}`;
  },
};

// s3:M..|f4:M..|t12.velocity:100 -200 → strokes and pieces of type: name, body, its numbers, what stands between them. Kept, for a drive goes round often.
const kept = new Map(), paired = new WeakMap();
function pieces(text) {
  if (!text) return kept.get("") || kept.set("", []).get("");
  if (!kept.has(text)) {
    kept.set(text, text.split("|").flatMap((piece) => {
      const at = piece.indexOf(":"), name = piece.slice(0, at);
      return piece.slice(at + 1).split(/(?=M)/).map((body) => ({ name, body, numbers: (body.match(/-?\d+/g) || []).map(Number), form: body.split(/-?\d+/).map((part) => part.trim()) }));
    }));
  }
  return kept.get(text);
}

// The like of each piece in another place: in order where there are as many of a kind, else the nearest; at last of another look.
function likes(list, other) {
  if (!paired.has(list)) paired.set(list, new Map());
  const known = paired.get(list);
  if (!known.has(other)) {
    const found = new Map(), taken = new Set(), kinds = (piece, loose) => `${loose ? piece.name[0] : piece.name} ${piece.form.join()} ${piece.form.includes("A") || piece.form.includes("a") ? piece.numbers.filter((n) => n === 0 || n === 1).join() : ""}`;
    for (const loose of [false, true]) {
      if (loose) list = list.filter(({ name }) => name[0] !== "t");
      const groups = new Map();
      for (const piece of other) if (!taken.has(piece)) { const kind = kinds(piece, loose); groups.set(kind, [...(groups.get(kind) || []), piece]); }
      for (const kind of new Set(list.map((piece) => kinds(piece, loose)))) {
        const own = list.filter((piece) => !found.has(piece) && kinds(piece, loose) === kind), there = groups.get(kind) || [];
        if (own.length === there.length) own.forEach((piece, i) => { found.set(piece, there[i]); taken.add(there[i]); });
        else nearest(own, there).forEach(([piece, like]) => { found.set(piece, like); taken.add(like); });
      }
    }
    known.set(other, found);
  }
  return known.get(other);
}

// Few and many of a kind, in order: as many pairs as there can be, and those nearest together.
function nearest(own, there) {
  if (own.length > there.length) return nearest(there, own).map(([like, piece]) => [piece, like]);
  const off = (a, b) => a.numbers.reduce((sum, n, i) => sum + Math.abs(n - b.numbers[i]), 0);
  const cost = Array.from({ length: own.length + 1 }, (_, i) => Array(there.length + 1).fill(i ? Infinity : 0)); // of the first i in the first j
  for (let i = 1; i <= own.length; i++) for (let j = i; j <= there.length; j++) cost[i][j] = Math.min(cost[i][j - 1], cost[i - 1][j - 1] + off(own[i - 1], there[j - 1]));
  const pairs = [];
  for (let i = own.length, j = there.length; i > 0; j--) if (cost[i][j] < cost[i][j - 1]) pairs.unshift([own[--i], there[j - 1]]);
  return pairs;
}

// Between two places by a smooth curve through four; what has no like in the next place goes in the middle, and comes there.
function blended([before, from, to, after], t) {
  const [here, there] = t < 0.5 ? [from, to] : [to, from], pair = likes(here, there);
  return here.map((piece) => {
    const like = pair.get(piece);
    if (!like) return piece;
    const [a, b] = t < 0.5 ? [piece, like] : [like, piece];
    const p = before && likes(from, before).get(a), q = after && likes(to, after).get(b);
    const numbers = a.numbers.map((n, i) => Math.round(smooth(p && p.numbers[i], n, b.numbers[i], q && q.numbers[i], t)));
    return { name: piece.name, numbers, body: piece.form.map((part, i) => `${part} ${numbers[i] ?? ""}`).join("") };
  });
}

// Through a at 0 and b at 1, with the slopes of their neighbours (none: straight on).
function smooth(p, a, b, q, t) {
  const m = p === null || p === undefined ? b - a : (b - p) / 2, n = q === null || q === undefined ? b - a : (q - a) / 2;
  return hermite(a, b, m, n, t);
}

// From a to b with these slopes at the ends.
function hermite(a, b, m, n, t) {
  return (2 * t ** 3 - 3 * t * t + 1) * a + (t ** 3 - 2 * t * t + t) * m + (3 * t * t - 2 * t ** 3) * b + (t ** 3 - t * t) * n;
}

// Paths, neighbours of one look in one, and pieces of type at their places, in letters as they are to be seen.
function drawn(list, seen = null) {
  const types = list.filter(({ name }) => name[0] === "t").map((piece) => ({ piece, type: piece.name.split(".")[0], x: piece.numbers[0], y: piece.numbers[1] }));
  const shift = new Map((seen ? letters.grown(types, seen) : []).map(({ piece, by }) => [piece, by])), out = [];
  let look = "", d = "";
  const close = () => { if (d) out.push(`<path class="${look}" d="${d}"/>`); d = ""; };
  for (const piece of list) {
    if (piece.name[0] !== "t") {
      if (piece.name !== look) close();
      look = piece.name;
      d += piece.body;
      continue;
    }
    close();
    const [type, hue] = piece.name.split("."), [x, y] = piece.numbers;
    out.push(`<use href="#${type}" x="${x}" y="${y}"${hue ? ` class="t-${hue}"` : ""}${shift.get(piece) ? ` transform="${shift.get(piece)}"` : ""}/>`);
  }
  close();
  return out.join("");
}
