// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/diagnosis/coverage.h"
#include "kernel/numerics/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Circles of a machine whose two axes move in the plane, with disturbances that the diagnosis does not
/// model: made apart from its columns, so that an error of theirs shows.
namespace palmer::testdata {

/// What the two axes do wrong; mm, rad, s.
struct Axes {
    double scale = 0, square = 0, lag = 0;
    std::array<double, 2> backlash{}, play{}, bow{}, spike{};
    double spikeWidth = 1.5; ///< degrees
};

/// A place on the path at a time.
struct Moment {
    double angle = 0; ///< commanded, rad
    double sense = 1;
    double time = 0;  ///< s, from the start of the first arc
    double turns = 0; ///< of the arc
    double x = 0;     ///< commanded, mm
    double y = 0;
    std::size_t arc = 0;
    std::size_t index = 0;
};

using Draws = std::mt19937_64;

inline double normal(Draws &draws) {
    return std::normal_distribution<double>()(draws);
}
inline double uniform(Draws &draws, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(draws);
}

/// One animal: how the points come to be.
struct Disturbance {
    using Shift = std::function<void(const Moment &, double &dx, double &dy)>; ///< of the table, mm
    using Radial = std::function<double(const Moment &)>;                      ///< into the reading, mm

    Shift moves;
    Radial reads;
    std::function<double(const Moment &)> noise = [](const Moment &) { return 2e-4; }; ///< σ, mm
    double correlation = 0;                          ///< of neighbouring readings
    double pink = 0;                                 ///< σ of 1/f noise, mm
    double walk = 0;                                 ///< σ of a step of a random walk, mm
    bool heavyTails = false;                         ///< Student's, 3 degrees of freedom
    double resolution = 0;                           ///< mm
    int smoothing = 1;                               ///< readings averaged by the instrument
    double turned = 0;                               ///< of all angles of the file, degrees
    bool commanded = false;                          ///< the file gives commanded angles
    Point offset{};                                  ///< of the instrument, mm
    double windUp = 0;                               ///< backlash is traversed over this angle, degrees
    std::set<std::pair<InfluenceId, PlaneAxis>> has; ///< sources of the model that are there beside `axes`
    double onePitch = 0;                             ///< of the periodic deviation that is there, mm
};

struct Animal {
    const char *name;
    /// Sets the disturbance; may change the axes. `turn` is the angular step, degrees.
    void (*make)(Disturbance &, Axes &, Draws &);
};

constexpr double zooRadius = 150;       ///< mm
constexpr double zooFeed = 1000.0 / 60; ///< mm/s

/// 1/f noise: a sum of first-order noises an octave apart.
class Pink {
public:
    double next(Draws &draws) {
        double sum = 0;
        for (std::size_t k = 0; k < m_parts.size(); ++k) {
            const double phi = 1 - std::exp2(-static_cast<double>(k));
            m_parts[k] =
                m_started ? phi * m_parts[k] + std::sqrt(1 - phi * phi) * normal(draws) : normal(draws);
            sum += m_parts[k];
        }
        m_started = true;
        return sum / std::sqrt(static_cast<double>(m_parts.size()));
    }

private:
    std::array<double, 12> m_parts{};
    bool m_started = false;
};

inline double degreesFrom(double angle, double reversal) {
    return std::remainder(angle / degree - reversal, 360);
}

/// Angle travelled since the last reversal of an axis (0: X at 0° and 180°), degrees.
inline double travelledSince(const Moment &at, int axis) {
    double since = at.sense * (at.angle / degree - (axis == 0 ? 0 : 90));
    since -= std::floor(since / 180) * 180;
    return since;
}

/// Position of the table by the faults of the axes.
inline Point reached(const Axes &axes, const Moment &at, double windUp) {
    const double lagged = at.angle - at.sense * axes.lag / 2 * zooFeed / zooRadius;
    const double ahead = at.angle + at.sense * axes.lag / 2 * zooFeed / zooRadius;
    const double x = zooRadius * std::cos(lagged); // X later than Y
    const double y = zooRadius * std::sin(ahead);
    const double toX = -at.sense * std::sin(at.angle) >= 0 ? 1 : -1; // direction of travel
    const double toY = at.sense * std::cos(at.angle) >= 0 ? 1 : -1;
    const auto taken = [&](int axis) { // part of the backlash taken up: −1 at the reversal, 1 after it
        return windUp > 0 ? 1 - 2 * std::max(0.0, 1 - travelledSince(at, axis) / windUp) : 1.0;
    };
    const auto bow = [](double along) { return along * along / (zooRadius * zooRadius) - 0.5; };
    Point p{x * (1 + axes.scale / 2), y * (1 - axes.scale / 2)};
    p.x -= y * axes.square;
    p.x -= toX * axes.backlash[0] / 2 * taken(0);
    p.y -= toY * axes.backlash[1] / 2 * taken(1);
    p.y += toX * axes.play[0] / 2;
    p.x += toY * axes.play[1] / 2;
    p.y += axes.bow[0] * bow(x);
    p.x += axes.bow[1] * bow(y);
    const double outX = std::cos(at.angle) >= 0 ? 1 : -1;
    const double outY = std::sin(at.angle) >= 0 ? 1 : -1;
    p.x += outX * axes.spike[0] * std::exp(-travelledSince(at, 0) / axes.spikeWidth);
    p.y += outY * axes.spike[1] * std::exp(-travelledSince(at, 1) / axes.spikeWidth);
    return p;
}

/// Each fault is there in one machine of two.
inline Axes drawnAxes(Draws &draws) {
    const auto some = [&](double most) { return draws() % 2 == 0 ? 0 : uniform(draws, -most, most); };
    Axes axes;
    axes.scale = some(40e-6);
    axes.square = some(30e-6);
    axes.lag = some(3e-4);
    for (const std::size_t k : {0U, 1U}) {
        axes.backlash[k] = some(6e-3);
        axes.play[k] = some(2e-3);
        axes.bow[k] = some(4e-3);
    }
    return axes;
}

/// What one circle came to.
struct ZooCircle {
    Axes axes;
    Disturbance by;
    CircularMeasurement measurement;
};

inline ZooCircle zooCircle(const Animal &animal, unsigned seed, std::size_t points) {
    Draws draws(seed * 7919U + 17U);
    ZooCircle circle;
    circle.axes = drawnAxes(draws);
    animal.make(circle.by, circle.axes, draws);
    const Disturbance &by = circle.by;
    CircularMeasurement &m = circle.measurement;
    m.plane = {"X", "Y"};
    m.nominalRadius = zooRadius;
    m.feed = zooFeed * 60;
    const double start = std::array{0.0, 45.0, 90.0, 200.0}[draws() % 4];
    double time = 0;
    for (const double sense : {1.0, -1.0}) {
        Arc arc;
        arc.sense = sense > 0 ? Sense::counterclockwise : Sense::clockwise;
        arc.angleReference = by.commanded ? AngleReference::commanded : AngleReference::polar;
        Pink pink;
        double coloured = normal(draws);
        double walk = 0;
        std::vector<double> readings;
        const double step = 360 / static_cast<double>(points);
        for (std::size_t i = 0; i < points; ++i) {
            Moment at;
            at.arc = sense > 0 ? 0 : 1;
            at.index = i;
            at.sense = sense;
            at.turns = static_cast<double>(i) / static_cast<double>(points);
            at.angle = (start + sense * (static_cast<double>(i) + 0.37) * step) * degree;
            at.time = time + at.turns * 2 * std::numbers::pi * zooRadius / zooFeed;
            at.x = zooRadius * std::cos(at.angle);
            at.y = zooRadius * std::sin(at.angle);
            Point p = reached(circle.axes, at, by.windUp);
            if (by.moves)
                by.moves(at, p.x, p.y);
            p.x -= by.offset.x;
            p.y -= by.offset.y;
            double r = std::hypot(p.x, p.y) - zooRadius + (by.reads ? by.reads(at) : 0);
            const double white =
                by.heavyTails ? std::student_t_distribution<double>(3)(draws) / std::sqrt(3) : normal(draws);
            coloured = by.correlation * coloured + std::sqrt(1 - by.correlation * by.correlation) * white;
            walk += by.walk * normal(draws);
            r += by.noise(at) * coloured + walk + by.pink * (by.pink > 0 ? pink.next(draws) : 0);
            readings.push_back(r);
            // A ballbar does not know where it stands: its angles are those of the program.
            const double angle = by.commanded ? at.angle
                                              : at.angle + std::remainder(std::atan2(p.y, p.x) - at.angle,
                                                                          2 * std::numbers::pi);
            arc.angles.push_back(angle / degree + by.turned);
        }
        for (std::size_t i = 0; i < points; ++i) {
            double sum = 0;
            const std::size_t first =
                i + 1 < std::size_t(by.smoothing) ? 0 : i + 1 - std::size_t(by.smoothing);
            for (std::size_t k = first; k <= i; ++k)
                sum += readings[k];
            const double mean = sum / static_cast<double>(i + 1 - first);
            arc.radialDeviations.push_back(
                by.resolution > 0 ? std::nearbyint(mean / by.resolution) * by.resolution : mean);
        }
        time += 2 * std::numbers::pi * zooRadius / zooFeed + 5;
        m.arcs.push_back(std::move(arc));
    }
    return circle;
}

// ---- The animals ------------------------------------------------------------------------------------------

inline double oneOf(Draws &draws) {
    return draws() % 2 == 0 ? 1 : -1;
}

inline void addWave(Disturbance &by, double perTurn, double amplitude, double phase,
                    bool oddInSense = false) {
    by.reads = [=](const Moment &at) {
        return amplitude * (oddInSense ? at.sense : 1) * std::cos(perTurn * at.angle + phase);
    };
}

inline void addVibration(Disturbance &by, double hertz, double amplitude, double phase) {
    by.reads = [=](const Moment &at) {
        return amplitude * std::sin(2 * std::numbers::pi * hertz * at.time + phase);
    };
}

inline void addPitch(Disturbance &by, PlaneAxis axis, double pitch, double amplitude, double phase) {
    const auto before = by.moves;
    by.moves = [=](const Moment &at, double &dx, double &dy) {
        if (before)
            before(at, dx, dy);
        (axis == PlaneAxis::first ? dx : dy) +=
            amplitude *
            std::sin(2 * std::numbers::pi * (axis == PlaneAxis::first ? at.x : at.y) / pitch + phase);
    };
    by.has.insert({InfluenceId::cyclic, axis});
    by.onePitch = pitch;
}

inline double reversalDistance(const Moment &at) { ///< degrees to the nearest
    return std::abs(std::remainder(at.angle / degree, 90));
}

/// In time from the start of the test, 0 … 1.
inline double partOfTest(const Moment &at) {
    return (static_cast<double>(at.arc) + at.turns) / 2;
}

inline const std::array animals{
    Animal{"white noise", [](Disturbance &, Axes &, Draws &) {}},
    Animal{"noise correlated 0.8", [](Disturbance &d, Axes &, Draws &) { d.correlation = 0.8; }},
    Animal{"1/f noise 0.4 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.pink = 4e-4;
               d.noise = [](const Moment &) { return 2e-5; };
           }},
    Animal{"random walk", [](Disturbance &d, Axes &, Draws &) { d.walk = 3e-5; }},
    Animal{"angles turned 0.3°, seen", [](Disturbance &d, Axes &, Draws &q) { d.turned = 0.3 * oneOf(q); }},
    Animal{"angles turned 0.08°, seen", [](Disturbance &d, Axes &, Draws &q) { d.turned = 0.08 * oneOf(q); }},
    Animal{"angles turned 0.3°, commanded",
           [](Disturbance &d, Axes &, Draws &q) {
               d.turned = 0.3 * oneOf(q);
               d.commanded = true;
           }},
    Animal{"angles turned 1.5°, commanded",
           [](Disturbance &d, Axes &, Draws &q) {
               d.turned = 1.5 * oneOf(q);
               d.commanded = true;
               d.offset = {0.05, -0.03};
           }},
    Animal{"fourth harmonic 1 µm",
           [](Disturbance &d, Axes &, Draws &q) { addWave(d, 4, 1e-3, q() % 2 == 0 ? 0 : uniform(q, 0, 6.28)); }},
    Animal{"fifth harmonic 2 µm", [](Disturbance &d, Axes &, Draws &q) { addWave(d, 5, 2e-3, uniform(q, 0, 6.28)); }},
    Animal{"sixth harmonic, other sign in each sense",
           [](Disturbance &d, Axes &, Draws &q) { addWave(d, 6, 1e-3, uniform(q, 0, 6.28), true); }},
    Animal{"one outlier of 6 µm",
           [](Disturbance &d, Axes &, Draws &q) {
               const std::size_t at = q() % 360;
               const double height = 6e-3 * oneOf(q);
               d.reads = [=](const Moment &m) { return m.arc == 0 && m.index == at ? height : 0.0; };
           }},
    Animal{"burst of 3 µm over 3°",
           [](Disturbance &d, Axes &, Draws &q) {
               const double at = uniform(q, 0, 360);
               d.reads = [=](const Moment &m) {
                   return m.arc == 1 && std::abs(degreesFrom(m.angle, at)) < 1.5 ? 3e-3 : 0.0;
               };
           }},
    Animal{"spike at one reversal only",
           [](Disturbance &d, Axes &, Draws &q) {
               const double at = 90 * double(q() % 4);
               d.reads = [=](const Moment &m) {
                   const double since = m.sense * degreesFrom(m.angle, at);
                   return m.arc == 0 && since >= 0 ? 4e-3 * std::exp(-since / 1.5) : 0.0;
               };
           }},
    Animal{"noise four times larger near reversals",
           [](Disturbance &d, Axes &, Draws &) {
               d.noise = [](const Moment &m) { return reversalDistance(m) < 5 ? 8e-4 : 2e-4; };
           }},
    Animal{"noise three times larger in one sense",
           [](Disturbance &d, Axes &, Draws &) {
               d.noise = [](const Moment &m) { return m.arc == 1 ? 6e-4 : 2e-4; };
           }},
    Animal{"noise growing with time",
           [](Disturbance &d, Axes &, Draws &) {
               d.noise = [](const Moment &m) { return 1e-4 + 5e-4 * partOfTest(m); };
           }},
    Animal{"heavy tails", [](Disturbance &d, Axes &, Draws &) { d.heavyTails = true; }},
    Animal{"periodic deviation Y 80 mm",
           [](Disturbance &d, Axes &, Draws &q) { addPitch(d, PlaneAxis::second, 80, 1.5e-3, uniform(q, 0, 6.28)); }},
    Animal{"periodic deviation X 37.3 mm",
           [](Disturbance &d, Axes &, Draws &q) { addPitch(d, PlaneAxis::first, 37.3, 1e-3, uniform(q, 0, 6.28)); }},
    Animal{"periodic deviation X 210 mm",
           [](Disturbance &d, Axes &, Draws &q) { addPitch(d, PlaneAxis::first, 210, 2e-3, uniform(q, 0, 6.28)); }},
    Animal{"periodic deviations X 10 mm, Y 16 mm",
           [](Disturbance &d, Axes &, Draws &q) {
               addPitch(d, PlaneAxis::first, 10, 1e-3, uniform(q, 0, 6.28));
               addPitch(d, PlaneAxis::second, 16, 1e-3, uniform(q, 0, 6.28));
               d.onePitch = 0;
           }},
    Animal{"two pitches on X, 8 mm and 20 mm",
           [](Disturbance &d, Axes &, Draws &q) {
               addPitch(d, PlaneAxis::first, 8, 1e-3, uniform(q, 0, 6.28));
               addPitch(d, PlaneAxis::first, 20, 1e-3, uniform(q, 0, 6.28));
               d.onePitch = 0;
           }},
    Animal{"vibration 0.07 Hz",
           [](Disturbance &d, Axes &, Draws &q) { addVibration(d, 0.07, 2e-3, uniform(q, 0, 6.28)); }},
    Animal{"vibration 0.4 Hz",
           [](Disturbance &d, Axes &, Draws &q) { addVibration(d, 0.4, 1e-3, uniform(q, 0, 6.28)); }},
    Animal{"vibration 5 Hz", [](Disturbance &d, Axes &, Draws &q) { addVibration(d, 5, 5e-4, uniform(q, 0, 6.28)); }},
    Animal{"quadratic drift 3 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.reads = [](const Moment &m) { return 3e-3 * partOfTest(m) * partOfTest(m); };
               d.has.insert({InfluenceId::radiusDrift, PlaneAxis::none}); // its straight part
           }},
    Animal{"warm-up 3 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.reads = [](const Moment &m) { return 3e-3 * std::exp(-partOfTest(m) / 0.15); };
           }},
    Animal{"linear drift of the radius 2 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.reads = [](const Moment &m) { return 2e-3 * partOfTest(m); };
               d.has.insert({InfluenceId::radiusDrift, PlaneAxis::none});
           }},
    Animal{"drift of the centre 3 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.moves = [](const Moment &m, double &dx, double &) { dx += 3e-3 * partOfTest(m); };
           }},
    Animal{"jump of 2 µm on the way",
           [](Disturbance &d, Axes &, Draws &q) {
               const double at = uniform(q, 0.1, 0.4);
               d.reads = [=](const Moment &m) { return partOfTest(m) > at ? 2e-3 : 0.0; };
           }},
    Animal{"resolution 0.5 µm, no dither",
           [](Disturbance &d, Axes &, Draws &) {
               d.resolution = 5e-4;
               d.noise = [](const Moment &) { return 2e-5; };
           }},
    Animal{"resolution 1 µm, noise 0.3 µm",
           [](Disturbance &d, Axes &, Draws &) {
               d.resolution = 1e-3;
               d.noise = [](const Moment &) { return 3e-4; };
           }},
    Animal{"radii of the senses 3 µm apart",
           [](Disturbance &d, Axes &, Draws &) {
               d.reads = [](const Moment &m) { return m.sense * 1.5e-3; };
           }},
    Animal{"smoothed over 5°", [](Disturbance &d, Axes &, Draws &) { d.smoothing = 10; }},
    Animal{"spikes of X",
           [](Disturbance &d, Axes &a, Draws &q) {
               a.spike[0] = 4e-3 * oneOf(q);
               d.has.insert({InfluenceId::reversalSpike, PlaneAxis::first});
           }},
    Animal{"backlash of X larger at one end",
           [](Disturbance &d, Axes &a, Draws &) {
               a.backlash[0] = 4e-3;
               d.moves = [](const Moment &m, double &dx, double &) {
                   const double to = -m.sense * std::sin(m.angle) >= 0 ? 1 : -1;
                   dx -= to * 1e-3 * m.x / zooRadius;
               };
           }},
    Animal{"backlash taken up over 2°",
           [](Disturbance &d, Axes &a, Draws &) {
               a.backlash = {5e-3, -3e-3};
               d.windUp = 2;
               d.has.insert({InfluenceId::reversalSpike, PlaneAxis::first});
               d.has.insert({InfluenceId::reversalSpike, PlaneAxis::second});
           }},
    Animal{"bend of the guideway, cubic",
           [](Disturbance &d, Axes &, Draws &) {
               d.moves = [](const Moment &m, double &, double &dy) {
                   const double u = m.x / zooRadius;
                   dy += 3e-3 * (u * u * u + u * u * u * u / 2);
               };
           }},
    Animal{"stick-slip, saw tooth of 1 µm",
           [](Disturbance &d, Axes &, Draws &q) {
               const double period = uniform(q, 0.4, 0.9); // s
               d.reads = [=](const Moment &m) { return 1e-3 * (m.time / period - std::floor(m.time / period) - 0.5); };
           }},
};

