// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savedocument.h"
#include "ui/model/autosave.h"
#include "ui/model/settings.h"
#include "ui/model/templatestore.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QSettings>
#include <cstdio>
#include <cstdlib>

using namespace palmer;
using namespace palmer::ui;

namespace {

int refuse(const Error &error) {
    std::fputs((windowLanguage().sentence(error.message) + QChar(u'\n')).toUtf8().constData(), stderr);
    return 1;
}

int work(const QString &name, const QString &file) {
    if (name == QLatin1String("settings")) {
        useSafeSettings();
        QSettings settings;
        settings.setValue(QStringLiteral("window/zoom"), 2);
        settings.sync();
        return 0; // what cannot be kept is not worth a box
    }
    if (name == QLatin1String("template")) {
        Template content;
        content.name = "Laboratory";
        storeTemplate(content);
        return 0;
    }
    DocumentModel model;
    model.setDocument(openDocument(file), file);
    model.edit("rename", [](Document &document) { document.machine.name = "Another machine"; });
    if (name == QLatin1String("save")) {
        model.save(file);
        return 0;
    }
    auto *autosave = new Autosave(model); // a program that is killed removes nothing
    std::optional<Error> failure;
    QObject::connect(autosave, &Autosave::failed, [&](const Error &error) { failure = error; });
    const bool kept = autosave->flush();
    QCoreApplication::processEvents();
    std::_Exit(kept ? 0 : failure ? refuse(*failure) : 2);
}

} // namespace

/// What the window writes, step by step without a window: faultywork save|autosave|settings|template FILE
int main(int count, char *arguments[]) {
    const QApplication application(count, arguments);
    QCoreApplication::setOrganizationName(QStringLiteral("palmer-faults"));
    QCoreApplication::setApplicationName(QStringLiteral("palmer-faults"));
    try {
        return work(QString::fromLocal8Bit(arguments[1]), QString::fromLocal8Bit(arguments[2]));
    } catch (const Error &error) {
        return refuse(error);
    }
}
