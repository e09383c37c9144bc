// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/visibletexts.h"

#include "document/json.h"
#include "document/readdocument.h"
#include "language/visibletext.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace palmer {

namespace {

void showTexts(nlohmann::json &value) {
    if (const auto *text = value.get_ptr<const std::string *>())
        value = visibleText(QString::fromStdString(*text)).toStdString();
    else if (value.is_structured())
        std::ranges::for_each(value, showTexts);
}

/// True if a file written by Palmer has a character to be shown. Such characters are escaped in the file; the
/// only other escapes are quotation marks, backslashes and line ends.
bool hasEscapedCharacter(const QByteArray &file) {
    for (qsizetype at = file.indexOf('\\'); at >= 0; at = file.indexOf('\\', at + 2)) {
        if (QByteArrayView("utrbf").contains(file.at(at + 1)))
            return true;
    }
    return false;
}

} // namespace

std::shared_ptr<const Document> withVisibleTexts(std::shared_ptr<const Document> document,
                                                 const QByteArray &file) {
    if (!hasEscapedCharacter(file))
        return document;
    nlohmann::json json = parseJson(std::string_view(file.data(), static_cast<std::size_t>(file.size())));
    showTexts(json);
    return std::make_shared<const Document>(readDocument(QByteArray::fromStdString(compactJson(json))));
}

} // namespace palmer
