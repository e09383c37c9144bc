// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/diagnosis/pitchscan.h"

#include "kernel/numerics/lanes.h"

#include <cstddef>

namespace palmer {

namespace {

struct SineCosine {
    Lanes sine;
    Lanes cosine;
};

/// Sine and cosine of an angle in turns: whole turns subtracted, series of half the angle, doubled.
SineCosine ofTurns(Lanes turns) {
    const Lanes round(0x1.8p52);
    const Lanes x = (turns - ((turns + round) - round)) * 3.141592653589793;
    const Lanes q = x * x;
    const Lanes s =
        x * (Lanes(1.0) +
             q * (Lanes(-1.0 / 6) + q * (Lanes(1.0 / 120) + q * (Lanes(-1.0 / 5040) + q * (1.0 / 362880)))));
    const Lanes c = Lanes(1.0) + q * (Lanes(-1.0 / 2) +
                                      q * (Lanes(1.0 / 24) + q * (Lanes(-1.0 / 720) + q * (1.0 / 40320))));
    return {Lanes(2.0) * s * c, (c - s) * (c + s)};
}

double sum(const Lanes &lanes) {
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

} // namespace

double explainedByPitch(std::span<const double> along, std::span<const double> curve,
                        std::span<const double> squares, double periods) {
    Lanes b1(0.0);
    Lanes b2(0.0);
    Lanes a11(0.0);
    Lanes a12(0.0);
    Lanes all(0.0);
    // The remainder beyond multiples of four is too small to affect the choice of a pitch.
    for (std::size_t i = 0; i + Lanes::count <= along.size(); i += Lanes::count) {
        const SineCosine wave = ofTurns(Lanes::from(&along[i]) * periods);
        const Lanes v = Lanes::from(&curve[i]);
        const Lanes w = Lanes::from(&squares[i]);
        b1 += v * wave.sine;
        b2 += v * wave.cosine;
        a11 += w * wave.sine * wave.sine;
        a12 += w * wave.sine * wave.cosine;
        all += w;
    }
    const double s = sum(b1);
    const double c = sum(b2);
    const double ss = sum(a11);
    const double sc = sum(a12);
    const double cc = sum(all) - ss;
    const double determinant = ss * cc - sc * sc;
    return determinant > 0 ? (s * s * cc - 2 * s * c * sc + c * c * ss) / determinant : 0;
}

} // namespace palmer
