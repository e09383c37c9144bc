// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <map>

/// palmer-cli as its users start it. PALMER_CLI is the path of the program.
namespace palmer::testdata {

struct CliResult {
    int code = -1; ///< exit code
    QByteArray out;
    QByteArray err;
};

/// Runs the program without a display, in the locale C unless `environment` says otherwise; ends the test
/// when it crashes or does not end.
inline CliResult runCli(const QStringList &arguments, const QByteArray &input = {},
                        const std::map<QString, QString> &environment = {}) {
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const char *name :
         {"QT_QPA_PLATFORM", "DISPLAY", "XDG_RUNTIME_DIR"}) // it knows itself that it needs none
        all.remove(QString::fromLatin1(name));
    all.insert(QStringLiteral("LC_ALL"), QStringLiteral("C"));
    for (const auto &[name, value] : environment)
        all.insert(name, value);
    QProcess process;
    process.setProcessEnvironment(all);
    process.start(QStringLiteral(PALMER_CLI), arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(patience) || process.exitStatus() != QProcess::NormalExit)
        qFatal("palmer-cli did not end by itself");
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

/// The bytes of a file, or "cannot be read".
inline QByteArray contents(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
}

/// Ends the test where it cannot be written. Makes its folder.
inline void write(const QString &path, const QByteArray &bytes) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

} // namespace palmer::testdata
