// From where the scene is seen: an orbit around a point. Lengths are the scene's, angles radians.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.sqrt(dot(a, a));
const unit = (a) => times(1 / (norm(a) || 1), a);
const between = (a, b, t) => add(a, times(t, sub(b, a)));
const isPoint = (p) => Array.isArray(p) && p.every(Number.isFinite);

const TAN = Math.tan(Math.PI / 12); // of half the vertical angle, as in viz/drawing/view.h
const STEEPEST = 1.55;
const up = isPoint(DATA.objects.up) ? unit(DATA.objects.up) : [0, 1, 0];
const ahead = unit(cross(Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], up));
const aside = cross(up, ahead);

const orbit = { azimuth: 0, elevation: 0.4, distance: 5, target: [0, 0, 0] };
let viewIsChosen = false;

function towards() {
  const { azimuth: a, elevation: e } = orbit;
  const flat = add(times(Math.cos(a), ahead), times(Math.sin(a), aside));
  return add(times(Math.cos(e), flat), times(Math.sin(e), up));
}

function startDirection() {
  const d = isPoint(DATA.objects.towards) ? unit(DATA.objects.towards) : unit([1, 0.5, 1]);
  orbit.elevation = Math.asin(Math.min(1, Math.max(-1, dot(d, up))));
  orbit.azimuth = Math.atan2(dot(d, aside), dot(d, ahead));
}

// The nearest place along the direction from which all points are seen: fitView of viz/drawing/view.h.
function fitOrbit(aspect) {
  const points = DATA.objects.fit.filter(isPoint);
  const back = towards(), right = unit(cross(up, back)), above = cross(back, right);
  if (!points.length) { orbit.target = [0, 0, 0]; orbit.distance = 5; return; }
  const left = TAN * aspect * 0.88, high = TAN * 0.86, low = TAN * 0.86;
  let mostRight = -Infinity, mostLeft = -Infinity, mostUp = -Infinity, mostDown = -Infinity, mostBack = -Infinity;
  for (const p of points) {
    const x = dot(p, right), y = dot(p, above), z = dot(p, back);
    mostRight = Math.max(mostRight, x + left * z);
    mostLeft = Math.max(mostLeft, -x + left * z);
    mostUp = Math.max(mostUp, y + high * z);
    mostDown = Math.max(mostDown, -y + low * z);
    mostBack = Math.max(mostBack, z);
  }
  const middle = times(1 / points.length, points.reduce(add));
  let z = Math.max((mostRight + mostLeft) / (2 * left), (mostUp + mostDown) / (high + low));
  z = Math.max(z, mostBack + 1e-3 * (1 + Math.abs(mostBack)));
  const x = (mostRight - mostLeft) / 2, y = (mostUp - high * z + low * z - mostDown) / 2;
  const eye = add(add(times(x, right), times(y, above)), times(z, back));
  orbit.distance = Math.max(1e-6, z - dot(middle, back));
  orbit.target = sub(eye, times(orbit.distance, back));
}

function viewText() {
  return [orbit.azimuth, orbit.elevation, orbit.distance, ...orbit.target].map((x) => Number(x.toPrecision(5))).join(",");
}

function readView(text) {
  const values = text.split(",").map(Number);
  if (text === "" || values.length !== 6 || !values.every(Number.isFinite) || !(values[2] > 0)) return false;
  orbit.azimuth = values[0];
  orbit.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, values[1]));
  orbit.distance = values[2];
  orbit.target = values.slice(3);
  return true;
}

// Points of space to pixels of a pane, y down; `depth` is along the viewing direction.
function projector(width, height) {
  const back = towards(), right = unit(cross(up, back)), above = cross(back, right);
  const eye = add(orbit.target, times(orbit.distance, back));
  const scale = height / (2 * TAN), nearest = 1e-3 * orbit.distance;
  const coordinates = (p) => { const d = sub(p, eye); return [dot(d, right), dot(d, above), -dot(d, back)]; };
  const place = ([x, y, z]) => [width / 2 + (scale * x) / z, height / 2 - (scale * y) / z];
  return {
    eye, scale, coordinates, right, above, back,
    point(p) {
      const c = coordinates(p);
      return c[2] > nearest ? place(c) : null;
    },
    depth: (p) => coordinates(p)[2],
    // The part before the viewer, and which part of the whole that is.
    line(from, to) {
      let a = coordinates(from), b = coordinates(to), s = 0, t = 1;
      if (a[2] <= nearest && b[2] <= nearest) return null;
      const cut = (nearest * 1.001 - a[2]) / (b[2] - a[2]);
      if (a[2] <= nearest) { s = cut; a = between(a, b, s); }
      else if (b[2] <= nearest) { t = cut; b = between(a, b, t); }
      return { from: place(a), to: place(b), s, t };
    },
    // The outline of a sphere is an ellipse: centre, half axes, and the angle of the longer one.
    sphere(centre, radius) {
      const c = coordinates(centre), far = norm(c), q = (radius / far) ** 2;
      if (!(far > radius * 1.0001) || c[2] <= 0) return null;
      const offset = Math.hypot(c[0], c[1]), sin = offset / far, cos = c[2] / far, a = 1 - q - sin * sin;
      if (!(a > 1e-4)) return null;
      const along = (sin * cos) / a, x = offset ? c[0] / offset : 1, y = offset ? c[1] / offset : 0;
      return {
        x: width / 2 + scale * along * x, y: height / 2 - scale * along * y,
        long: (scale * Math.sqrt((1 - q) * q)) / a, short: scale * Math.sqrt(q / a), angle: Math.atan2(-y, x), depth: c[2],
      };
    },
  };
}
