// What follows from one's own earlier answers; each answer is a polynomial in those that it rests on, all over their exact values.
const continued = {
  ROUNDS: 3,

  // Own values may be gone on from where they are within reach of the exact ones, or right by own values themselves.
  usable(index, given, trusted) {
    const row = check.rule.rows[index], mine = given[index];
    if (!mine || !mine.value || !row.x) return false;
    const ratio = Math.abs(mine.value / row.x);
    return trusted.has(index) || 1 / check.rule.reach <= ratio && ratio <= check.rule.reach;
  },

  // An answer over its exact value: one's own, or what follows; `used` gathers the own answers that it came from.
  // way: given, trusted, used; deep: a vector that own answers below it turn round counts backwards.
  ratio(index, way, seen) {
    const row = check.rule.rows[index], mine = way.given[index];
    if (continued.usable(index, way.given, way.trusted)) {
      way.used.add(index);
      const size = Math.abs(mine.value / row.x);
      if (row.kind === "ve") return way.deep && continued.turns(row, continued.value(index, { ...way, used: new Set() }, seen)) ? -size : size;
      return row.kind === "si" && mine.sense && mine.sense > 0 !== row.x > 0 ? -size : size;
    }
    if (mine || seen.has(index)) return 1;
    const found = continued.value(index, way, seen);
    if (!found) return 1;
    return row.kind !== "ve" ? found[0] : way.deep && continued.turns(row, found) ? -Math.hypot(...found) : Math.hypot(...found);
  },

  // Whether a vector points the other way than it should.
  turns(row, found) {
    if (!found || row.deg === null) return false;
    return found[0] * Math.cos(row.deg * Math.PI / 180) + found[1] * Math.sin(row.deg * Math.PI / 180) < 0;
  },

  value(index, own, seen) {
    const row = check.rule.rows[index], way = row.follows;
    if (!way) return null;
    const below = new Set([...seen, index]);
    const ratio = (source) => below.has(source) ? 1 : continued.ratio(source, own, below);
    const from = way.from.map((source) => way.sizes ? Math.abs(ratio(source)) : ratio(source));
    const sum = [0, 0];
    way.terms.forEach((term, n) => {
      const product = term.reduce((so, at) => at < from.length ? so * from[at] : so / from[at - from.length], 1);
      sum[0] += way.factors[n][0] * product;
      sum[1] += way.factors[n][1] * product;
    });
    return sum;
  },

  // What is to be held against an answer, by the own answers before it; null where there are none.
  target(index, given, trusted, deep) {
    const row = check.rule.rows[index], used = new Set();
    const found = continued.value(index, { given, trusted, used, deep }, new Set());
    if (!found || !used.size || !found.every(Number.isFinite)) return null;
    const size = row.kind === "ve" ? Math.hypot(...found) : found[0];
    const x = size * (row.kind === "ve" ? Math.abs(row.x) : row.x);
    const deg = row.kind === "ve" && row.deg !== null ? Math.atan2(found[1], found[0]) * 180 / Math.PI : null;
    return { x, t: Math.abs(x) * row.follows.share, deg, mm: row.mm ? row.mm * Math.abs(size) : null, used };
  },

  // The answers that are right by own values, each with the one of these that is farthest off.
  right(given) {
    const found = new Map();
    for (let round = 0; round < continued.ROUNDS; round++) {
      const trusted = new Set(found.keys());
      given.forEach((mine, index) => {
        if (!mine || found.has(index)) return;
        const row = check.rule.rows[index], was = check.weigh(row, mine, row);
        if (was === "right" || was === "unsaid") return;
        for (const target of [false, true].map((deep) => continued.target(index, given, trusted, deep))) {
          const own = target ? check.weigh(row, mine, target) : "wrong";
          if (["right", "unsaid"].includes(own) || own === "close" && was !== "close") found.set(index, continued.farthest(target.used, given));
        }
      });
      if (found.size === trusted.size) break;
    }
    return found;
  },

  farthest(used, given) {
    const off = (index) => Math.abs(Math.abs(given[index].value) - Math.abs(check.rule.rows[index].x)) / check.rule.rows[index].t;
    return [...used].reduce((one, other) => off(other) > off(one) ? other : one);
  },
};
