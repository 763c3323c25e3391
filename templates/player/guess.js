// Hide, guess, reveal: what a beat draws or writes waits until somebody has said where it will lie.
const guess = {
  on: false,
  veiled: false,
  spot: null, // where somebody thinks that the point lies: figure, x, y in units

  // Whether there is anything to be guessed in a beat.
  hides: (number) => Boolean(beat.of(number).at) || all(`#steps .display[data-beat="${number}"]`).length > 0,

  toggle() {
    guess.on = !guess.on;
    one("#guess").setAttribute("aria-pressed", String(guess.on));
    root.toggleAttribute("data-guess", guess.on);
    if (!guess.on && guess.veiled) guess.reveal();
  },

  // Each beat that is come to by going forward is veiled at first.
  enter(number, forward) {
    guess.clear();
    guess.veiled = guess.on && forward && guess.hides(number);
    guess.ask();
  },

  ask() {
    const here = beat.of(player.beat), point = Boolean(here.at), read = !point && guess.length(here) !== null;
    one("#ask").hidden = !guess.veiled;
    one("#ask-point").hidden = !point;
    one("#ask-read").hidden = !read;
    one("#ask-line").hidden = point || read;
    one("#own-reading").value = one("#told-guess").textContent = "";
  },

  // The one length that is read in a beat (mm on paper).
  length({ marks }) {
    return marks && marks.length === 1 ? Math.hypot(marks[0][3] - marks[0][1], marks[0][4] - marks[0][2]) / 100 : null;
  },

  clear() {
    for (const node of all("#drawn .guessed")) node.remove();
    guess.spot = null;
  },

  // A press on the sheet sets a cross.
  press(x, y) {
    if (!guess.veiled || player.turning()) return false;
    const at = beat.of(player.beat).at, figure = at && figures.find(({ key }) => key === at[0]);
    if (!figure) return false;
    guess.clear();
    const [u, v] = stage.on(figure, x, y);
    guess.spot = { figure, x: u, y: v };
    figure.node.append(shape("path", { class: "guessed", d: `M${u - 160} ${v - 160}l320 320m0 -320l-320 320` }));
    return true;
  },

  // The beat as it is, and how far the cross is from the point.
  reveal() {
    if (!guess.veiled) return;
    guess.veiled = false;
    const spot = guess.spot, here = beat.of(player.beat), at = here.at, own = parseFloat(one("#own-reading").value.normalize("NFKC").replace(",", "."));
    player.showBeat(player.beat);
    one("#ask").hidden = true;
    if (!at && own > 0 && guess.length(here) !== null) return guess.read(own, guess.length(here));
    if (!spot || !at) return;
    const off = Math.hypot(spot.x - at[1], spot.y - at[2]) / 100, [mu, unit] = (spot.figure.node.dataset.mu || "").split(" ");
    spot.figure.node.append(shape("path", { class: "guessed gap", d: `M${spot.x} ${spot.y}L${at[1]} ${at[2]}` }));
    const worth = mu ? ` ≙ ${(+mu * off).toPrecision(2).replace(/e([+-]\d+)/, "×10^$1")} ${unit}` : "";
    guess.tell(`你的点离应有的位置 ${off.toFixed(1)} mm${worth}。`, `Your point is ${off.toFixed(1)} mm from where it lies${worth}.`);
  },

  // An own reading beside the length that lies there.
  read(own, length) {
    const off = own - length, shown = `${off < 0 ? "−" : "+"}${Math.abs(off).toFixed(1)} mm`, share = `${off < 0 ? "−" : "+"}${Math.abs(100 * off / length).toPrecision(2)} %`;
    guess.tell(`图上为 ${length.toFixed(1)} mm，你的读数差 ${shown}（${share}）。`, `It is ${length.toFixed(1)} mm long; your reading is off by ${shown} (${share}).`);
  },

  tell(zh, en) {
    one("#told-guess").textContent = live.textContent = player.word(zh, en);
  },
};
if (one("#guess")) {
  one("#guess").onclick = () => guess.toggle();
  one("#unveil").onclick = () => guess.reveal();
  one("#own-reading").onkeydown = (event) => { if (event.key === "Enter") guess.reveal(); };
}
