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
    if (name.isEmpty())
        return QString::fromStdString(test.id);
    switch (kindOf(test)) {
    case Kind::positioning:
        return QCoreApplication::translate("palmer::ui::testName", "%1 axis").arg(name);
    case Kind::circular:
        return QCoreApplication::translate("palmer::ui::testName", "%1 circle").arg(name);
    case Kind::drift:
        return QCoreApplication::translate("palmer::ui::testName", "%1 drift").arg(name);
    }
    return name;
}

} // namespace palmer::ui
