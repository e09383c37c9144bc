// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/help.h"
#include "commandline/streams.h"
#include "commandline/terminal.h"
#include "document/jsonformats.h"

#include <QFile>

namespace palmer {

namespace {

int runSchema(const Invocation &invocation) {
    if (invocation.arguments.isEmpty()) {
        std::vector<HelpRow> rows;
        for (const JsonFormat &row : jsonFormats())
            rows.push_back({QString::fromUtf8(row.name),
                            QStringLiteral("%1, %2 · %3")
                                .arg(invocation.language.quoted(row.format), QString::number(row.version),
                                     QString::fromUtf8(row.command))});
        printOut(inColumns(rows, textColumns()));
        return done;
    }
    QStringList names;
    for (const JsonFormat &row : jsonFormats())
        names << QString::fromUtf8(row.name);
    const JsonFormat *row = findJsonFormat(invocation.arguments.front().toStdString());
    if (!row || invocation.arguments.size() > 1)
        throw UsageError({REPORT_TEXT("report", "there is no schema %1; palmer-cli schema lists them"),
                          {invocation.arguments.join(u' ').toStdString()}},
                         invocation.arguments.front(), names);
    QFile file(QStringLiteral(":/schema/") + QString::fromStdString(schemaFile(*row)));
    if (!file.open(QIODevice::ReadOnly))
        throw Error(Error::Kind::unreadable,
                    {REPORT_TEXT("report", "the file cannot be read (%1)"), {file.fileName().toStdString()}});
    printOut(file.readAll());
    return done;
}

} // namespace

Command schemaCommand() {
    return {
        "schema",
        "[NAME]",
        REPORT_TEXT("report", "the JSON Schema of what a command writes as JSON; without NAME what there is"),
        {},
        runSchema};
}

} // namespace palmer
