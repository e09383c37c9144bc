// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/examples.h"

#include "document/savedocument.h"
#include "ui/windowlanguage.h"

#include <QCoreApplication>
#include <QDir>
#include <map>

namespace palmer::ui {

namespace {

// The titles inside the files are data; these are the names in the list.
const char *exampleName(const QString &baseName) {
    static const std::map<QString, const char *> names{
        {QStringLiteral("iso230-2-1988-example"), QT_TRANSLATE_NOOP("examples", "X axis, published example")},
        {QStringLiteral("iso230-4-feedback-yz"), QT_TRANSLATE_NOOP("examples", "YZ plane, feedback signal")},
        {QStringLiteral("iso230-4-full-circles-xy"), QT_TRANSLATE_NOOP("examples", "XY plane, full circles")},
        {QStringLiteral("iso230-4-partial-arc-zx"), QT_TRANSLATE_NOOP("examples", "ZX plane, partial arc")},
        {QStringLiteral("long-axis-with-zone"), QT_TRANSLATE_NOOP("examples", "Long axis, with its zone")},
        {QStringLiteral("one-direction"), QT_TRANSLATE_NOOP("examples", "Z axis, from one direction")},
        {QStringLiteral("rotary-axis"), QT_TRANSLATE_NOOP("examples", "Rotary table C, 360°")},
        {QStringLiteral("teaching-01-centre"), QT_TRANSLATE_NOOP("examples", "Diagnosis: centre off")},
        {QStringLiteral("teaching-02-radius"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: radius, mean scale")},
        {QStringLiteral("teaching-03-scale-mismatch"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: scale mismatch")},
        {QStringLiteral("teaching-04-squareness"), QT_TRANSLATE_NOOP("examples", "Diagnosis: squareness")},
        {QStringLiteral("teaching-05-servo-mismatch"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: servo mismatch")},
        {QStringLiteral("teaching-06-backlash"), QT_TRANSLATE_NOOP("examples", "Diagnosis: backlash")},
        {QStringLiteral("teaching-07-lateral-play"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: lateral play")},
        {QStringLiteral("teaching-08-straightness"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: straightness")},
        {QStringLiteral("teaching-09-periodic-deviation"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: periodic deviation")},
        {QStringLiteral("teaching-10-reversal-spike"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: reversal spike")},
        {QStringLiteral("teaching-11-common-lag"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: common lag, three feeds")},
        {QStringLiteral("teaching-12-drift"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: drift of the radius")},
        {QStringLiteral("teaching-13-vibration"),
         QT_TRANSLATE_NOOP("examples", "Diagnosis: vibration in the rest")},
    };
    const auto found = names.find(baseName);
    return found == names.end() ? nullptr : found->second;
}

QString words(const Test &test) {
    const auto *positioning = std::get_if<PositioningMeasurement>(&test.measurement);
    if (const auto *circular = std::get_if<CircularMeasurement>(&test.measurement)) {
        std::size_t points = 0;
        for (const Arc &arc : circular->arcs)
            points += arc.angles.size();
        const char *counted = QT_TRANSLATE_N_NOOP("examples", "%1 · %n arc(s), %2 points");
        return QCoreApplication::translate("examples", counted, nullptr,
                                           static_cast<int>(circular->arcs.size()))
            .arg(QString::fromStdString(test.edition),
                 windowLanguage().number(static_cast<double>(points), Quantity::count, 0));
    }
    if (!positioning)
        return QString::fromStdString(test.edition);
    return QCoreApplication::translate("examples", "%1 · %2 targets, %3 runs")
        .arg(QString::fromStdString(test.edition))
        .arg(positioning->targets.size())
        .arg(positioning->runs.size());
}

} // namespace

std::vector<Example> examples() {
    static const std::vector<std::pair<QString, Document>> files = [] {
        std::vector<std::pair<QString, Document>> result;
        const QDir folder(QStringLiteral(":/examples"));
        for (const QString &name : folder.entryList({QStringLiteral("*.palmer")}, QDir::Files, QDir::Name))
            result.emplace_back(name, openDocument(folder.filePath(name)));
        return result;
    }();
    std::vector<Example> list;
    for (const auto &[fileName, document] : files) {
        const QString baseName = QString(fileName).remove(QStringLiteral(".palmer"));
        Example example;
        example.path = QStringLiteral(":/examples/") + fileName;
        const char *name = exampleName(baseName);
        example.name = name ? QCoreApplication::translate("examples", name)
                            : QString::fromStdString(document.report.title);
        if (!document.tests.empty()) {
            const Test &test = *document.tests.front();
            example.detail = words(test);
            example.year = QString::fromStdString(test.edition).section(u':', 1, 1);
            example.circular = std::holds_alternative<CircularMeasurement>(test.measurement);
        }
        list.push_back(std::move(example));
    }
    return list;
}

bool isExample(const QString &path) {
    return path.startsWith(QLatin1StringView(":/examples/"));
}

} // namespace palmer::ui