// ---- The counts -------------------------------------------------------------------------------------------

struct ZooCounts {
    int circles = 0;
    int notValid = 0;                   ///< the diagnosis itself says so
    int turned = 0;                     ///< it names a rotation
    int sources = 0;                    ///< of the machine, over all circles
    int intervals = 0;                  ///< of these with an interval
    int hits = 0;                       ///< with one that covers the truth
    int falseClaims = 0;                ///< circles that state with certainty what is not there
    std::map<std::string, int> claimed; ///< which, wrongly

    std::map<std::string, int> seen; ///< why not valid

    /// Sources whose interval covers the truth, or that are said to have none.
    [[nodiscard]] double held() const {
        return sources > 0 ? double(sources - intervals + hits) / sources : 1;
    }
};

/// Returns the true value of a source; null for centre and radius, which also take up what the bows leave.
inline std::optional<double> truthOf(const ZooCircle &circle, const SourceEstimate &source) {
    const Axes &axes = circle.axes;
    const std::size_t k = source.axis == PlaneAxis::second;
    switch (source.id) {
    case InfluenceId::scaleMismatch:
        return axes.scale;
    case InfluenceId::squareness:
        return axes.square;
    case InfluenceId::servoMismatch:
        return axes.lag;
    case InfluenceId::backlash:
        return axes.backlash[k];
    case InfluenceId::lateralPlay:
        return axes.play[k];
    case InfluenceId::straightness:
        return axes.bow[k];
    case InfluenceId::reversalSpike:
        return circle.by.windUp > 0 ? std::nullopt : std::optional(axes.spike[k]); // a dent that comes back
    default:
        return std::nullopt;
    }
}

