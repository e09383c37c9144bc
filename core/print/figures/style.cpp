// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/style.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palmer {

namespace {

struct Dashes {
    std::array<double, 4> lengths{}; ///< dash, gap, dash, gap in mm; unused: 0
};

struct RoleRow {
    FigureRole role = FigureRole::background;
    double width = 0; ///< mm; 0: no line
    Dashes dashes;
    QRgb paper = 0;
    QRgb light = 0;
    QRgb dark = 0;
};

constexpr Dashes solid{};

// clang-format off
constexpr std::array table{
    //                                width  dashes, mm               paper       light       dark
    RoleRow{FigureRole::background,       0,     solid,                   0xffffffff, 0xffffffff, 0xff181a1d},
    RoleRow{FigureRole::text,             0,     solid,                   0xff000000, 0xff3a4148, 0xffc9ced3},
    RoleRow{FigureRole::grid,             0.13,  solid,                   0xffdcdcdc, 0xffdcdfe2, 0xff34393e},
    RoleRow{FigureRole::zeroLine,         0.2,   solid,                   0xff9a9a9a, 0xff8b939a, 0xff7c848b},
    RoleRow{FigureRole::axis,             0.28,  solid,                   0xff000000, 0xff59626b, 0xffa4acb3},
    RoleRow{FigureRole::up,               0.45,  solid,                   0xff004488, 0xff004488, 0xff78aef0},
    RoleRow{FigureRole::down,             0.45,  {{2, 1}},                0xffb35c00, 0xffe07b00, 0xfff0a040},
    RoleRow{FigureRole::mean,             0.28,  {{2, 0.6, 0.3, 0.6}},    0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::upEdge,           0.17,  solid,                   0xff004488, 0xff004488, 0xff78aef0},
    RoleRow{FigureRole::downEdge,         0.17,  {{1.1, 0.7}},            0xffb35c00, 0xffe07b00, 0xfff0a040},
    RoleRow{FigureRole::upMarker,         0.12,  solid,                   0xffffffff, 0xffffffff, 0xff181a1d},
    RoleRow{FigureRole::downMarker,       0.32,  solid,                   0xffb35c00, 0xffe07b00, 0xfff0a040},
    RoleRow{FigureRole::reading,          0.15,  solid,                   0xffb35c00, 0xffe07b00, 0xfff0a040},
    RoleRow{FigureRole::dimension,        0.17,  solid,                   0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::leader,           0.11,  {{0.5, 0.4}},            0xff777777, 0xff777777, 0xff8b939a},
    RoleRow{FigureRole::counterclockwise, 0.24,  solid,                   0xff004488, 0xff004488, 0xff78aef0},
    RoleRow{FigureRole::clockwise,        0.52,  solid,                   0xffb35c00, 0xffe07b00, 0xfff0a040},
    RoleRow{FigureRole::ring,             0.13,  solid,                   0xffd6d6d6, 0xffdcdfe2, 0xff34393e},
    RoleRow{FigureRole::nominal,          0.28,  solid,                   0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::planeAxis,        0.2,   solid,                   0xff000000, 0xff3a4148, 0xffc9ced3},
    RoleRow{FigureRole::envelope,         0.24,  {{2.6, 0.8, 0.4, 0.8}},  0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::limit,            0.32,  {{1.2, 0.8}},            0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::centre,           0.5,   solid,                   0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::drift,            0.35,  solid,                   0xff004488, 0xff004488, 0xff78aef0},
    RoleRow{FigureRole::bar,              0,     solid,                   0xff004488, 0xffb1b6bb, 0xff5f666d},
    RoleRow{FigureRole::firstBar,         0,     solid,                   0xff004488, 0xff1f5fa8, 0xff6fa8e6},
    RoleRow{FigureRole::barGround,        0,     solid,                   0xffffffff, 0xfff4f5f6, 0xff23272b},
    RoleRow{FigureRole::histogram,        0,     solid,                   0xff5f86b4, 0xff1f5fa8, 0xff6fa8e6},
    RoleRow{FigureRole::histogramTail,    0,     solid,                   0xffc9d6e6, 0xffa9c3e0, 0xff3f5876},
    RoleRow{FigureRole::evaluated,        0.5,   solid,                   0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::trialMean,        0.3,   {{0.9, 0.7}},            0xff000000, 0xff202428, 0xffe6e8ea},
    RoleRow{FigureRole::guardBand,        0.13,  solid,                   0xff555555, 0xff59626b, 0xffa4acb3},
    RoleRow{FigureRole::guardFill,        0,     solid,                   0xffe4e4e4, 0xffe4e6e8, 0xff3a4046},
    RoleRow{FigureRole::synthetic,        0.3,   {{1.6, 0.9}},            0xff000000, 0xff7a3e9d, 0xffc79ae6},
    RoleRow{FigureRole::residual,         0.24,  solid,                   0xff000000, 0xff202428, 0xffe6e8ea},
};
// clang-format on

constexpr double bandOpacity = 0.12;

/// Thinner lines fade on a screen, mm (0.75 pixels at 96 dpi).
constexpr double thinnestOnScreen = 0.2;

/// Sets width and dashes, mm.
void setLine(QPen &pen, double width, const Dashes &dashes) {
    pen.setWidthF(width * pointsPerMillimetre);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(Qt::RoundCap);
    QList<double> pattern; // in pen widths, as Qt expects
    for (const double length : dashes.lengths) {
        if (length > 0)
            pattern.append(length / width);
    }
    if (!pattern.isEmpty()) {
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern(pattern);
    }
}

const RoleRow &row(FigureRole role) {
    return table[static_cast<std::size_t>(role)];
}

static_assert([] {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(table[i].role) != i)
            return false;
    }
    return true;
}());

} // namespace

