// The player: which step or place is shown, and in which language.
const root = document.documentElement, slider = one("#slider"), live = one("#live");
const figures = all("#drawn .figure").map((node) => ({
  node, key: node.dataset.key, box: node.dataset.box.split(" ").map(Number), steps: node.dataset.steps.split(" ").map(Number),
  groups: all("[data-step]", node).map((group) => ({ group, step: +group.dataset.step })), halo: one(".halo", node),
}));
const steps = all("#steps li"), COUNT = steps.length;
const FEW = 4; // figures that are shown together on a wide screen
const PACE = { step: 2600, zh: 110, en: 45, turn: 180, frame: 30 }; // ms: at least for a step, for a character to be read, for a place, between two pictures
const KEYS = { ArrowLeft: "←", ArrowRight: "→" };
const SPEEDS = [1, 2, 0.25, 0.5], FAST = ["1×", "2×", "¼×", "½×"], SIZES = [100, 125, 150, 200]; // times the pace; % of the usual text

const player = {
  mode: "steps", beat: 1, place: 0, view: "auto", timer: null, way: 1, ready: false, rest: null, speed: 1, laid: "",

  lang: () => root.dataset.lang,
  word: (zh, en) => (player.lang() === "zh" ? zh : en),
  turning: () => player.mode === "turn",
  get step() { return beat.of(player.beat).step; },
  at: () => (player.turning() ? player.place : player.beat),
  low: () => (player.turning() ? 0 : 1),
  high: () => (player.turning() ? turn.data.shown.length - 1 : cut.length),
  counted: (to) => (player.turning() ? turn.shown(to) : `${beat.name(to)} / ${COUNT}`),

  go(to, speak = true) {
    to = player.turning() ? turn.wrap(to) : Math.min(Math.max(Math.round(to) || 1, 1), cut.length);
    player.jumped = Math.abs(to - player.beat) > 1;
    if (player.turning()) player.showPlace(to);
    else player.showBeat(to);
    slider.value = Math.min(to, player.high());
    one("#counter").textContent = player.counted(to);
    slider.setAttribute("aria-valuetext", player.turning() ? turn.shown(to) : player.word(`第 ${beat.name(to)} 步，共 ${COUNT} 步`, `step ${beat.name(to)} of ${COUNT}`));
    const ends = player.turning() && turn.data.round;
    for (const id of ["first", "back"]) one(`#${id}`).setAttribute("aria-disabled", !ends && to === player.low());
    for (const id of ["last", "next"]) one(`#${id}`).setAttribute("aria-disabled", !ends && to === player.high());
    if (speak && !player.timer) player.speak(to);
    player.note();
  },

  // The address leads back here: play.html#step=7, #turn=10 places beyond the given one. Safari allows few such notes in a short time.
  note() {
    clearTimeout(player.noted);
    const here = player.turning() ? `#turn=${+(player.place - turn.start).toFixed(2)}` : `#step=${beat.name(player.beat)}`;
    if (player.ready) player.noted = setTimeout(() => { try { history.replaceState(null, "", `${here}&lang=${player.lang()}`); } catch { /* no address to change */ } }, 500);
  },

  // A step is told at once; a moving drive when it has come to rest.
  speak(to) {
    clearTimeout(player.rest);
    if (player.turning()) player.rest = setTimeout(() => player.turning() && (live.textContent = player.said(player.place)), 400);
    else live.textContent = player.said(to);
  },

  said(to) {
    if (player.turning()) return turn.said(to);
    return beat.said(to);
  },

  showBeat(to) {
    const forward = to === player.beat + 1;
    if (to !== player.beat) { player.beat = to; guess.enter(to, forward); }
    beat.draw(to, guess.veiled);
    steps.forEach((node, i) => {
      node.classList.toggle("cur", i + 1 === player.step);
      node.classList.toggle("off", i + 1 > player.step);
      if (i + 1 === player.step) node.setAttribute("aria-current", "step");
      else node.removeAttribute("aria-current");
    });
    beat.tell(steps[player.step - 1], to, guess.veiled);
    for (const part of all("#steps .part")) {
      const inside = all("li", part);
      part.classList.toggle("cur", inside.some((node) => node.classList.contains("cur")));
      part.classList.toggle("off", inside.every((node) => node.classList.contains("off")));
    }
    player.reveal(steps[player.step - 1]);
    const drawn = figures.filter((figure) => figure.steps.includes(to));
    if (player.view === "free" && drawn.length && !drawn.some((figure) => stage.seen(figure.key))) player.look("auto");
    else if (player.view === "auto") player.frame();
  },

  // Scroll to a step: where it stands alone, with its heading; in the list, with steps before it.
  reveal(node) {
    const panel = one("#panel"), top = node.offsetTop, low = top + node.offsetHeight, room = panel.clientHeight;
    const alone = stage.narrow() || root.dataset.panel === "off", line = alone && one(".display.now", node);
    if (line && line.getBoundingClientRect().bottom > panel.getBoundingClientRect().bottom) return line.scrollIntoView({ block: "end" });
    if (line && line.getBoundingClientRect().top > panel.getBoundingClientRect().top) return;
    if (!alone && low <= panel.scrollTop + room && top >= panel.scrollTop) return;
    const target = Math.max(0, alone ? Math.min(top - 40, low + 8 - room) : top - Math.max(24, room - node.offsetHeight - 40));
    panel.scrollTo({ top: target, behavior: alone || !player.ready || calm.matches || Math.abs(target - panel.scrollTop) > 2 * room ? "instant" : "smooth" });
  },

  showPlace(to) {
    player.place = to;
    turn.draw(to);
  },

  // Follow: of few figures those begun so far; of many, or on a phone, those that the newest lines belong to.
  frame(at_once = false) {
    const show = (keys) => {
      for (const figure of player.turning() ? turn.figures : figures) figure.node.classList.toggle("aside", keys.length > 0 && !keys.includes(figure.key));
      if (player.view === "free") return;
      const together = stage.narrow() && keys.length > 1 && player.view === "auto" ? keys : []; // on a phone, what stands between them gives way
      if (!player.turning() && together.join() !== player.laid) {
        player.laid = together.join();
        stage.arrange(figures.filter((figure) => !together.length || together.includes(figure.key)));
      }
      stage.show(keys, at_once);
    };
    if (player.view !== "auto") return show(["all", "free"].includes(player.view) ? [] : [player.view]);
    if (player.turning()) return show([]);
    const crowd = figures.length > FEW || stage.narrow(), begun = figures.filter((figure) => figure.steps[0] <= player.beat);
    const latest = Math.max(...begun.flatMap((figure) => figure.steps.filter((step) => step <= player.beat)));
    const read = (beat.of(player.beat).marks || []).map(([key]) => key), looked = latest < player.beat && read.length; // where there is something to be measured, there one looks
    show(begun.filter(({ key, steps }) => !crowd || (looked ? read.includes(key) : steps.includes(latest))).map(({ key }) => key));
  },

  look(view) {
    const anew = player.turning() && view !== "free" && player.view !== view;
    player.view = view;
    if (view !== "free") one("#view").value = view;
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
    if (player.turning()) { turn.load(); player.place = turn.wrap(player.place); }
    const turning = player.turning();
    one("#steps").hidden = turning;
    if (one("#turn")) {
      one("#turn").hidden = !turning;
      one("#gaps").hidden = !turn.data || turn.data.all;
      one("#others").hidden = !turn.data || !turn.data.figures.some((figure) => figure.captions.some(({ other }) => other));
      one("#cut").hidden = !turn.data || !turn.data.figures.some((figure) => figure.cut);
      one("#mode-steps").setAttribute("aria-pressed", String(!turning));
      one("#mode-turn").setAttribute("aria-pressed", String(turning));
    }
    one("#drawn").style.display = turning ? "none" : "";
    one("#turned").style.display = turning ? "" : "none";
    slider.min = player.low();
    slider.max = player.high();
    slider.step = turning ? 0.1 : 1;
    if (player.view === "free") player.look("auto");
    player.relabel();
    player.arrange();
    player.go(player.at());
  },

  arrange() {
    const everything = player.turning() ? turn.figures : figures, only = everything.filter((figure) => figure.key === player.view);
    const shown = !player.turning() ? everything : only.length ? only : player.view === "auto" ? player.first() : everything;
    for (const figure of everything) figure.node.style.display = shown.includes(figure) ? "" : "none";
    stage.arrange(shown);
    player.laid = "";
    player.frame(true);
    if (player.turning()) turn.draw(player.place);
  },
  // Of the figures that move: the mechanism, and where the quantity stands that is followed, then others as far as there is room.
  first() {
    const most = stage.narrow() ? 3 : FEW, on = (turn.data.curves[Math.max(curve.chosen, 0)] || { on: [] }).on;
    const rank = (figure) => (figure === turn.figures[0] ? 0 : on.includes(figure.key) ? 1 : 2), moving = turn.figures.filter((figure) => figure.moves || rank(figure) < 2);
    const chosen = moving.map((figure, i) => ({ figure, by: 100 * rank(figure) + i })).sort((a, b) => a.by - b.by).slice(0, most).map(({ figure }) => figure);
    return turn.figures.filter((figure) => chosen.includes(figure));
  },

  setLang(lang) {
    root.dataset.lang = root.lang = lang;
    for (const figure of [...figures, ...turn.figures]) figure.seen = null; // letters about words of another length
    document.title = document.body.dataset[lang === "zh" ? "titleZh" : "titleEn"];
    player.relabel();
    stage.legible(stage.size().w / stage.camera.w);
    player.go(player.at(), false);
  },

  relabel() {
    const turning = player.turning(), names = turning && {
      first: ["起始位置", "First place"], back: ["退一个位置", "Back"], next: ["进一个位置", "Next"], last: ["最后位置", "Last place"], slider: [slider.dataset.turnZh, slider.dataset.turnEn] };
    const folded = root.dataset.panel === "off", full = Boolean(document.fullscreenElement);
    const states = { play: player.timer && ["暂停", "Pause"], "panel-off": folded && ["展开说明", "Unfold the explanation"], present: full && ["退出全屏", "Leave full screen"] };
    for (const node of all("[data-tell-zh]")) node.textContent = player.word(node.dataset.tellZh, node.dataset.tellEn);
    for (const node of all("[data-zh]")) {
      const [zh, en] = states[node.id] || (names && names[node.id]) || [node.dataset.zh, node.dataset.en];
      const text = player.word(zh, en) + (node.id === "speed" ? ` ${node.textContent}` : "");
      node.setAttribute("aria-label", text);
      if (node.matches("button:not(#language, .number, .pick, #ways button)")) node.title = text + (node.ariaKeyShortcuts ? ` (${KEYS[node.ariaKeyShortcuts] || node.ariaKeyShortcuts})` : "");
    }
  },

  play() {
    if (player.timer) return player.stop();
    if (!player.turning() && player.beat === cut.length) player.go(1);
    root.toggleAttribute("data-playing", true);
    player.wait();
    player.relabel();
  },
  // A step stays until it can have been read; a vector or a line of it, until it can have been seen.
  wait() {
    if (player.turning()) return (player.timer = setTimeout(() => { player.tick(); if (player.timer) player.wait(); }, (calm.matches ? PACE.turn : PACE.frame) / Math.min(player.speed, 1)));
    const begins = player.beat === beat.first(player.step);
    const reading = Math.max(PACE.step, begins ? PACE[player.lang()] * one(".words", steps[player.step - 1]).innerText.length : 0);
    player.timer = setTimeout(() => { player.tick(); if (player.timer) player.wait(); }, reading / player.speed);
  },
  stop() {
    clearTimeout(player.timer);
    player.timer = null;
    root.toggleAttribute("data-playing", false);
    player.relabel();
  },
  // Steps end with the last; a drive that goes round goes on, one that cannot turns back.
  tick() {
    if (!player.turning()) {
      if (guess.veiled) return guess.reveal();
      player.go(player.beat + 1);
      live.textContent = player.said(player.beat);
      if (player.beat === cut.length) player.stop();
      return;
    }
    const by = calm.matches ? 1 : PACE.frame / PACE.turn * Math.max(player.speed, 1);
    if (!turn.data.round && (player.place + player.way * by > player.high() || player.place + player.way * by < 0)) player.way = -player.way;
    player.go(player.place + (turn.data.round ? 1 : player.way) * by);
  },

  // Whole steps: to the end of this one, or of the one before.
  leap(by) {
    player.stop();
    if (player.turning()) return player.next(by);
    const whole = player.beat === beat.last(player.step), to = player.step + (by > 0 ? (whole ? 1 : 0) : -1);
    player.go(beat.last(Math.min(Math.max(to, 1), COUNT)));
  },

  next(by) {
    player.stop();
    if (!player.turning() && by > 0 && guess.veiled) return guess.reveal();
    if (player.turning()) return player.go((by > 0 ? Math.floor(player.place + 1e-6) : Math.ceil(player.place - 1e-6)) + by);
    player.go(player.beat + by);
  },
};
