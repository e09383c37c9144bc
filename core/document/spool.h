// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <memory>

class QTemporaryFile;

namespace palmer {

/// A device for long texts that are saved when they are whole: keeps the first MB in memory and writes the
/// rest to a temporary file that nobody else can read and that is gone afterwards. Without a place for that
/// file all stays in memory. Write only, sequential. A write fails if the disk of the file is full.
class Spool : public QIODevice {
public:
    Spool();
    ~Spool() override;
    Spool(const Spool &) = delete;
    Spool &operator=(const Spool &) = delete;

    [[nodiscard]] bool isSequential() const override { return true; }

    /// All that was written, valid while the spool exists and is not written again. Those of the file are
    /// mapped into memory rather than read. Throws Error(unwritable) if the disk was full.
    [[nodiscard]] QByteArray bytes();

protected:
    qint64 readData(char *bytes, qint64 size) override;
    qint64 writeData(const char *bytes, qint64 size) override;

private:
    [[nodiscard]] bool writeToFile(const char *bytes, qint64 size);

    QByteArray m_memory;
    std::unique_ptr<QTemporaryFile> m_file; ///< of all bytes; null: they are in memory
    bool m_noFile = false;                  ///< there is no place for one
};

} // namespace palmer
