// The finished figures for every place of the drive; read from the page when they are first wanted.
const SVG = "http://www.w3.org/2000/svg";
const turn = {
  data: null,
  figures: [],
  start: 0, // index of the given place

  load() {
    if (turn.data || !one("#motion")) return;
    turn.data = JSON.parse(one("#motion").textContent);
    turn.start = turn.data.start;
    const home = one("#turned");
    home.style.setProperty("--bold", Math.sqrt(turn.data.figures[0].size)); // lines as much stronger as letters are larger
    turn.figures = turn.data.figures.map((figure, number) => {
      const node = document.createElementNS(SVG, "g"), [x, y, w, h] = figure.clip, rect = `x="${x}" y="${y}" width="${w}" height="${h}"`;
      node.innerHTML = `<clipPath id="clip${number}"><rect ${rect}/></clipPath><rect class="frame" ${rect}/><g clip-path="url(#clip${number})"></g>${figure.captions.map(({ svg, other }) => `<g class="${other ? "other" : ""}">${svg}</g>`).join("")}`;
      const inside = node.children[2], captions = [...node.children].slice(3);
      const sets = figure.sets.map((set) => {
        const group = document.createElementNS(SVG, "g"), layers = new Map();
        if (set.lang) group.setAttribute("class", set.lang);
        const used = new Set(Object.keys(set.still));
        for (const layers_at of set.moving) for (const layer in layers_at || {}) used.add(layer);
        for (const layer of [...used].sort((a, b) => a - b)) {
          const still = document.createElementNS(SVG, "g"), moving = document.createElementNS(SVG, "g");
          still.innerHTML = drawn(set.still[layer]);
          group.append(still, moving);
          layers.set(layer, moving);
        }
        inside.append(group);
        return { moving: set.moving, layers };
      });
      home.append(node);
      return { key: figure.key, box: figure.box, node, inside, captions, scale: figure.scale, sets, moves: sets.some((set) => set.moving.some((layers_at) => layers_at && Object.keys(layers_at).length)) };
    });
  },

  draw(index) {
    for (const figure of turn.figures) {
      figure.captions.forEach((caption, i) => (caption.style.display = i === figure.scale[index] ? "" : "none"));
      for (const set of figure.sets) {
        const here = set.moving[index];
        figure.inside.style.display = here ? "" : "none";
        if (here) for (const [layer, node] of set.layers) node.innerHTML = drawn(here[layer]);
      }
    }
    one("#degrees").textContent = turn.data.shown[index];
    all("#turn tbody tr").forEach((row, i) => {
      const [zh, en, way_zh, way_en, exact] = turn.data.readings[index][i];
      const chinese = root.dataset.lang === "zh";
      [chinese ? zh : en, chinese ? way_zh : way_en, exact].forEach((text, k) => (row.children[k + 1].innerHTML = text));
    });
  },

  shown: (index) => turn.data.shown[Math.round(index)],

  // Words for a screen reader: the angle and every reading.
  said(index) {
    const rows = all("#turn tbody tr").map((row) => [one(`th .${root.dataset.lang}`, row), ...[...row.cells].slice(1, 3)].map((cell) => cell.textContent.trim()).join(" "));
    return `${turn.data.shown[index]}. ${rows.join("; ")}`;
  },
};

// s3:M..|f4:M..|t12.velocity:100 -200 → paths, and pieces of type at their places.
function drawn(text) {
  if (!text) return "";
  return text.split("|").map((piece) => {
    const [name, body] = piece.split(":");
    if (name[0] !== "t") return `<path class="${name}" d="${body}"/>`;
    const [type, hue] = name.split("."), [x, y] = body.split(" ");
    return `<use href="#${type}" x="${x}" y="${y}"${hue ? ` class="t-${hue}"` : ""}/>`;
  }).join("");
}
