// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace palmer {

/// For programs of the command line, before anything else: bytes pass through the standard streams unchanged.
/// Where the caller closed one, streams that fail on every access take its place: the next opened file would
/// get its number and be read or written as that stream.
void prepareStreams();

/// Columns of the terminal on standard output; null if it is none.
[[nodiscard]] std::optional<int> columnsOfTerminal();

/// True if a person reads standard error as it is written, on a terminal that can clear a line.
[[nodiscard]] bool errorsGoToTerminal();

/// Discards standard error during its lifetime.
class QuietErrors {
public:
    QuietErrors();
    ~QuietErrors();
    QuietErrors(const QuietErrors &) = delete;
    QuietErrors &operator=(const QuietErrors &) = delete;

private:
    int m_before;
};

/// Descriptor of standard input.
constexpr int standardInput = 0;

/// A pipe opened for reading.
struct OpenPipe {
    std::optional<int> descriptor; ///< null if nobody wrote to it within two seconds
    QByteArray begin;              ///< what was read of it
};

/// Null for anything but a pipe with a name.
[[nodiscard]] std::optional<OpenPipe> openPipe(const QString &file);

} // namespace palmer
