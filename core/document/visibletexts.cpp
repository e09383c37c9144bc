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

} // namespace

std::shared_ptr<const Document> withVisibleTexts(std::shared_ptr<const Document> document,
                                                 const QByteArray &file) {
    // Characters to be shown are escapes in the file.
    if (std::ranges::none_of(std::initializer_list<const char *>{"\\u", "\\t", "\\r", "\\b", "\\f"},
                             [&](const char *escape) { return file.contains(escape); }))
        return document;
    nlohmann::json json = parseJson(std::string_view(file.data(), static_cast<std::size_t>(file.size())));
    showTexts(json);
    return std::make_shared<const Document>(readDocument(QByteArray::fromStdString(compactJson(json))));
}

} // namespace palmer
