// The box for one's own answers: the same verdicts and reasons as `vecpoly check`, and what follows from own answers is right.
const check = {
  rule: JSON.parse(atob(one("#answers").textContent)),
  solution: null, // the other solution that was answered: its number, and what every row is by it
  TENS: 7, NEAR: 0.05, // powers of ten, and how near a factor is one

  // A direction in words or as an arrow, and how far to either side it reaches (deg): by the pattern of grading/reading/direction.py.
  wind(text) {
    const found = new RegExp(check.rule.wind, "i").exec(text);
    if (!found) return null;
    const [degrees, reach] = check.rule.winds[found.slice(1).findIndex(sign => sign !== undefined)];
    return { degrees, reach, before: text.slice(0, found.index) };
  },

  // What was typed: its value, whether a sign was written, half a unit of its last digit, a direction behind it; null for what is no number.
  read(text) {
    const turned = /[,;]?\s*(?:∠|@|方向(?:角)?\s*[:=]?|at)\s*([+-]?\d+(?:\.\d+)?)\s*(?:°|deg|度)?\s*$/i;
    const whole = text.normalize("NFKC").trim().replace(/[−–]/g, "-"), behind = turned.exec(whole), wind = behind ? null : check.wind(whole);
    const plain = (wind ? wind.before : whole.replace(turned, "")).replace(/°$/, "").trim().replace(/\s*[×x*·]\s*10(0*)$/, (_, zeros) => `e${1 + zeros.length}`).replace(/\s*[×x*·]\s*10\^?\s*[({]?([-+]?\d+)[)}]?$/, "e$1").replace(/^([-+]?\d+),(\d+)$/, "$1.$2");
    const found = /^([-+]?)(\d*)(?:\.(\d*))?(?:e([-+]?\d+))?$/i.exec(plain);
    if (!found || !(found[2] || found[3]) || !Number.isFinite(Number(plain))) return null;
    const half = 0.5 * 10 ** ((+found[4] || 0) - (found[3] || "").length);
    const direction = behind ? Number(behind[1]) : wind ? wind.degrees : null;
    return { value: Number(plain), signed: found[1] !== "", half, direction, around: wind ? wind.reach : 0 };
  },

  // right, close, sense, direction, unsaid, wrong; as grading/compare/band.py has it. target: x, t, deg, mm.
  weigh(row, mine, target) {
    const { x, t } = target, wrong = check.rule.wrong;
    const off = Math.abs(row.kind === "sc" ? mine.value - x : Math.abs(mine.value) - Math.abs(x));
    const room = t + 0.5 * Math.min(mine.half, t);
    if (off > wrong * room) return row.kind === "sc" && Math.abs(Math.abs(mine.value) - Math.abs(x)) <= wrong * t ? "sense" : "wrong";
    const turned = check.turned(row, mine, target), close = off > room * (1 + 1e-9);
    return turned && !(turned === "unsaid" && close) ? turned : close ? "close" : "right";
  },

  turned(row, mine, { x, t, deg, mm }) {
    if (Math.abs(x) <= t) return "";
    if (row.kind === "si") return !mine.sense ? "unsaid" : mine.sense > 0 !== x > 0 ? "sense" : "";
    if (row.kind !== "ve" || mine.direction === null || deg === null || mm !== null && mm < check.rule.short) return "";
    const hand = Math.max(check.rule.turned, check.rule.wrong * check.rule.k * row.scatter, t / Math.abs(x) * 180 / Math.PI);
    const reach = hand + mine.around;
    const off = check.apart(mine.direction, deg);
    return off <= reach ? "" : Math.abs(off - 180) <= reach ? "sense" : "direction";
  },

  apart(one, other) {
    return Math.abs(((one - other + 180) % 360 + 360) % 360 - 180);
  },

  // What was typed, with a sense or a direction beside it; null for what is no number.
  given(index, text, sense = 0, aim = "") {
    const mine = check.read(text), wind = check.wind(aim), along = wind ? null : check.read(aim);
    if (!mine || aim.trim() && !wind && !along) return null;
    if (check.row(index).size) mine.value = Math.abs(mine.value) * (check.row(index).x < 0 ? -1 : 1);
    mine.sense = sense || (mine.signed ? Math.sign(mine.value) || 1 : 0);
    if (along || wind) [mine.direction, mine.around] = wind ? [wind.degrees, wind.reach] : [along.value, 0];
    return mine;
  },

  // What is right of a quantity: by the solution that was answered.
  row(index) {
    return check.solution ? { ...check.rule.rows[index], ...check.solution[1][index] } : check.rule.rows[index];
  },

  // The other solution of which all is right that was typed, where by the first something is not; else null.
  meant(given) {
    const fits = (rows) => given.every((mine, index) => !mine || ["right", "close", "unsaid"].includes(check.weigh(check.rule.rows[index], mine, { ...check.rule.rows[index], ...rows[index] })));
    return fits(check.rule.rows) ? null : check.rule.solutions.find(([, rows]) => fits(rows)) || null;
  },

  judge(index, text, sense = 0, aim = "", source = null) {
    const row = check.row(index), mine = check.given(index, text, sense, aim);
    if (!mine) return { verdict: "", said: ["unread"] };
    if (source !== null) return { verdict: "right", said: [`ok_own:${source}`] };
    const verdict = check.weigh(row, mine, row), other = check.solution ? [`other_solution:${check.solution[0]}`] : [];
    if (verdict === "right") return { verdict, said: ["right", ...other] };
    const unsaid = row.kind === "si" && !mine.sense && Math.abs(row.x) > row.t ? ["sense_missing"] : [];
    if (verdict === "close") return { verdict, said: ["nearly", ...unsaid, ...other] };
    if (verdict === "unsaid") return { verdict: "right", said: ["right", "sense_missing", ...other] };
    if (verdict === "sense") return { verdict: "wrong", said: [{ si: "sense", ve: "reversed", sc: "sign" }[row.kind]] };
    if (verdict === "direction") return { verdict: "wrong", said: [`dir:${check.apart(mine.direction, row.deg).toFixed(0)}`] };
    return { verdict, said: ["not_right", ...check.why(row, mine)] };
  },

  // The one slip that explains the value, or another reason; where more than one would do, that is said.
  why(row, mine) {
    const found = [];
    for (const [x, t, name, own] of row.slips) {
      const off = Math.abs(row.kind === "sc" ? mine.value - x : Math.abs(mine.value) - Math.abs(x)) / t;
      if (["right", "close", "unsaid"].includes(check.weigh(row, mine, { x, t, deg: null, mm: null })) && off <= check.rule.lone) found.push([(check.rule.k * off) ** 2, name, own]);
    }
    found.sort((a, b) => a[0] - b[0]);
    const factors = check.factors(row, mine), others = check.others(row, mine), names = new Set([...factors, ...others]);
    if (found.length > 1 && found[1][0] - found[0][0] < check.rule.margin) return ["two_slips"];
    const rivals = found.length && found[0][2] ? factors : [...names];
    if (found.length && !rivals.some((name) => name.startsWith("pow10:") && +name.slice(6) <= check.rule.far)) return rivals.length ? ["two_slips"] : [found[0][1]];
    return names.size > 1 ? ["two_slips"] : [...names];
  },

  // What the value may be off by, without what fits far less well than the best.
  factors(row, mine) {
    if (!row.x) return ["zero"];
    if (!mine.value) return [];
    const ratio = Math.abs(mine.value / row.x), near = Math.min(check.NEAR, row.near), tens = Math.round(Math.log10(ratio)), known = [];
    if (tens && Math.abs(tens) <= check.TENS) known.push([10 ** tens, `pow10:${tens}`]);
    for (const n of row.powers) for (const [factor, name] of [[2 * Math.PI, "two_pi"], [Math.PI / 30, "per_minute"]]) known.push([factor ** n, name], [factor ** -n, name]);
    if (row.unit === "deg") known.push([Math.PI / 180, "degrees"], [180 / Math.PI, "degrees"]);
    const fitting = known.map(([factor, name]) => [Math.abs(ratio / factor - 1), name]).filter(([off]) => off <= near), best = Math.min(...fitting.map(([off]) => off));
    return [...new Set(fitting.filter(([off]) => off - best <= near / 2).map(([, name]) => name))];
  },

  others(row, mine) {
    if (!row.x || !mine.value) return [];
    return row.others.filter(([x, t]) => Math.abs(Math.abs(mine.value) - Math.abs(x)) <= t).map(([, , name]) => name);
  },

  // By how much: of what is right or close to two digits, with what is allowed; of what is wrong only about, which gives nothing away.
  by(index, [text, sense, aim], { verdict, said }) {
    const row = check.row(index), mine = check.given(index, text, sense, aim);
    if (!mine || !row.x || !verdict || said.some((name) => name.startsWith("ok_own"))) return "";
    const off = 100 * (row.kind === "sc" ? (mine.value - row.x) / Math.abs(row.x) : Math.abs(mine.value / row.x) - 1), size = Math.abs(off), sign = off < 0 ? "−" : "+";
    const both = (zh, en) => ` <span class="by"><span class="zh">${zh}</span><span class="en">${en}</span></span>`;
    if (size < 0.005) return "";
    if (verdict !== "wrong") { const shown = `${sign}${size < 0.1 ? size.toFixed(2) : +size.toPrecision(2)} %`, most = +(100 * row.near).toPrecision(2); return both(`偏差 ${shown}（允许 ±${most} %）`, `off by ${shown} (allowed ±${most} %)`); }
    if (["sense", "sign", "reversed", "zero"].includes(said[0]) || said[0].startsWith("dir:")) return "";
    if (size > 150) return both(`约为应有值的 ${+(1 + off / 100).toPrecision(1)} 倍`.replace("-", "−"), `about ${+(1 + off / 100).toPrecision(1)} times what it should be`.replace("-", "−"));
    return both(`约偏${off < 0 ? "小" : "大"} ${+size.toPrecision(1)} %`, `about ${+size.toPrecision(1)} % too ${off < 0 ? "small" : "large"}`);
  },

  sentence(name) {
    const [id, n = ""] = name.split(":"), known = ["pow10", "dir", "ok_own", "other_solution"].includes(id) ? id : name;
    const node = all("#sentences > span").find((span) => span.dataset.name === known);
    const said = node.innerHTML.replaceAll("{n}", n.replace("-", "−")).replaceAll("{d}", n);
    if (id !== "ok_own") return said;
    const asked = all("#check .asked")[+n], part = (name) => one(name, asked).innerHTML;
    const typed = document.createElement("span"); // what somebody typed is a text, and no markup
    typed.textContent = one("input", asked).value.trim();
    return said.replaceAll("{src}", part(".symbol")).replaceAll("{v}", `${typed.innerHTML} ${part(".unit")}`);
  },

  // All answers as they are typed: text, sense, direction.
  typed() {
    return all("#check .asked").map((node) => {
      const sense = one("select", node), aim = one(".aim", node);
      return [one("input", node).value, sense ? +sense.value : 0, aim ? aim.value : ""];
    });
  },

  verdicts(typed) {
    const given = typed.map(([text, sense, aim], index) => text.trim() ? check.given(index, text, sense, aim) : null);
    check.solution = check.meant(given);
    const own = check.solution ? new Map() : continued.right(given);
    return typed.map(([text, sense, aim], index) => {
      return text.trim() ? check.judge(index, text, sense, aim, own.has(index) ? own.get(index) : null) : { verdict: "", said: [] };
    });
  },

  show() {
    const typed = check.typed(), found = check.verdicts(typed);
    all("#check .asked").forEach((node, index) => {
      node.dataset.verdict = found[index].verdict;
      one(".said", node).innerHTML = found[index].said.map(check.sentence).join(`<span class="zh">；</span><span class="en">; </span>`) + check.by(index, typed[index], found[index]);
    });
  },

  reveal() {
    all("#check .asked").forEach((node, index) => { one(".said", node).textContent = check.rule.rows[index].shown; node.dataset.verdict = ""; });
  },
};
one("#check form").onsubmit = (event) => { event.preventDefault(); check.show(); };
one("#reveal").onclick = () => check.reveal();