/// True if a source is stated although it is not there: its interval does not even hold 0 when doubled, or it
/// was found and has an interval.
inline bool isFalseClaim(const ZooCircle &circle, const SourceEstimate &source) {
    const auto interval = source.interval();
    if (!interval)
        return false;
    const auto truth = truthOf(circle, source);
    if (truth) {
        const double half = (interval->to - interval->from) / 2;
        return *truth == 0 && (interval->from > half || interval->to < -half);
    }
    if (!source.proposed)
        return false;
    const bool there = circle.by.has.contains({source.id, source.axis});
    const bool pitch =
        !source.pitch || circle.by.onePitch == 0 || std::abs(*source.pitch / circle.by.onePitch - 1) < 0.1;
    return !there || !pitch;
}

inline void count(ZooCounts &counts, const ZooCircle &circle, const Diagnosis &diagnosis) {
    ++counts.circles;
    counts.notValid += !diagnosis.modelFits;
    counts.turned += diagnosis.rotation.isStated();
    for (const Message &reason : diagnosis.reasons)
        ++counts.seen[reason.text.source];
    bool wrong = false;
    for (const SourceEstimate &source : diagnosis.sources) {
        const auto truth = truthOf(circle, source);
        if (isFalseClaim(circle, source)) {
            wrong = true;
            ++counts.claimed[std::string(influence(source.id).word) +
                             (source.axis == PlaneAxis::none ? "" : ":" + source.axisName)];
        }
        if (!truth)
            continue;
        ++counts.sources;
        const auto interval = source.interval();
        counts.intervals += interval.has_value();
        counts.hits += interval && interval->from <= *truth && *truth <= interval->to;
    }
    counts.falseClaims += wrong;
}

inline ZooCounts zooCounts(const Animal &animal, unsigned trials, std::size_t points) {
    ZooCounts counts;
    for (unsigned seed = 1; seed <= trials; ++seed) {
        const ZooCircle circle = zooCircle(animal, seed, points);
        const MadeCircle made(circle.measurement);
        count(counts, circle, diagnose(made.circle()));
    }
    return counts;
}

} // namespace palmer::testdata
