// Buttons, keys, printing, the address.
one("#first").onclick = () => { player.stop(); player.go(player.low()); };
one("#last").onclick = () => { player.stop(); player.go(player.high()); };
one("#back").onclick = () => player.next(-1);
one("#next").onclick = () => player.next(1);
one("#play").onclick = () => player.play();
slider.oninput = () => { player.stop(); player.go(+slider.value); };
one("#speed").onclick = () => {
  const next = (SPEEDS.indexOf(player.speed) + 1) % SPEEDS.length;
  player.speed = SPEEDS[next];
  one("#speed").textContent = FAST[next];
  player.relabel();
};
one("#larger").onclick = () => {
  const next = SIZES[(SIZES.indexOf(parseInt(root.style.fontSize) || 100) + 1) % SIZES.length];
  root.style.fontSize = next === 100 ? "" : `${next}%`;
  player.reveal(steps[player.step - 1]);
};
one("#panel-off").onclick = () => {
  const off = root.dataset.panel !== "off";
  root.dataset.panel = off ? "off" : "on";
  one("#panel-off").setAttribute("aria-pressed", String(off));
  player.reveal(steps[player.step - 1]);
  player.relabel();
};
one("#present").onclick = () => { (document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen()).catch(() => {}); };
if (!document.fullscreenEnabled) one("#present").hidden = true;
document.addEventListener("fullscreenchange", () => player.relabel());
one("#zoom-in").onclick = () => stage.zoom(1.3);
one("#zoom-out").onclick = () => stage.zoom(1 / 1.3);
one("#zoom-fit").onclick = () => player.fit();
one("#language").onclick = () => player.setLang(player.lang() === "zh" ? "en" : "zh");
one("#view").onchange = () => player.look(one("#view").value);
for (const chip of all("#views button")) chip.onclick = () => player.look(chip.dataset.view);
for (const node of steps) one(".number", node).onclick = () => { player.stop(); player.go(+node.dataset.last); };
if (one("#mode-turn")) {
  one("#mode-steps").onclick = () => player.setMode("steps");
  one("#mode-turn").onclick = () => player.setMode("turn");
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || (event.shiftKey && event.key !== "+")) return;
  const on = event.target instanceof Element ? event.target : document.body;
  if (on.closest("#check input, #own-reading, select")) return; // somebody writes
  if (on === slider && !" PageUp PageDown + - = 0 f".includes(event.key)) return; // the slider has keys of its own; a presenter's remote sends PageDown
  if (" Enter".includes(event.key) && on.closest("button, summary, a")) return;
  const act = { ArrowRight: () => player.next(1), ArrowLeft: () => player.next(-1), ArrowDown: () => player.leap(1), ArrowUp: () => player.leap(-1), PageDown: () => player.next(1), PageUp: () => player.next(-1),
    Home: () => one("#first").onclick(), End: () => one("#last").onclick(), " ": () => player.play(),
    "+": () => stage.zoom(1.25), "=": () => stage.zoom(1.25), "-": () => stage.zoom(0.8), 0: () => player.fit(), f: () => one("#present").onclick(), g: () => guess.toggle(), Enter: () => guess.reveal() }[event.key];
  if (!act) return;
  event.preventDefault();
  act();
});

// On paper: every step, and the finished figures.
let before = null;
addEventListener("beforeprint", () => {
  before = { beat: player.beat, open: one("#problem").open };
  one("#problem").open = true;
  if (!player.turning()) { player.go(cut.length, false); for (const { group } of figures.flatMap((figure) => figure.groups)) group.setAttribute("class", ""); }
  for (const node of all("#steps .off, #steps .later")) node.classList.remove("off", "later");
  stage.show([], true);
});
addEventListener("afterprint", () => { one("#problem").open = before.open; player.go(player.turning() ? player.place : before.beat, false); player.frame(true); });

new ResizeObserver(() => player.arrange()).observe(paper);
new ResizeObserver(() => player.turning() || player.reveal(steps[player.step - 1])).observe(one("#panel"));
one("#problem").open = innerWidth > 1100 && innerHeight > 700;
let wish = new URLSearchParams(location.hash.slice(1)); // play.html#step=7, #turn=10, #lang=en
function follow() {
  if (wish.has("lang")) root.dataset.lang = root.lang = wish.get("lang") === "en" ? "en" : "zh";
  if (wish.has("turn") && one("#motion")) { turn.load(); player.place = turn.start + (+wish.get("turn") || 0); player.setMode("turn"); }
  else { player.beat = beat.named(wish.get("step")) || player.beat; player.setMode("steps"); }
}
follow();
addEventListener("hashchange", (event) => { wish = new URLSearchParams(new URL(event.newURL).hash.slice(1)); follow(); });
document.fonts.ready.then(() => requestAnimationFrame(() => { player.go(player.at(), false); player.ready = true; }));
