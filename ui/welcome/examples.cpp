// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/examples.h"

#include "document/savedocument.h"
#include "kernel/measurement/testfacts.h"
#include "ui/windowlanguage.h"

#include <QCoreApplication>
#include <array>

namespace palmer::ui {

namespace {

/// Names of the examples in the list, which is shown before any file is read; titles in the files are data.
struct Row {
    const char *file = nullptr;
    const char *name = nullptr;
    const char *year = nullptr; ///< of the edition
    bool circular = false;
};
constexpr std::array rows{
    Row{"iso230-2-1988-example", QT_TRANSLATE_NOOP("examples", "X axis, published example"), "1988", false},
    Row{"iso230-4-feedback-yz", QT_TRANSLATE_NOOP("examples", "YZ plane, feedback signal"), "2005", true},
    Row{"iso230-4-full-circles-xy", QT_TRANSLATE_NOOP("examples", "XY plane, full circles"), "2005", true},
    Row{"iso230-4-partial-arc-zx", QT_TRANSLATE_NOOP("examples", "ZX plane, partial arc"), "2005", true},
    Row{"long-axis-with-zone", QT_TRANSLATE_NOOP("examples", "Long axis, with its zone"), "2006", false},
    Row{"machine-acceptance-sheet", QT_TRANSLATE_NOOP("examples", "Acceptance sheet"), "2006", false},
    Row{"one-direction", QT_TRANSLATE_NOOP("examples", "Z axis, from one direction"), "2006", false},
    Row{"rotary-axis", QT_TRANSLATE_NOOP("examples", "Rotary table C, 360°"), "2014", false},
    Row{"teaching-01-centre", QT_TRANSLATE_NOOP("examples", "Centre off"), "2005", true},
    Row{"teaching-02-radius", QT_TRANSLATE_NOOP("examples", "Radius, mean scale"), "2005", true},
    Row{"teaching-03-scale-mismatch", QT_TRANSLATE_NOOP("examples", "Scale mismatch"), "2005", true},
    Row{"teaching-04-squareness", QT_TRANSLATE_NOOP("examples", "Squareness"), "2005", true},
    Row{"teaching-05-servo-mismatch", QT_TRANSLATE_NOOP("examples", "Servo mismatch"), "2005", true},
    Row{"teaching-06-backlash", QT_TRANSLATE_NOOP("examples", "Backlash"), "2005", true},
    Row{"teaching-07-lateral-play", QT_TRANSLATE_NOOP("examples", "Lateral play"), "2005", true},
    Row{"teaching-08-straightness", QT_TRANSLATE_NOOP("examples", "Straightness"), "2005", true},
    Row{"teaching-09-periodic-deviation", QT_TRANSLATE_NOOP("examples", "Periodic deviation"), "2005", true},
    Row{"teaching-10-reversal-spike", QT_TRANSLATE_NOOP("examples", "Reversal spike"), "2005", true},
    Row{"teaching-11-common-lag", QT_TRANSLATE_NOOP("examples", "Common lag, three feeds"), "2005", true},
    Row{"teaching-12-drift", QT_TRANSLATE_NOOP("examples", "Drift of the radius"), "2005", true},
    Row{"teaching-13-vibration", QT_TRANSLATE_NOOP("examples", "Vibration in the rest"), "2005", true},
    Row{"thermal-behaviour", QT_TRANSLATE_NOOP("examples", "Thermal behaviour"), "2006", false},
    Row{"x-axis-as-found-as-left", QT_TRANSLATE_NOOP("examples", "As found and as left"), "2006", false},
};

// Content of an example by kind of test.

QString words(const PositioningMeasurement &measurement, const Test &test) {
    const char *counted = QT_TRANSLATE_N_NOOP("examples", "%1 · %2 targets, %n run(s)");
    return QCoreApplication::translate("examples", counted, nullptr,
                                       static_cast<int>(measurement.runs.size()))
        .arg(QString::fromStdString(test.edition))
        .arg(measurement.targets.size());
}

QString words(const CircularMeasurement &measurement, const Test &test) {
    const char *counted = QT_TRANSLATE_N_NOOP("examples", "%1 · %n arc(s), %2 points");
    return QCoreApplication::translate("examples", counted, nullptr,
                                       static_cast<int>(measurement.arcs.size()))
        .arg(QString::fromStdString(test.edition),
             windowLanguage().number(static_cast<double>(readingsOf(test)), Quantity::count, 0));
}

QString words(const Unjudged auto & /*measurement*/, const Test &test) {
    return QString::fromStdString(test.edition);
}

} // namespace

std::vector<Example> examples() {
    std::vector<Example> list;
    list.reserve(rows.size());
    for (const Row &row : rows) {
        list.push_back({QStringLiteral(":/examples/%1.palmer").arg(QLatin1StringView(row.file)),
                        QCoreApplication::translate("examples", row.name), QLatin1StringView(row.year),
                        row.circular,
                        QLatin1StringView(row.file).startsWith(QLatin1StringView("teaching-"))});
    }
    return list;
}

Example typeExample() {
    return {QStringLiteral(":/typetest"),
            QCoreApplication::translate("examples", "Type test, eight machines"), QStringLiteral("2006")};
}

QString exampleDetail(const QString &path) {
    if (path == typeExample().path)
        return QStringLiteral("ISO 230-2:2006");
    const Document document = openDocument(path);
    if (document.tests.empty())
        return {};
    const Test &test = *document.tests.front();
    return std::visit([&](const auto &measurement) { return words(measurement, test); }, test.measurement);
}

bool isExample(const QString &path) {
    return path.startsWith(QLatin1StringView(":/examples/")) || path == typeExample().path;
}

} // namespace palmer::ui
