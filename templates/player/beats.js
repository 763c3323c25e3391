// One vector, one line at a time: what a step draws and writes is shown beat by beat.
const cut = JSON.parse(one("#beats").textContent); // of each beat: step, at, marks, glow, turn, say
const TURNED = 1500; // ms that v_r takes to turn by 90°

const beat = {
  aim: null,
  of: (number) => cut[number - 1],
  first: (step) => +steps[step - 1].dataset.first,
  last: (step) => +steps[step - 1].dataset.last,
  // 9.3: the third beat of step 9; 9: the whole of it.
  name(number) {
    const step = beat.of(number).step;
    return number === beat.last(step) ? `${step}` : `${step}.${number - beat.first(step) + 1}`;
  },
  named(text) {
    const [step, part] = String(text).split(".").map(Number);
    if (!(step >= 1)) return NaN;
    const at = Math.min(step, COUNT);
    return part && step <= COUNT ? Math.min(beat.first(at) + part - 1, beat.last(at)) : beat.last(at);
  },

  // Lines and letters up to this beat; its own in their full weight, and what it looks at in a glow.
  draw(number, veiled) {
    const here = beat.of(number), glowing = [...(here.glow || []), ...(here.turn ? [here.turn[6]] : [])];
    cancelAnimationFrame(beat.aim);
    for (const figure of figures) {
      figure.halo.textContent = "";
      for (const { group, step } of figure.groups) {
        const own = step === number;
        group.setAttribute("class", step > number || own && veiled ? "off" : own ? "now" : "");
        if ((own || glowing.includes(step)) && !veiled) figure.halo.append(beat.glow(group));
      }
      for (const [key, ax, ay, bx, by] of here.marks || []) if (key === figure.key) figure.halo.append(shape("path", { class: "read", d: `M${ax} ${ay}L${bx} ${by}` }));
      if (here.turn && here.turn[0] === figure.key && !veiled) beat.turn(figure, here.turn);
    }
  },

  glow(group) {
    const copy = group.cloneNode(true);
    copy.removeAttribute("class");
    copy.removeAttribute("data-step");
    return copy;
  },

  // v_r at the tail of the Coriolis term turns by 90° into it; who wants no motion sees both ends of the turn.
  turn(figure, [, x, y, from, size, sweep]) {
    const bow = Math.min(0.45 * size, 900), end = (degrees) => `${(bow * Math.cos(degrees * Math.PI / 180)).toFixed(0)} ${(bow * Math.sin(degrees * Math.PI / 180)).toFixed(0)}`;
    const home = shape("g", { class: "turned", transform: `translate(${x} ${y})` }), head = Math.min(300, size / 3);
    const drawn_as = { d: `M0 0H${size}m${-head} ${-head / 3}L${size} 0l${-head} ${head / 3}`, transform: `rotate(${from})` }, arrow = shape("path", drawn_as);
    home.append(shape("path", { class: "ghost", ...drawn_as }), shape("path", { class: "bow", d: `M${end(from)}A${bow} ${bow} 0 0 ${sweep > 0 ? 1 : 0} ${end(from + sweep)}` }));
    figure.halo.append(home);
    if (calm.matches || !player.ready) return;
    home.append(arrow);
    const start = performance.now();
    const move = (now) => {
      const t = Math.min(1, (now - start) / TURNED * Math.min(player.speed, 1));
      arrow.setAttribute("transform", `rotate(${from + eased(t) * sweep})`);
      if (t < 1) beat.aim = requestAnimationFrame(move);
      else arrow.remove();
    };
    beat.aim = requestAnimationFrame(move);
  },

  // The lines of the current step up to this beat, and the term of its equation that is being drawn.
  tell(node, number, veiled) {
    for (const line of all("[data-beat]", node)) {
      const own = +line.dataset.beat;
      line.classList.toggle("now", own === number && !veiled);
      if (line.matches(".display")) line.classList.toggle("later", own > number || own === number && veiled);
    }
    for (const line of all("#steps .now")) if (!node.contains(line)) line.classList.remove("now");
    for (const line of all("#steps .later")) if (!node.contains(line)) line.classList.remove("later");
    const table = one(".listing", node);
    if (table) for (const one_of of all(".listing", node)) one_of.classList.toggle("later", number < +node.dataset.last || veiled);
  },

  // A step is told whole when it begins; after that what is new.
  said(number) {
    const here = beat.of(number), node = steps[here.step - 1], lang = player.lang() === "zh" ? "sayZh" : "sayEn";
    const count = player.word(`第 ${here.step} 步，共 ${COUNT} 步。`, `Step ${here.step} of ${COUNT}. `);
    if (number === beat.first(here.step) || number === beat.last(here.step) && player.jumped) return [count + node.dataset[lang], ...beat.read(node)].join("; ");
    const lines = all(".display", node).filter((line) => +line.dataset.beat === number).flatMap(beat.read);
    return [here.say ? player.word(...here.say) : "", ...lines].filter(Boolean).join("; ") || count;
  },

  // Equations and formulas in words, in the language of the page.
  read: (node) => all(".scroll[aria-label], .display [aria-label]", node).concat(node.matches(".display") ? all("[aria-label]", node) : []).filter((told) => !told.closest(player.lang() === "zh" ? "div.en" : "div.zh")).map((told) => told.getAttribute("aria-label")),
};

function shape(name, attributes) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
}
