// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace palmer::testdata {

/// A PostgreSQL server of the Debian package in a folder of its own, on the loopback address. Ends with it.
class PostgresqlServer {
public:
    /// Starts it; `problem()` says why where that cannot be done.
    PostgresqlServer() {
        const QStringList versions = QDir("/usr/lib/postgresql").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        if (versions.isEmpty()) {
            m_problem = "the package postgresql is not installed";
            return;
        }
        m_programs = "/usr/lib/postgresql/" + versions.last() + "/bin/";
        if (::geteuid() == 0 && !run({"true"})) {
            m_problem = "the server refuses the system administrator, and there is no user postgres";
            return;
        }
        if (::geteuid() == 0) // the server's user has to get there
            QProcess::execute("chown", {"postgres", m_dir.path()});
        m_port = freePort();
        if (!run({m_programs + "initdb", "-D", data(), "-U", "palmer", "-A", "trust", "-E", "UTF8",
                  "--locale=C", "-N"}))
            m_problem = "initdb: " + m_said;
        else if (!start())
            m_problem = "pg_ctl: " + m_said;
        else if (!run({m_programs + "createdb", "-h", "127.0.0.1", "-p", QString::number(m_port), "-U",
                       "palmer", "tests"}))
            m_problem = "createdb: " + m_said;
    }
    ~PostgresqlServer() { stop(); }

    bool start() {
        return run({m_programs + "pg_ctl", "-D", data(), "-w", "-t", QString::number(patience / 1000), "-l",
                    m_dir.filePath("log"), "-o", QString("-h 127.0.0.1 -p %1 -k '' -F").arg(m_port),
                    "start"});
    }
    void stop() {
        if (!m_programs.isEmpty() && QFileInfo::exists(data()))
            run({m_programs + "pg_ctl", "-D", data(), "-w", "-m", "immediate", "stop"});
    }
    [[nodiscard]] QString problem() const { return m_problem; }
    [[nodiscard]] QString address() const {
        return QString("postgresql://palmer@127.0.0.1:%1/tests").arg(m_port);
    }

private:
    static int freePort() {
        const int place = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        ::bind(place, reinterpret_cast<sockaddr *>(&address), size);         // NOLINT: so the system wants it
        ::getsockname(place, reinterpret_cast<sockaddr *>(&address), &size); // NOLINT
        ::close(place);
        return ntohs(address.sin_port);
    }
    [[nodiscard]] QString data() const { return m_dir.filePath("data"); }

    bool run(QStringList command) {
        if (::geteuid() == 0)
            command = QStringList{"runuser", "-u", "postgres", "--"} + command;
        QProcess process;
        process.setWorkingDirectory("/tmp");
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.setStandardOutputFile(QProcess::nullDevice()); // the server keeps it open
        process.start(command.takeFirst(), command);
        const bool ended = process.waitForFinished(patience);
        m_said = QString("exit code %1").arg(process.exitCode());
        return ended && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    }

    QTemporaryDir m_dir;
    QString m_programs;
    QString m_problem;
    QString m_said;
    int m_port = 0;
};

} // namespace palmer::testdata
