#pragma once

#include <QByteArray>
#include <QString>

namespace palmer {

/// Writes to the file of that name, "-" is standard output. Throws Error(unwritable).
void writeOutput(const QByteArray &bytes, const QString &file);

} // namespace palmer