QColor figureColor(FigureRole role, Medium medium) {
    const RoleRow &found = row(role);
    return medium == Medium::screenLight  ? found.light
           : medium == Medium::screenDark ? found.dark
                                          : found.paper;
}

QPen figurePen(FigureRole role, Medium medium) {
    const RoleRow &found = row(role);
    const double width = medium == Medium::paper ? found.width : std::max(found.width, thinnestOnScreen);
    QPen pen(figureColor(role, medium));
    setLine(pen, width, found.dashes);
    if (role == FigureRole::reading || role == FigureRole::downMarker)
        pen.setJoinStyle(Qt::MiterJoin);
    return pen;
}

QPen layerPen(int layer, Medium medium) {
    // In order of feed; the colours repeat after the last one.
    constexpr std::array light{0xff004488U, 0xff2f8f6bU, 0xff7a3e9dU, 0xffb35c00U, 0xffb3261eU, 0xff59626bU};
    constexpr std::array dark{0xff78aef0U, 0xff6bc48bU, 0xffc79ae6U, 0xfff0a040U, 0xfff28e86U, 0xffa4acb3U};
    constexpr std::array<Dashes, 3> patterns{{{}, {{2.4, 0.7}}, {{2.4, 0.7, 0.5, 0.7}}}};
    const auto place = static_cast<std::size_t>(std::max(0, layer));
    constexpr double width = 0.36; // mm
    QPen pen(QColor::fromRgb(medium == Medium::screenDark ? dark[place % dark.size()]
                                                          : light[place % light.size()]));
    setLine(pen, width, patterns[place % patterns.size()]);
    return pen;
}

QColor blend(const QColor &colour, const QColor &ground, double strength) {
    const auto mix = [strength](int above, int below) {
        return qRound(strength * above + (1 - strength) * below);
    };
    return {mix(colour.red(), ground.red()), mix(colour.green(), ground.green()),
            mix(colour.blue(), ground.blue())};
}

QColor bandColor(bool up, bool down, Medium medium) {
    QColor colour = figureColor(FigureRole::background, medium);
    if (!up && !down)
        return blend(figureColor(FigureRole::mean, medium), colour, bandOpacity);
    if (up)
        colour = blend(figureColor(FigureRole::up, medium), colour, bandOpacity);
    if (down)
        colour = blend(figureColor(FigureRole::down, medium), colour, bandOpacity);
    return colour;
}

} // namespace palmer
