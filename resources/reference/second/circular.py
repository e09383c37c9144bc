# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Circles: ISO 230-4. Points in extended precision; least squares by Gauss-Newton; the minimum zone as a linear
programme in centre and radii, solved by adding violated points, linearized anew until it stands still. In a simulation
the programmes of all trials are solved at once, by the dual simplex method from one common basis."""
import itertools
import math
from fractions import Fraction

import mpmath
import numpy as np

from common import fraction, mp

LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")


class Path:
    """An arc as measured: nominal radius + radial deviation at its angles."""

    def __init__(self, arc, radius):
        self.sense = arc["sense"]
        self.nominal = radius
        degrees = np.array([LONG(str(a)) for a in arc["angles"]])
        self.angle = degrees * PI / 180
        self.read = LONG(str(radius)) + np.array([LONG(str(d)) for d in arc["radialDeviations"]])
        self.rho = self.read
        self.is_commanded = arc.get("angleReference", "polar") == "commanded"
        steps = np.abs(np.diff(degrees))
        gap = 360 - abs(float(degrees[-1] - degrees[0]))
        self.is_full = gap <= 2 * float(steps.max())

    def points(self):
        return np.array([self.rho * np.cos(self.angle), self.rho * np.sin(self.angle)])


def least_squares(paths):
    """Centre and radius, every path with equal weight."""
    points = np.concatenate([path.points() for path in paths], axis=1)
    weight = np.concatenate([np.full(len(path.angle), LONG(1) / len(path.angle)) for path in paths])
    centre = np.array([LONG(0), LONG(0)])
    radius = LONG(0)
    for _ in range(30):
        d = points - centre[:, None]
        r = np.sqrt((d ** 2).sum(0))
        columns = np.array([-d[0] / r, -d[1] / r, np.full(len(r), LONG(-1))])
        rest = r - radius
        step = solved((columns * weight) @ columns.T, -(columns * weight) @ rest)
        centre = centre + step[:2]
        radius = radius + step[2]
        if np.abs(step).max() < 1e-18:
            break
    return centre, radius


def solved(matrix, right):
    """Elimination in the precision of its numbers (numpy.linalg knows double only)."""
    a = np.concatenate([matrix, right[:, None]], axis=1)
    n = len(right)
    for i in range(n):
        p = i + int(np.argmax(np.abs(a[i:, i])))
        a[[i, p]] = a[[p, i]]
        a[i] = a[i] / a[i, i]
        for k in range(n):
            if k != i:
                a[k] = a[k] - a[k, i] * a[i]
    return a[:, n]


def rebuild(paths, radius):
    """Commanded angles: one centring error e for all arcs, from r ≈ |R·u(θ) − e| with R one per arc and arcs of equal
    weight; then ρ = e·u + √(r² − (e×u)²)."""
    e = np.array([LONG(0), LONG(0)])
    radii = [LONG(str(radius)) for _ in paths]
    for _ in range(40):
        rows, rest, weight = [], [], []
        for k, path in enumerate(paths):
            u = np.array([np.cos(path.angle), np.sin(path.angle)])
            d = radii[k] * u - e[:, None]
            model = np.sqrt((d ** 2).sum(0))
            own = np.zeros((len(paths), len(model)), dtype=LONG)
            own[k] = (d * u).sum(0) / model
            rows.append(np.concatenate([[-d[0] / model, -d[1] / model], own]))
            rest.append(path.read - model)
            weight.append(np.full(len(model), LONG(1) / len(model)))
        columns, rest, weight = np.concatenate(rows, axis=1), np.concatenate(rest), np.concatenate(weight)
        step = solved((columns * weight) @ columns.T, (columns * weight) @ rest)
        e = e + step[:2]
        radii = [r + s for r, s in zip(radii, step[2:])]
        if np.abs(step).max() < 1e-18:
            break
    for path in paths:
        u = np.array([np.cos(path.angle), np.sin(path.angle)])
        along, across = (e[:, None] * u).sum(0), e[0] * u[1] - e[1] * u[0]
        path.rho = along + np.sqrt(path.read ** 2 - across ** 2)


def minimum_zone(points):
    """Width of the minimum zone circles: min over c of max r − min r. The linearized problem: smallest w with
    b <= r_i − n_i·δ <= b + w for all i."""
    centre = points.mean(1)
    for _ in range(30):
        d = points - centre[:, None]
        r = np.sqrt((d ** 2).sum(0))
        step = small_programme(d / r, r)
        centre = centre + step
        if np.abs(step).max() < 1e-15:
            break
    r = np.sqrt(((points - centre[:, None]) ** 2).sum(0))
    return r.max() - r.min()


def small_programme(normals, r):
    """δ that minimizes the span of r − n·δ: the programme on a few points, to which the extremes of all are added until
    none lies outside."""
    chosen = list({int(i) for k in range(8)
                   for i in extremes_in(normals, r, k * math.pi / 4, (k + 1) * math.pi / 4)})
    while True:
        delta, width = enumerated(normals[:, chosen], r[chosen])
        left = r - normals.T @ delta
        more = [i for i in (int(left.argmax()), int(left.argmin())) if i not in chosen]
        if not more or left.max() - left.min() <= width * (1 + LONG(1e-15)) + LONG(1e-19):
            return delta
        chosen = tight(normals, r, chosen, delta) + more


def tight(normals, r, chosen, delta):
    """Those of the chosen that touch, and a few more."""
    left = r[chosen] - normals[:, chosen].T @ delta
    order = np.argsort(left)
    keep = set(order[:5]) | set(order[-5:])
    return [chosen[k] for k in sorted(keep)]


def extremes_in(normals, r, low, high):
    angle = np.arctan2(normals[1].astype(float), normals[0].astype(float)) % (2 * math.pi)
    inside = np.nonzero((angle >= low) & (angle < high))[0]
    return [] if not len(inside) else [inside[r[inside].argmax()], inside[r[inside].argmin()]]


OUTER = np.array([(1, 1, 0, 0), (1, 0, 1, 0), (1, 0, 0, 1), (0, 1, 1, 0), (0, 1, 0, 1), (0, 0, 1, 1)], dtype=float)


def enumerated(normals, r):
    """The optimum of the programme has four active constraints, two outer and two inner contacts: of all such fours
    with every point inside, the least width. Found in double, computed in extended precision."""
    fours = np.array(list(itertools.combinations(range(len(r)), 4)))
    base = r.mean()
    n, low = normals.astype(float), (r - base).astype(float)
    rows = np.empty((len(fours), len(OUTER), 4, 4))
    rows[..., 0] = n[0][fours][:, None, :]
    rows[..., 1] = n[1][fours][:, None, :]
    rows[..., 2] = 1
    rows[..., 3] = OUTER[None]
    rows = rows.reshape(-1, 4, 4)
    right = np.repeat(low[fours], len(OUTER), axis=0)
    # The determinants along their last column: areas of three points, the same for all ways to be outer.
    px, py = n[0][fours].T, n[1][fours].T
    area = lambda a, b, c: (px[b] - px[a]) * (py[c] - py[a]) - (px[c] - px[a]) * (py[b] - py[a])
    minors = np.stack([-area(1, 2, 3), area(0, 2, 3), -area(0, 1, 3), area(0, 1, 2)], 1)
    regular = np.abs(minors @ OUTER.T).ravel() > 1e-9
    which = np.nonzero(regular)[0]
    x = np.linalg.solve(rows[which], right[which][..., None])[..., 0]
    which, x = which[x[:, 3] >= 0], x[x[:, 3] >= 0]
    left = low[None] - x[:, :2] @ n - x[:, 2:3]
    x[(left.min(1) < -1e-13) | (left.max(1) > x[:, 3] + 1e-13), 3] = np.inf
    at = int(which[x[:, 3].argmin()])
    four, outer = fours[at // len(OUTER)], OUTER[at % len(OUTER)]
    exact = np.array([[normals[0, i], normals[1, i], LONG(1), LONG(o)] for i, o in zip(four, outer)])
    best = solved(exact, r[four])
    return best[:2], best[3]


def zone_widths(normals, deviations):
    """Widths of the minimum zones of many trials with small deviations (trials × points) from one circle: smallest w with
    b <= d_i − n_i·δ <= b + w. Four constraints are active, at first at four points along the path: whatever the
    deviations, these have multipliers >= 0, so that the dual simplex method starts there."""
    n = normals.shape[1]
    one = np.ones(n)
    rows = np.concatenate([np.stack([*normals, one, 0 * one], 1), np.stack([*-normals, -one, -one], 1)])  # rows·x <= right
    right = np.concatenate([deviations, -deviations], 1)
    order = np.argsort(np.unwrap(np.arctan2(normals[1], normals[0])), kind="stable")
    first = [order[k * (n - 1) // 4] for k in range(4)]
    active = np.tile([first[0], n + first[1], first[2], n + first[3]], (len(deviations), 1))
    widths = np.full(len(deviations), np.nan)
    open_ = np.arange(len(deviations))
    for _ in range(200):
        basis = rows[active[open_]]
        x = np.linalg.solve(basis, np.take_along_axis(right[open_], active[open_], 1)[..., None])[..., 0]
        excess = x @ rows.T - right[open_]
        enters = excess.argmax(1)
        done = excess.max(1) <= 1e-13
        widths[open_[done]] = x[done, 3]
        open_, enters, basis = open_[~done], enters[~done], basis[~done]
        if not len(open_):
            return widths
        transposed = np.swapaxes(basis, 1, 2)
        multipliers = np.linalg.solve(transposed, np.tile([0.0, 0.0, 0.0, -1.0], (len(open_), 1))[..., None])[..., 0]
        of_entering = np.linalg.solve(transposed, rows[enters][..., None])[..., 0]
        ratio = np.where(of_entering > 1e-12, multipliers / np.where(of_entering > 1e-12, of_entering, 1), np.inf)
        active[open_, ratio.argmin(1)] = enters
    raise ArithmeticError("no minimum zone")


def zone_width(paths):
    return minimum_zone(np.concatenate([path.points() for path in paths], axis=1))


def range_about_least_squares(paths):
    centre, _ = least_squares(paths)
    points = np.concatenate([path.points() for path in paths], axis=1)
    r = np.sqrt(((points - centre[:, None]) ** 2).sum(0))
    return r.max() - r.min()


class Circle:
    """A circular test of a file: first path of each sense, results in mm."""

    def __init__(self, test, arcs=None):
        self.test = test
        self.radius = test["nominalRadius"]
        every = [Path(arc, self.radius) for arc in test["arcs"]]
        if every[0].is_commanded:
            rebuild(every, self.radius)
        self.paths = []
        for path in every if arcs is None else [every[i] for i in arcs]:
            if path.sense not in [p.sense for p in self.paths]:
                self.paths.append(path)
        self.is_feedback = test.get("source") == "feedback"
        self.correction = self.to20() if test["conditions"].get("correctionTo20") == "applied here" else Fraction(0)

    def temperature(self, of):
        both = [fraction(sensor[key]) for sensor in self.test["conditions"]["sensors"] if sensor["measures"] == of
                for key in ("start", "end")]
        return sum(both) / len(both)

    def to20(self):
        """C = R·[α_i(T_i − 20) − α_m(T_m − 20)]"""
        expansion = self.test["conditions"]["expansion"]
        part = lambda of: fraction(expansion[of]) / 10 ** 6 * (self.temperature(of) - 20)
        return fraction(self.radius) * (part("instrument") - part("machine"))

    def index(self, path):
        first, second = self.test["plane"]["first"], self.test["plane"]["second"]
        return first + second if path.sense == "counterclockwise" else second + first

    def results(self):
        """{id: value}."""
        test, result = self.test, {}
        width = range_about_least_squares if test.get("referenceCircle") == "leastSquares" else zone_width
        mark = "f" if self.is_feedback else ""
        for path in self.paths:
            result[f"G{mark}_{self.index(path)}"] = width([path])
        pair = len(self.paths) == 2
        if pair and test["edition"] != "ISO 230-4:1996":
            result[f"G(b){mark}_{self.index(self.paths[0])}"] = width(self.paths)
        if self.is_feedback:
            return result
        shift = LONG(str(mp(self.correction)))
        for path in self.paths:
            if test.get("centring") == "instrument":
                deviations = path.read - LONG(str(self.radius))
            elif path.is_full:
                centre, _ = least_squares([path])
                deviations = np.sqrt(((path.points() - centre[:, None]) ** 2).sum(0)) - LONG(str(self.radius))
            else:
                continue
            result[f"Fmax_{self.index(path)}"] = deviations.max() + shift
            result[f"Fmin_{self.index(path)}"] = deviations.min() + shift
        if pair and all(path.is_full for path in self.paths) and test["edition"] != "ISO 230-4:1996":
            _, radius = least_squares(self.paths)
            result[f"D_{self.index(self.paths[0])}"] = radius - LONG(str(self.radius)) + shift
        if self.has_hysteresis():
            centre, _ = least_squares(self.paths)
            r = [np.sqrt(((path.points() - centre[:, None]) ** 2).sum(0)) for path in self.paths]
            result[f"H_{self.index(self.paths[0])}"] = np.abs(self.differences(r)).max()
        return result

    def has_hysteresis(self):
        return (self.test["edition"] == "ISO 230-4:1996" and not self.is_feedback and len(self.paths) == 2
                and all(path.is_full for path in self.paths))

    def differences(self, of_paths):
        """First path minus second, at the same angle; the last axis goes along the paths."""
        order = [np.argsort(np.round(np.degrees(path.angle.astype(float)), 6) % 360) for path in self.paths]
        first, second = (values[..., k] for values, k in zip(of_paths, order))
        return first - second

    # --- uncertainty (4.6, combined by propagation) ---

    def of_repetitions(self):
        """u_rep: s of each result over the circles measured again, µm. Each is measured once in each sense."""
        arcs = self.test["arcs"]
        senses = [[k for k, arc in enumerate(arcs) if arc["sense"] == path.sense] for path in self.paths]
        every = [Circle(self.test, once).results() for once in zip(*senses)]
        spread = lambda x: np.sqrt(((x - x.mean()) ** 2).sum() / (len(x) - 1))
        return {name: mpmath.mpf(str(spread(np.array([one[name] for one in every])))) * 1000 for name in every[0]}

    def squares(self, name=None):
        """Squares of the standard uncertainties, µm²."""
        u = self.test["uncertainty"]
        number = lambda value: fraction(value)
        parts = {"device": (number(u["displacement"]["expanded"]) / number(u["displacement"]["coverageFactor"])) ** 2
                 + number(u["resolution"]) ** 2 / 12,
                 "drift": number(u["environmentalVariation"]) ** 2 / 12}
        if u.get("repeatability") is not None:
            parts["repeatability"] = number(u["repeatability"]) ** 2
        elif name is not None:
            parts["repeatability"] = self.of_repetitions()[name] ** 2
        length = self.test["referenceLength"]
        if length.get("expandedUncertainty") is not None:
            parts["length"] = (number(length["expandedUncertainty"]) / number(length["coverageFactor"])) ** 2
            parts["correction"] = self.square_of_correction()
        if u.get("pointNoise") is not None:
            parts["noise"] = number(u["pointNoise"]) ** 2 / sum(len(path.angle) for path in self.paths)
        if u.get("centring") is not None:
            parts["centring"] = number(u["centring"]) ** 2
        return parts

    def square_of_correction(self):
        """u²(C), µm²; R in m, α in µm/(m·°C). One sensor for both: its error is common."""
        u, expansion = self.test["uncertainty"], self.test["conditions"]["expansion"]
        r = fraction(self.radius) / 1000
        alpha = {of: fraction(expansion[of]) for of in ("machine", "instrument")}
        u_t = {of: fraction(u["temperatureStandardUncertainty"][of]) for of in alpha}
        if u.get("sameSensor"):
            total = (alpha["instrument"] - alpha["machine"]) ** 2 * u_t["machine"] ** 2
        else:
            total = sum(alpha[of] ** 2 * u_t[of] ** 2 for of in alpha)
        for of in alpha:
            total += (self.temperature(of) - 20) ** 2 * fraction(u["expansionStandardUncertainty"][of]) ** 2
        return r ** 2 * total

    def uncertainty(self, name):
        """U (k = 2), mm."""
        parts = self.squares(name)
        uses = ["device", "drift", "repeatability"]
        if name[0] in "FD":
            uses += ["length", "correction"]
        if name[0] == "F" and self.test.get("centring") == "instrument":
            uses.append("centring")
        if name[0] == "D":
            uses.append("noise")
        return 2 * mpmath.sqrt(sum(mp(parts.get(key, Fraction(0))) for key in uses)) / 1000

    # --- JCGM 101, displacement known exactly ---

    def trials(self, count, seed):
        """Simulated values of every result. Errors are small: the centre follows them linearly, from the normal
        equations at the evaluated circle."""
        u = self.test["uncertainty"]
        random = np.random.Generator(np.random.PCG64(seed))
        common = {"length": 0.0, "correction": 0.0}
        parts = self.squares()
        names = list(self.results())
        blocks = []
        for _ in range(count // 10000):
            n = 10000
            errors = []
            for path in self.paths:
                size = (n, len(path.angle))
                errors.append((random.standard_normal(size) * float(u["pointNoise"])
                               + (random.random(size) - 0.5) * float(u["resolution"])
                               + (random.random((n, 1)) - 0.5) * float(u["environmentalVariation"])) / 1000)
            shared = {key: random.standard_normal(n) * math.sqrt(parts.get(key, 0)) / 1000 for key in common}
            blocks.append(self.evaluated(errors, sum(shared.values()), names))
        repeat = {name: math.sqrt(self.squares(name).get("repeatability", 0)) / 1000 for name in blocks[0]}
        together = {name: np.concatenate([block[name] for block in blocks]) for name in blocks[0]}
        return {name: y + random.standard_normal(len(y)) * repeat[name] for name, y in together.items()}

    def evaluated(self, errors, shared, names):
        result, width = {}, {}
        shift = float(mp(self.correction))
        for path, e in zip(self.paths, errors):
            d, _ = deviations_of([path], [e])
            index = self.index(path)
            result[f"G_{index}"] = self.widths([path], d)
            if path.is_full:
                result[f"Fmax_{index}"] = d.max(1) + shared + shift
                result[f"Fmin_{index}"] = d.min(1) + shared + shift
        if len(self.paths) == 2:
            d, radius = deviations_of(self.paths, errors)
            index = self.index(self.paths[0])
            if f"G(b)_{index}" in names:
                result[f"G(b)_{index}"] = self.widths(self.paths, d)
            result[f"D_{index}"] = radius + shared + shift
            if self.has_hysteresis():
                size = len(self.paths[0].angle)
                result[f"H_{index}"] = np.abs(self.differences([d[:, :size], d[:, size:]])).max(1)
        return {name: result[name] for name in names}

    def widths(self, paths, d):
        """Of the minimum zones or about the least squares circle, from deviations about the latter."""
        if self.test.get("referenceCircle") == "leastSquares":
            return d.max(1) - d.min(1)
        centre, _ = least_squares(paths)
        away = np.concatenate([path.points() for path in paths], axis=1) - centre[:, None]
        return zone_widths((away / np.sqrt((away ** 2).sum(0))).astype(float), d)


def deviations_of(paths, errors):
    """Deviations from the nominal radius about the least squares centre, and radius − nominal radius, by trial."""
    centre, radius = least_squares(paths)
    points = np.concatenate([path.points() for path in paths], axis=1)
    weight = np.concatenate([np.full(len(path.angle), 1 / len(path.angle)) for path in paths])
    d = points - centre[:, None]
    r = np.sqrt((d ** 2).sum(0))
    columns = np.array([d[0] / r, d[1] / r, np.ones(len(r))]).astype(float)
    e = np.concatenate(errors, axis=1)
    step = e @ (columns * weight).T @ np.linalg.inv((columns * weight) @ columns.T)
    # Deviations of the paths are counted from the nominal radius.
    nominal = LONG(str(paths[0].nominal))
    return (r - nominal).astype(float) + e - step[:, :2] @ columns[:2], float(radius - nominal) + step[:, 2]
