// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testname.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

/// Name of the axis or axes; empty where none is stated.
std::string axes(const Test &test) {
    if (const auto *positioning = std::get_if<PositioningMeasurement>(&test.measurement))
        return positioning->axis.name;
    if (const auto *circular = std::get_if<CircularMeasurement>(&test.measurement))
        return circular->plane.first + circular->plane.second;
    return std::get<DriftMeasurement>(test.measurement).axis.name;
}

} // namespace

QString testName(const Test &test) {
    if (!test.title.empty())
        return QString::fromStdString(test.title);
    const QString name = QString::fromStdString(axes(test));
    if (name.isEmpty())
        return QString::fromStdString(test.id);
    if (std::holds_alternative<CircularMeasurement>(test.measurement))
        return QCoreApplication::translate("palmer::ui::testName", "%1 circle").arg(name);
    return QCoreApplication::translate("palmer::ui::testName", "%1 axis").arg(name);
}

} // namespace palmer::ui
