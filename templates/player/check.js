// The box for one's own answers: the same verdicts and reasons as `vecpoly check`, of each answer by itself.
const check = {
  rule: JSON.parse(atob(one("#answers").textContent)),
  TENS: 7, NEAR: 0.05, // powers of ten, and how near a factor is one

  // What was typed: its value, whether a sign was written, half a unit of its last digit; null for what is no number.
  read(text) {
    const plain = text.normalize("NFKC").trim().replace(/[−–]/g, "-").replace(/\s*[×x*]\s*10\^?\s*([-+]?\d+)$/, "e$1").replace(/^([-+]?\d+),(\d+)$/, "$1.$2");
    const found = /^([-+]?)(\d*)(?:\.(\d*))?(?:e([-+]?\d+))?$/i.exec(plain);
    if (!found || !(found[2] || found[3])) return null;
    return { value: Number(plain), signed: found[1] !== "", half: 0.5 * 10 ** ((+found[4] || 0) - (found[3] || "").length) };
  },

  // right, close, sense, unsaid, wrong; as grading/compare/band.py has it.
  weigh(row, mine, x, t, wrong = check.rule.wrong) {
    const off = Math.abs(row.kind === "sc" ? mine.value - x : Math.abs(mine.value) - Math.abs(x));
    const reach = t + 0.5 * Math.min(mine.half, t);
    if (off > wrong * reach) return row.kind === "sc" && Math.abs(Math.abs(mine.value) - Math.abs(x)) <= wrong * t ? "sense" : "wrong";
    if (row.kind === "si" && Math.abs(x) > t) {
      if (!mine.sense) return "unsaid";
      if (mine.sense > 0 !== x > 0) return "sense";
    }
    return off <= reach * (1 + 1e-9) ? "right" : "close";
  },

  judge(index, text, sense = 0) {
    const row = check.rule.rows[index], mine = check.read(text);
    if (!mine) return { verdict: "", said: ["unread"] };
    mine.sense = sense || (mine.signed ? Math.sign(mine.value) || 1 : 0);
    const verdict = check.weigh(row, mine, row.x, row.t);
    if (verdict === "right") return { verdict, said: ["right"] };
    if (verdict === "close") return { verdict, said: ["nearly"] };
    if (verdict === "unsaid") return { verdict: "right", said: ["right", "sense_missing"] };
    if (verdict === "sense") return { verdict: "wrong", said: [row.kind === "si" ? "sense" : "sign"] };
    return { verdict, said: ["not_right", ...check.why(row, mine)] };
  },

  // The one slip that explains the value, or another reason; where more than one would do, that is said.
  why(row, mine) {
    const found = [];
    for (const [x, t, name] of row.slips) {
      const off = Math.abs(row.kind === "sc" ? mine.value - x : Math.abs(mine.value) - Math.abs(x)) / t;
      if (["right", "close", "unsaid"].includes(check.weigh(row, mine, x, t)) && off <= check.rule.lone) found.push([(check.rule.k * off) ** 2, name]);
    }
    found.sort((a, b) => a[0] - b[0]);
    const other = check.itself(row, mine);
    if (found.length) return found.length > 1 && found[1][0] - found[0][0] < check.rule.margin || other.length ? ["two_slips"] : [found[0][1]];
    const names = new Set(other);
    return names.size > 1 ? ["two_slips"] : [...names];
  },

  itself(row, mine) {
    if (!row.x) return ["zero"];
    if (!mine.value) return [];
    const found = [], ratio = Math.abs(mine.value / row.x), near = Math.min(check.NEAR, row.near);
    const is = (factor) => Math.abs(ratio / factor - 1) <= near, either = (factor) => is(factor) || is(1 / factor) || is(factor ** 2) || is(factor ** -2);
    const tens = Math.round(Math.log10(ratio));
    if (tens && Math.abs(tens) <= check.TENS && is(10 ** tens)) found.push(`pow10:${tens}`);
    if (["m/s", "m/s^2", "rad/s", "rad/s^2"].includes(row.unit)) {
      if (either(2 * Math.PI)) found.push("two_pi");
      if (either(Math.PI / 30)) found.push("per_minute");
    }
    if (row.unit === "deg" && (is(Math.PI / 180) || is(180 / Math.PI))) found.push("degrees");
    for (const [x, t, name] of row.others) if (Math.abs(Math.abs(mine.value) - Math.abs(x)) <= t) found.push(name);
    return found;
  },

  sentence(name) {
    const [id, n] = name.split(":"), node = all("#sentences > span").find((span) => span.dataset.name === (id === "pow10" ? id : name));
    return node.innerHTML.replaceAll("{n}", (n || "").replace("-", "−"));
  },

  show() {
    all("#check .asked").forEach((node, index) => {
      const text = one("input", node).value, sense = one("select", node);
      const { verdict, said } = text.trim() ? check.judge(index, text, sense ? +sense.value : 0) : { verdict: "", said: [] };
      node.dataset.verdict = verdict;
      one(".said", node).innerHTML = said.map(check.sentence).join(`<span class="zh">；</span><span class="en">; </span>`);
    });
  },

  reveal() {
    all("#check .asked").forEach((node, index) => { one(".said", node).textContent = check.rule.rows[index].shown; node.dataset.verdict = ""; });
  },
};
one("#check form").onsubmit = (event) => { event.preventDefault(); check.show(); };
one("#reveal").onclick = () => check.reveal();
