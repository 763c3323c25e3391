// The player: which step or place is shown, the controls, the keyboard, the language.
const root = document.documentElement, slider = one("#slider"), live = one("#live");
const figures = all("#drawn .figure").map((node) => ({
  node, key: node.dataset.key, box: node.dataset.box.split(" ").map(Number), steps: node.dataset.steps.split(" ").map(Number),
  groups: all("[data-step]", node).map((group) => ({ group, step: +group.dataset.step })), halo: one(".halo", node),
}));
const steps = all("#steps li"), COUNT = steps.length;
const FEW = 4; // figures that are shown together on a wide screen
const PACE = { steps: 2600, turn: 90 }; // ms

const player = {
  mode: "steps", step: 1, place: 0, view: "auto", timer: null, way: 1, ready: false, rest: null,

  lang: () => root.dataset.lang,
  word: (zh, en) => (player.lang() === "zh" ? zh : en),
  turning: () => player.mode === "turn",
  at: () => (player.turning() ? player.place : player.step),
  low: () => (player.turning() ? 0 : 1),
  high: () => (player.turning() ? turn.data.shown.length - 1 : COUNT),

  go(to, speak = true) {
    to = Math.min(Math.max(to, player.low()), player.high());
    if (player.turning()) player.showPlace(to);
    else player.showStep(to);
    slider.value = to;
    one("#counter").textContent = player.turning() ? turn.data.shown[to] : `${to} / ${COUNT}`;
    slider.setAttribute("aria-valuetext", player.turning() ? turn.data.shown[to] : player.word(`第 ${to} 步，共 ${COUNT} 步`, `step ${to} of ${COUNT}`));
    const ends = player.turning() && turn.data.all;
    for (const id of ["first", "back"]) one(`#${id}`).disabled = !ends && to === player.low();
    for (const id of ["last", "next"]) one(`#${id}`).disabled = !ends && to === player.high();
    if (speak && !player.timer) player.speak(to);
  },

  // A step is told at once; a moving drive when it has come to rest.
  speak(to) {
    clearTimeout(player.rest);
    if (player.turning()) player.rest = setTimeout(() => player.turning() && (live.textContent = player.said(player.place)), 400);
    else live.textContent = player.said(to);
  },

  said(to) {
    if (player.turning()) return turn.said(to);
    return player.word(`第 ${to} 步，共 ${COUNT} 步。`, `Step ${to} of ${COUNT}. `) + steps[to - 1].dataset[player.lang() === "zh" ? "sayZh" : "sayEn"];
  },

  showStep(to) {
    player.step = to;
    for (const figure of figures) {
      figure.halo.textContent = "";
      for (const { group, step } of figure.groups) {
        group.setAttribute("class", step > to ? "off" : step === to ? "now" : "");
        if (step !== to) continue;
        const glow = group.cloneNode(true);
        glow.removeAttribute("class");
        glow.removeAttribute("data-step");
        figure.halo.append(glow);
      }
    }
    steps.forEach((node, i) => {
      node.classList.toggle("cur", i + 1 === to);
      node.classList.toggle("off", i + 1 > to);
      if (i + 1 === to) node.setAttribute("aria-current", "step");
      else node.removeAttribute("aria-current");
    });
    for (const part of all("#steps .part")) {
      const inside = all("li", part);
      part.classList.toggle("cur", inside.some((node) => node.classList.contains("cur")));
      part.classList.toggle("off", inside.every((node) => node.classList.contains("off")));
    }
    const panel = one("#panel"), node = steps[to - 1], top = node.offsetTop, low = top + node.offsetHeight;
    if (low > panel.scrollTop + panel.clientHeight || top < panel.scrollTop) {
      const target = Math.max(0, top - Math.max(24, panel.clientHeight - node.offsetHeight - 40));
      panel.scrollTo({ top: target, behavior: !player.ready || calm.matches || Math.abs(target - panel.scrollTop) > 2 * panel.clientHeight ? "instant" : "smooth" });
    }
    if (player.view === "auto") player.frame();
  },

  showPlace(to) {
    player.place = to;
    turn.draw(to);
  },

  // Follow: of few figures those begun so far; of many, or on a phone, those that the newest lines belong to.
  frame(at_once = false) {
    const show = (keys) => {
      for (const figure of player.turning() ? turn.figures : figures) figure.node.classList.toggle("aside", keys.length > 0 && !keys.includes(figure.key));
      if (player.view !== "free") stage.show(keys, at_once);
    };
    if (player.view !== "auto") return show(["all", "free"].includes(player.view) ? [] : [player.view]);
    if (player.turning()) return show([]);
    const crowd = figures.length > FEW || stage.narrow(), begun = figures.filter((figure) => figure.steps[0] <= player.step);
    const latest = Math.max(...begun.flatMap((figure) => figure.steps.filter((step) => step <= player.step)));
    show(begun.filter((figure) => !crowd || figure.steps.includes(latest)).map((figure) => figure.key));
  },

  look(view) {
    const anew = player.turning() && stage.narrow() && view !== "free" && player.view !== view;
    player.view = view;
    for (const chip of all("#views button")) chip.setAttribute("aria-pressed", String(chip.dataset.view === view));
    if (anew) player.arrange();
    else player.frame();
  },
  free() {
    if (player.view !== "free") player.look("free");
  },
  fit() {
    player.look(player.view === "auto" || player.view === "free" ? "all" : player.view);
  },

  setMode(mode) {
    player.stop();
    player.mode = mode;
    root.dataset.mode = mode;
    if (player.turning()) turn.load();
    const turning = player.turning();
    one("#steps").hidden = turning;
    if (one("#turn")) {
      one("#turn").hidden = !turning;
      one("#gaps").hidden = !turn.data || turn.data.all;
      one("#cut").hidden = !turn.data || !turn.data.figures.some((figure) => figure.cut);
      one("#mode-steps").setAttribute("aria-pressed", String(!turning));
      one("#mode-turn").setAttribute("aria-pressed", String(turning));
    }
    one("#drawn").style.display = turning ? "none" : "";
    one("#turned").style.display = turning ? "" : "none";
    slider.min = player.low();
    slider.max = player.high();
    if (player.view === "free") player.look("auto");
    player.relabel();
    player.arrange();
    player.go(player.at());
  },

  // On a phone the first two figures turn alone unless another is asked for: all together would be too small.
  arrange() {
    const everything = player.turning() ? turn.figures : figures;
    const shown = player.turning() && player.view === "auto" && stage.narrow() ? everything.slice(0, 2) : everything;
    for (const figure of everything) figure.node.style.display = shown.includes(figure) ? "" : "none";
    stage.arrange(shown);
    player.frame(true);
  },

  setLang(lang) {
    root.dataset.lang = root.lang = lang;
    document.title = document.body.dataset[lang === "zh" ? "titleZh" : "titleEn"];
    player.relabel();
    player.go(player.at(), false);
  },

  relabel() {
    const turning = player.turning(), names = turning && {
      first: ["起始位置", "First place"], back: ["退一个位置", "Back"], next: ["进一个位置", "Next"], last: ["最后位置", "Last place"], slider: ["主动件的位置", "Place of the drive"] };
    for (const node of all("[data-zh]")) {
      const [zh, en] = (names && names[node.id]) || [node.dataset.zh, node.dataset.en];
      const text = node.id === "play" && player.timer ? player.word("暂停", "Pause") : player.word(zh, en);
      node.setAttribute("aria-label", text);
      if (node.matches("button:not(#language):not(.number)")) node.title = text;
    }
  },

  play() {
    if (player.timer) return player.stop();
    if (!player.turning() && player.step === COUNT) player.go(1);
    player.timer = setInterval(player.tick, PACE[player.mode]);
    root.toggleAttribute("data-playing", true);
    player.relabel();
  },
  stop() {
    clearInterval(player.timer);
    player.timer = null;
    root.toggleAttribute("data-playing", false);
    player.relabel();
  },
  // Steps end with the last; a drive that goes round goes on, one that cannot turns back.
  tick() {
    if (!player.turning()) {
      player.go(player.step + 1);
      live.textContent = player.said(player.step);
      if (player.step === COUNT) player.stop();
    } else if (turn.data.all) player.go((player.place + 1) % turn.data.shown.length);
    else {
      if (player.place + player.way > player.high() || player.place + player.way < 0) player.way = -player.way;
      player.go(player.place + player.way);
    }
  },

  next(by) {
    player.stop();
    const many = player.high() + 1;
    player.go(player.turning() && turn.data.all ? (player.place + by + many) % many : player.at() + by);
  },
};

