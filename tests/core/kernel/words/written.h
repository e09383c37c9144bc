// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"

#include <QByteArrayList>

#include <array>

/// Messages as tests compare them.
namespace palmer::testdata {

/// "6; 1201 mm; 0.048 µm.2": base units, named as they are shown, with the decimals they are shown with.
inline QByteArray written(const Message &message) {
    constexpr std::array units{"", "n", " mm", "°", " mm→µm", "°→″", " µm", "″", " °C", " °C/h", " α"};
    QByteArrayList words;
    for (const Argument &argument : message.arguments) {
        if (const auto *number = std::get_if<Number>(&argument)) {
            const auto unit = static_cast<std::size_t>(number->quantity);
            QByteArray word = QByteArray::number(number->value, 'g', 6);
            word += unit < units.size() ? units[unit] : " feed";
            words << (number->decimals < 0 ? word : word + '.' + QByteArray::number(number->decimals));
        } else if (const auto *text = std::get_if<Text>(&argument)) {
            words << text->source;
        } else if (const auto *standard = std::get_if<Designation>(&argument)) {
            words << QByteArray::fromStdString(standard->word);
        } else {
            words << QByteArray::fromStdString(std::get<std::string>(argument));
        }
    }
    if (message.count)
        words << '#' + QByteArray::number(*message.count);
    return words.join("; ");
}

} // namespace palmer::testdata
