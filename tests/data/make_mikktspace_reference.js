// Writes mikktspace_reference.txt: a small mesh of our own, with the tangents that the reference implementation of
// MikkTSpace gives it. Needs the npm package "mikktspace" (the reference compiled to WebAssembly, version 1.1.1):
//   npm install mikktspace && node make_mikktspace_reference.js > mikktspace_reference.txt
const { generateTangents } = require('mikktspace');

const corners = []; // [position, normal, uv]
const unit = (v) => v.map((x) => x / Math.hypot(...v));
const triangle = (a, b, c) => corners.push(a, b, c);

// A hilly patch with smooth normals. Its texture is mirrored about x = 0 and sheared, so orientations meet there.
const height = (x, z) => 0.4 * Math.sin(2.1 * x + 0.3) * Math.cos(1.7 * z);
const hill = (i, j) => {
  const x = (i - 3) / 3, z = (j - 3) / 3, e = 1e-3;
  const slope = [(height(x + e, z) - height(x - e, z)) / (2 * e), (height(x, z + e) - height(x, z - e)) / (2 * e)];
  return [[x, height(x, z), z], unit([-slope[0], 1, -slope[1]]), [Math.abs(x) + 0.2 * z, 0.8 * z + 0.1 * x * x]];
};
for (let j = 0; j < 6; ++j) {
  for (let i = 0; i < 6; ++i) {
    const a = hill(i, j), b = hill(i, j + 1), c = hill(i + 1, j), d = hill(i + 1, j + 1);
    triangle(a, b, c);
    triangle(c, b, d);
  }
}

// A cone whose tip has one uv for all faces: directions of u turn once around the tip.
const rim = (k) => {
  const angle = (2 * Math.PI * k) / 7;
  return [[5 + Math.cos(angle), 0, Math.sin(angle)], unit([Math.cos(angle), 1, Math.sin(angle)]), [k / 7, 1]];
};
const tip = [[5, 1, 0], [0, 1, 0], [0.5, 0]];
for (let k = 0; k < 7; ++k) triangle(tip, rim(k + 1), rim(k));

// A strip with one face that has no area in the texture, and a triangle with no area in space beside it.
const strip = [0, 1, 2, 3, 4, 5].map((k) => [
  [9 + 0.5 * k, 0.1 * k * k, k % 2], unit([-0.1 * k, 1, 0.05 * k]), k === 3 ? [0.4, 0] : [0.2 * k, 0.5 * (k % 2)]]);
triangle(strip[0], strip[1], strip[2]);
triangle(strip[2], strip[1], [strip[3][0], strip[3][1], strip[2][2]]);
triangle(strip[2], strip[3], strip[4]);
triangle(strip[4], strip[3], strip[5]);
triangle(strip[4], strip[4], strip[5]);

const part = (k) => Float32Array.from(corners.flatMap((corner) => corner[k]));
const [positions, normals, uv] = [part(0), part(1), part(2)];
const tangents = generateTangents(positions, normals, uv);
console.log('# Made by make_mikktspace_reference.js. A line a corner, three corners a triangle:');
console.log('# position (3), normal (3), uv (2), tangent (4, as the reference implementation gives it)');
for (let i = 0; i < corners.length; ++i) {
  const row = [...positions.slice(3 * i, 3 * i + 3), ...normals.slice(3 * i, 3 * i + 3), ...uv.slice(2 * i, 2 * i + 2),
    ...tangents.slice(4 * i, 4 * i + 4)];
  console.log(row.map((x) => String(Number(x.toPrecision(9)))).join(' '));
}
