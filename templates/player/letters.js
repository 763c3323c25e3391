// Letters that can be read: where the sheet is seen from afar they are drawn larger, each about its own middle; never under 11 pixels.
const letters = {
  LEAST: 11.5, WIDE: 13, MOST: 2.6, LETTER: 350, // pixels, and on a wide screen; times; units of a letter's size on paper
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
    const rest = [...list].sort((a, b) => a.y - b.y || a.x - b.x), out = [];
    while (rest.length) {
      const label = [rest.shift()];
      for (let last = label[0], i; (i = rest.findIndex((one) => Math.abs(one.y - last.y) < 60 && one.x > last.x && one.x - last.x - letters.of(last.type).w < letters.NEXT)) >= 0;) { last = rest.splice(i, 1)[0]; label.push(last); }
      const end = label[label.length - 1], { h, f } = letters.of(label[0].type), size = letters.times(f, seen);
      if (Math.abs(size - 1) < 0.03) continue;
      const x = (label[0].x + end.x + letters.of(end.type).w) / 2, y = label[0].y - h / 2;
      for (const piece of label) out.push({ ...piece, by: `translate(${Math.round(x * (1 - size))} ${Math.round(y * (1 - size))}) scale(${size.toFixed(3)})` });
    }
    return out;
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
    for (const lang of ["zh", "en"]) {
      const own = uses.filter((use) => { const only = use.closest(".zh, .en"); return !only || only.classList.contains(lang); });
      const list = own.map((use) => ({ use, type: use.getAttribute("href").slice(1), x: +use.getAttribute("x"), y: +use.getAttribute("y") }));
      for (const { use, by } of letters.grown(list, seen)) use.setAttribute("transform", by);
    }
  },
};
