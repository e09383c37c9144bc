// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/encoding.h"

#include <QStringDecoder>

namespace palmer {

std::optional<QString> decodedGb18030(std::string_view bytes) {
    QStringDecoder decode("GB18030", QStringConverter::Flag::Stateless); // of ICU
    if (!decode.isValid())
        return std::nullopt;
    QString text = decode(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    if (decode.hasError() && !text.contains(QChar::ReplacementCharacter))
        text += QChar::ReplacementCharacter; // cut off
    return text;
}

} // namespace palmer
