// One asked quantity over the places of the drive: exact as a line, as drawn by dots, and where the drive is now.
const curve = {
  chosen: 0,
  W: 640, H: 220, LEFT: 64, LOW: 30, TOP: 12, RIGHT: 12,

  // The first quantity that changes is shown until another is picked.
  load() {
    all("#turn tbody .pick").forEach((button, i) => {
      button.onclick = () => curve.pick(i);
      button.disabled = !turn.data.curves[i].exact.length;
    });
    const known = turn.data.curves.map(({ exact }) => exact.filter((v) => v !== null)), spread = known.map((all) => Math.max(...all) - Math.min(...all));
    const changing = known.findIndex((all, i) => all.length && spread[i] > 0.01 * Math.max(...all.map(Math.abs))), first = changing >= 0 ? changing : known.findIndex((all) => all.length);
    one("#curve").hidden = first < 0;
    curve.chosen = first;
    if (first >= 0) { curve.mark(); curve.paint(); }
  },
  mark: () => all("#turn tbody .pick").forEach((button, i) => button.setAttribute("aria-pressed", String(i === curve.chosen))),

  pick(index) {
    curve.chosen = index;
    curve.mark();
    curve.paint();
    player.arrange();
  },

  about(index, place) {
    const { exact } = turn.data.curves[index];
    if (!exact.length) return null;
    const { around, t } = turn.about(place), [p, a, b, q] = around.map((i) => (i === null ? null : exact[i]));
    return a === null || b === null ? null : between(p, a, b, q, t);
  },
  text: (value) => `${+value.toPrecision(3)}`.replace("-", "−"),

  x: (index) => curve.LEFT + index / (turn.data.round ? turn.count() : turn.count() - 1) * (curve.W - curve.LEFT - curve.RIGHT),
  y: (value) => curve.TOP + (curve.high - value) / (curve.high - curve.low) * (curve.H - curve.TOP - curve.LOW),

  paint() {
    const { exact, drawn: read, unit } = turn.data.curves[curve.chosen], known = [...exact, ...read].filter((v) => v !== null);
    const ticks = rounds(Math.min(0, ...known), Math.max(0, ...known));
    [curve.low, curve.high] = [ticks[0], ticks[ticks.length - 1]];
    let d = "", pen = false;
    for (let step = 0, end = (turn.data.round ? turn.count() : turn.count() - 1) * 6; step <= end; step++) {
      const value = step % 6 ? curve.about(curve.chosen, step / 6) : exact[turn.wrap(step / 6)];
      if (value !== null) d += `${pen ? "L" : "M"}${curve.x(step / 6).toFixed(1)} ${curve.y(value).toFixed(1)}`;
      pen = value !== null;
    }
    const across = ticks.map((v) => `<path class="grid${v ? "" : " zero"}" d="M${curve.LEFT} ${curve.y(v)}H${curve.W - curve.RIGHT}"/><text x="${curve.LEFT - 6}" y="${curve.y(v) + 4}" text-anchor="end">${curve.text(v)}</text>`);
    const every = Math.ceil(turn.count() / 6), marks = Array.from({ length: Math.ceil(turn.count() / every) }, (_, k) => k * every);
    const along = marks.map((i) => `<path class="grid" d="M${curve.x(i)} ${curve.TOP}V${curve.H - curve.LOW}"/><text x="${curve.x(i)}" y="${curve.H - 10}" text-anchor="middle">${turn.data.shown[i]}</text>`);
    const dots = read.map((v, i) => (v === null ? "" : `<circle cx="${curve.x(i).toFixed(1)}" cy="${curve.y(v).toFixed(1)}" r="2.4"/>`));
    one("#curve svg").innerHTML = `${across.join("")}${along.join("")}<path class="exact" d="${d}"/><g class="dots">${dots.join("")}</g><path class="now"/><circle class="here" r="5"/>`;
    one("#curve .symbol").innerHTML = one("#turn tbody tr:nth-child(" + (curve.chosen + 1) + ") th").innerHTML.replace(/<\/?button[^>]*>/g, "");
    one("#curve .unit").textContent = unit ? `/ ${unit}` : "";
  },

  draw(place) {
    const line = one("#curve .now");
    if (!line) return;
    const { exact } = turn.data.curves[curve.chosen], value = turn.whole(place) ? exact[turn.wrap(Math.round(place))] : curve.about(curve.chosen, place), x = curve.x(turn.wrap(place));
    line.setAttribute("d", `M${x.toFixed(1)} ${curve.TOP}V${curve.H - curve.LOW}`);
    const here = one("#curve .here");
    here.style.display = value === null ? "none" : "";
    if (value !== null) { here.setAttribute("cx", x.toFixed(1)); here.setAttribute("cy", curve.y(value).toFixed(1)); }
  },

  // A press on the curve takes the drive there.
  press(event) {
    const frame = one("#curve svg").getBoundingClientRect(), x = (event.clientX - frame.left) / frame.width * curve.W;
    const index = (x - curve.LEFT) / (curve.W - curve.LEFT - curve.RIGHT) * (turn.data.round ? turn.count() : turn.count() - 1);
    player.stop();
    player.go(turn.wrap(Math.min(Math.max(index, 0), turn.count() - (turn.data.round ? 0.01 : 1))), false);
  },
};

// As `smooth`, and never beyond its ends: a value that jumps has no swing before and after.
function between(p, a, b, q, t) {
  const slope = (one, other) => (one * other <= 0 ? 0 : 2 * one * other / (one + other)), s = b - a;
  const m = p === null ? s : slope(a - p, s), n = q === null ? s : slope(s, q - b);
  return hermite(a, b, m, n, t);
}

// Round numbers from below a value to above another, few.
function rounds(low, high) {
  const span = high - low || Math.abs(high) || 1, power = 10 ** Math.floor(Math.log10(span / 3)), step = [1, 2, 5, 10].map((k) => k * power).find((size) => span / size <= 4.5);
  const first = Math.floor(low / step + 1e-9), last = Math.max(Math.ceil(high / step - 1e-9), first + 1);
  return Array.from({ length: last - first + 1 }, (_, i) => +((first + i) * step).toPrecision(12));
}
if (one("#curve")) {
  const field = one("#curve svg");
  field.onpointerdown = (event) => { field.setPointerCapture(event.pointerId); curve.press(event); };
  field.onpointermove = (event) => { if (event.buttons) curve.press(event); };
}
