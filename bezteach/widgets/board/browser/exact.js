// Exact numbers: a fraction is [p, q] in BigInt, with q > 0 and nothing to cancel.

const gcd = (a, b) => (b ? gcd(b, a % b) : a < 0n ? -a : a);
const fraction = (p, q = 1n) => {
  const common = gcd(p, q) * (q < 0n ? -1n : 1n);
  return [p / common, q / common];
};
const read = (text) => fraction(...String(text).split("/").map(BigInt));
const write = ([p, q]) => (q === 1n ? `${p}` : `${p}/${q}`);
const plus = ([a, b], [c, d]) => fraction(a * d + c * b, b * d);
const times = ([a, b], [c, d]) => fraction(a * c, b * d);
const minus = (x, y) => plus(x, times([-1n, 1n], y));
const value = (text) => {
  const [p, q] = read(text);
  return Number(p) / Number(q);
};
const mix = (x, y, t) => plus(times(minus([1n, 1n], t), x), times(t, y));
const mixed = (p, q, t) => p.map((text, axis) => write(mix(read(text), read(q[axis]), t)));

export function elevated(points) {
  const n = points.length;
  return Array.from({ length: n + 1 }, (_, j) =>
    mixed(points[Math.min(j, n - 1)], points[Math.max(j - 1, 0)], fraction(BigInt(j), BigInt(n))),
  );
}

export function exactLevels(points, t) {
  const levels = [points];
  while (levels.at(-1).length > 1) {
    const level = levels.at(-1);
    levels.push(level.slice(1).map((q, j) => mixed(level[j], q, read(t))));
  }
  return levels;
}