one("#first").onclick = () => { player.stop(); player.go(player.low()); };
one("#last").onclick = () => { player.stop(); player.go(player.high()); };
one("#back").onclick = () => player.next(-1);
one("#next").onclick = () => player.next(1);
one("#play").onclick = () => player.play();
slider.oninput = () => { player.stop(); player.go(+slider.value); };
one("#zoom-in").onclick = () => stage.zoom(1.3);
one("#zoom-out").onclick = () => stage.zoom(1 / 1.3);
one("#zoom-fit").onclick = () => player.fit();
one("#language").onclick = () => player.setLang(player.lang() === "zh" ? "en" : "zh");
for (const chip of all("#views button")) chip.onclick = () => player.look(chip.dataset.view);
for (const node of steps) one(".number", node).onclick = () => { player.stop(); player.go(+node.dataset.step); };
if (one("#mode-turn")) {
  one("#mode-steps").onclick = () => player.setMode("steps");
  one("#mode-turn").onclick = () => player.setMode("turn");
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
  const on = event.target instanceof Element ? event.target : document.body;
  if (on === slider && event.key !== " ") return; // the slider has keys of its own
  if (event.key === " " && on.closest("button, summary")) return;
  const act = { ArrowRight: () => player.next(1), ArrowLeft: () => player.next(-1), PageDown: () => player.next(1), PageUp: () => player.next(-1),
    Home: () => one("#first").onclick(), End: () => one("#last").onclick(), " ": () => player.play() }[event.key];
  if (!act) return;
  event.preventDefault();
  act();
});

// On paper: every step, and the finished figures.
let before = null;
addEventListener("beforeprint", () => {
  before = { step: player.step, open: one("#problem").open };
  one("#problem").open = true;
  if (!player.turning()) { player.go(COUNT, false); for (const { group } of figures.flatMap((figure) => figure.groups)) group.setAttribute("class", ""); }
  for (const node of all("#steps .off")) node.classList.remove("off");
  stage.show([], true);
});
addEventListener("afterprint", () => { one("#problem").open = before.open; player.go(player.turning() ? player.place : before.step, false); player.frame(true); });

new ResizeObserver(() => player.arrange()).observe(paper);
one("#problem").open = innerWidth > 1100 && innerHeight > 700;
const wish = new URLSearchParams(location.hash.slice(1)); // play.html#step=7, #turn=10, #lang=en
if (wish.has("lang")) root.dataset.lang = root.lang = wish.get("lang") === "en" ? "en" : "zh";
if (wish.has("turn") && one("#motion")) { turn.load(); player.place = turn.start + +wish.get("turn"); player.setMode("turn"); }
else { player.step = +wish.get("step") || 1; player.setMode("steps"); }
document.fonts.ready.then(() => requestAnimationFrame(() => { player.go(player.at(), false); player.ready = true; }));
