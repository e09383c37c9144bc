// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/formats.h"

#include "import/readers.h"

namespace palmer {

std::span<const ImportFormat *const> importFormats() {
    return formatsInOrder;
}

QStringList importEndings() {
    QStringList endings;
    for (const ImportFormat *format : formatsInOrder)
        endings << QString::fromLatin1(format->endings).split(u' ', Qt::SkipEmptyParts);
    endings.removeDuplicates();
    return endings;
}

QString importPatterns() {
    return QStringLiteral("*.") + importEndings().join(QStringLiteral(" *."));
}

} // namespace palmer
