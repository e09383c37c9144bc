// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testname.h"

#include "kernel/measurement/testfacts.h"

#include <QCoreApplication>

namespace palmer::ui {

QString testName(const Test &test) {
    if (!test.title.empty())
        return QString::fromStdString(test.title);
    const QString name = QString::fromStdString(axesOf(test));
    const auto named = [&](const char *with, const char *without) {
        const QString text =
            QCoreApplication::translate("palmer::ui::testName", name.isEmpty() ? without : with);
        return name.isEmpty() ? text : text.arg(name);
    };
    switch (kindOf(test)) {
    case Kind::positioning:
        return named(QT_TRANSLATE_NOOP("palmer::ui::testName", "%1 axis"),
                     QT_TRANSLATE_NOOP("palmer::ui::testName", "Axis without name"));
    case Kind::circular:
        return named(QT_TRANSLATE_NOOP("palmer::ui::testName", "%1 circle"),
                     QT_TRANSLATE_NOOP("palmer::ui::testName", "Circle"));
    case Kind::drift:
        return named(QT_TRANSLATE_NOOP("palmer::ui::testName", "%1 drift"),
                     QT_TRANSLATE_NOOP("palmer::ui::testName", "Drift"));
    }
    return name;
}

} // namespace palmer::ui
