// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/controls.h"

#include <QString>
#include <array>

namespace palmer {

ControlFormats formatsOfControl(std::string_view controller) {
    struct Control {
        const char *word = "";
        ControlFormats formats;
    };
    constexpr std::array rows{
        Control{"sinumerik", {Dialect::siemens, CompensationFormat::siemens}},
        Control{"siemens", {Dialect::siemens, CompensationFormat::siemens}},
        Control{"heidenhain", {Dialect::heidenhain, {}}},
        Control{"tnc", {Dialect::heidenhain, {}}},
        Control{"linuxcnc", {Dialect::linuxcnc, CompensationFormat::linuxcnc}},
        Control{"haas", {Dialect::haas, {}}},
        Control{"weihong", {Dialect::iso, CompensationFormat::weihong}},
        Control{"ncstudio", {Dialect::iso, CompensationFormat::weihong}},
        Control{"fanuc", {Dialect::iso, {}}},
    };
    const QString stated =
        QString::fromUtf8(controller.data(), static_cast<qsizetype>(controller.size())).remove(u' ');
    for (const Control &row : rows) {
        if (stated.contains(QLatin1StringView(row.word), Qt::CaseInsensitive))
            return row.formats;
    }
    return {};
}

} // namespace palmer
