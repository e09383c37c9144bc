// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/search.h"

#include <algorithm>
#include <tuple>

namespace palmer::ui {

QString folded(const QString &text) {
    QString plain;
    for (const QChar c : text) {
        const QString parts = c.decomposition();
        const QChar base = parts.isEmpty() || c.decompositionTag() != QChar::Canonical ? c : parts.front();
        plain += base == u'\u2019' ? QChar(u'\'') : base.isSpace() ? QChar(u' ') : base.toLower();
    }
    return plain;
}

std::vector<SearchHit> search(const std::vector<SearchEntry> &entries, const QString &typed) {
    const QString wanted = folded(typed).simplified();
    std::vector<SearchHit> hits;
    if (wanted.isEmpty())
        return hits;
    for (const SearchEntry &entry : entries) {
        const qsizetype begin = folded(entry.name).indexOf(wanted);
        if (begin >= 0 || folded(entry.value).contains(wanted) || folded(entry.place).contains(wanted))
            hits.push_back({entry, begin, begin >= 0 ? wanted.size() : 0});
    }
    std::ranges::stable_sort(hits, {}, [](const SearchHit &hit) {
        return std::tuple(hit.entry.group, hit.begin < 0 ? 2 : hit.begin > 0 ? 1 : 0);
    });
    return hits;
}

} // namespace palmer::ui
