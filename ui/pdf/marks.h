#pragma once

#include "kernel/evaluation/parameter.h"

#include <QPointF>
#include <QRectF>

class QPainter;

namespace palmer::ui {

/// Signs that the font lacks, drawn as paths; they differ in form, so black and white is enough.
enum class Mark {
    check,  ///< conforms, agreed
    cross,  ///< does not conform, not agreed, requirement
    circle, ///< not proven, recommendation, note
};

constexpr double markBox = 2.5; ///< width and height of a mark, mm

[[nodiscard]] Mark markOf(Verdict verdict);

/// Draws a mark into the square of `side` points around `centre`.
void drawMark(QPainter &painter, Mark mark, QPointF centre, double side);

/// The value between 0 and its limit as a picture, all in the same unit: a line from 0, the limit as a tick at
/// 60 % of the width, the band limit ± guard, the value as a diamond. What lies outside is put on the end.
/// Without a guard band only line, tick and value.
struct GuardPicture {
    double value = 0;
    double limit = 1; ///< > 0
    double guard = 0;
};

constexpr double guardPictureWidth = 16;  ///< mm
constexpr double guardPictureHeight = 3.1; ///< mm

void drawGuardPicture(QPainter &painter, QPointF topLeft, const GuardPicture &picture);

/// The signs of a guard picture one by one, for its legend; around `centre`. Widths in mm.
enum class GuardSign { value, limit, band };
[[nodiscard]] double guardSignWidth(GuardSign sign);
void drawGuardSign(QPainter &painter, GuardSign sign, QPointF centre);

} // namespace palmer::ui
