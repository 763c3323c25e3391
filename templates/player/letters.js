// Letters that can be read: where the sheet is seen from afar they are drawn larger, each about its own middle; never under 11 pixels.
const letters = {
  LEAST: 11.5, WIDE: 13, MOST: 3.6, LETTER: 350, // pixels, and on a wide screen; times; units of a letter's size on paper
  APART: 16, AWAY: 2, // passes in which letters that have grown into each other are moved apart; at most so many times their height
  NEXT: 260, // units: pieces of type that stand so near on one line are one label
  size: new Map(), // type → its width and height

  of(type) {
    if (!letters.size.has(type)) {
      const node = document.getElementById(type), first = one("text", node);
      letters.size.set(type, { w: +node.dataset.w, h: +node.dataset.h, f: first ? +first.getAttribute("font-size") : letters.LETTER });
    }
    return letters.size.get(type);
  },

  // How much larger letters of a size must be where a unit is so many pixels; where a figure is magnified they stay nearly as they were.
  times: (f, { px, base }) => Math.min(Math.max(stage.narrow() ? letters.LEAST : letters.WIDE, f * base) / (f * px), letters.MOST),

  // Pieces of type (type, x, y) with how each is moved and grown, the label that it belongs to about the middle of that.
  grown(list, seen) {
    const rest = [...list].sort((a, b) => a.y - b.y || a.x - b.x), labels = [];
    while (rest.length) {
      const label = [rest.shift()];
      for (let last = label[0], i; (i = rest.findIndex((one) => Math.abs(one.y - last.y) < 60 && one.x > last.x && one.x - last.x - letters.of(last.type).w < letters.NEXT)) >= 0;) { last = rest.splice(i, 1)[0]; label.push(last); }
      const end = label[label.length - 1], { h, f } = letters.of(label[0].type), size = letters.times(f, seen);
      const x = (label[0].x + end.x + letters.of(end.type).w) / 2, y = label[0].y - h / 2;
      labels.push({ label, size, x, y, w: size * (end.x + letters.of(end.type).w - label[0].x), h: size * h, dx: 0, dy: 0 });
    }
    if (labels.some(({ size }) => size > 1.03)) letters.parted(labels);
    return labels.filter(({ size, dx, dy }) => Math.abs(size - 1) >= 0.03 || dx || dy).flatMap(({ label, size, x, y, dx, dy }) => label.map((piece) => (
      { ...piece, by: `translate(${Math.round(x * (1 - size) + dx)} ${Math.round(y * (1 - size) + dy)}) scale(${size.toFixed(3)})` })));
  },

  // Labels that have grown into each other, moved apart the short way, and not far.
  parted(labels) {
    const held = (v, most) => Math.min(Math.max(v, -most), most);
    for (let pass = 0, met = true; met && pass < letters.APART; pass++) {
      met = false;
      for (let i = 0; i < labels.length; i++) for (let k = 0; k < i; k++) {
        const a = labels[i], b = labels[k], x = a.x + a.dx - b.x - b.dx, y = a.y + a.dy - b.y - b.dy, wide = (a.w + b.w) / 2 + 0.3 * a.h - Math.abs(x), high = (a.h + b.h) / 2 + 30 - Math.abs(y);
        if (wide <= 0 || high <= 0) continue;
        met = true;
        for (const [one, way] of [[a, 0.5], [b, -0.5]]) {
          const most = letters.AWAY * one.h;
          if (wide < high) one.dx = held(one.dx + way * wide * (x < 0 ? -1 : 1), most);
          else one.dy = held(one.dy + way * high * (y < 0 ? -1 : 1), most);
        }
      }
    }
  },

  // Whether a figure's letters are larger than on paper.
  big: (seen) => letters.times(letters.LETTER, seen) > 1.05,

  // The letters of all figures at so many pixels a unit; whether any of them has changed.
  fit(scale) {
    let anew = false;
    for (const figure of player.turning() ? turn.figures : figures) {
      const px = scale * (figure.zoom || 1);
      if (figure.seen && Math.abs(figure.seen.px / px - 1) < 0.02) continue;
      figure.seen = { px, base: scale * Math.sqrt(figure.zoom || 1) };
      figure.node.classList.toggle("big", letters.big(figure.seen));
      anew = true;
      if (player.turning()) for (const title of all(".caption", figure.node)) letters.set(all("use", title), figure.seen);
      else letters.set(all("use", figure.node), figure.seen);
    }
    return anew;
  },

  set(uses, seen) {
    for (const use of uses) use.removeAttribute("transform");
    for (const lang of player.word(["en", "zh"], ["zh", "en"])) { // what both languages share stands as it does in the one that is shown
      const own = uses.filter((use) => { const only = use.closest(".zh, .en"); return !only || only.classList.contains(lang); }), list = new Map();
      for (const use of own) {
        const piece = { type: use.getAttribute("href").slice(1), x: +use.getAttribute("x"), y: +use.getAttribute("y") }, name = Object.values(piece).join(" ");
        list.set(name, { ...piece, uses: [...(list.get(name)?.uses || []), use] }); // a letter and its glow are one
      }
      for (const { uses: same, by } of letters.grown([...list.values()], seen)) for (const use of same) use.setAttribute("transform", by);
    }
  },
};
