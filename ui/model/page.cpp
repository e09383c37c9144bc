// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/page.h"

#include <algorithm>

namespace palmer::ui {

Page pageOf(const Finding &finding, const Document &document) {
    switch (finding.subject) {
    case Subject::readings:
        return Page::readings;
    case Subject::conditions:
        return Page::conditions;
    case Subject::agreedPoints:
        return Page::agreedPoints;
    case Subject::limits:
        return Page::limits;
    case Subject::uncertainty:
        return Page::uncertainty;
    case Subject::machine:
        return Page::machine;
    case Subject::instruments:
        return Page::instruments;
    case Subject::namedInstruments:
        return document.instruments.empty() ? Page::instruments : Page::conditions;
    case Subject::report:
        return Page::identification;
    }
    return Page::readings;
}

QString fieldOf(const Finding &finding) {
    if (finding.keys.empty())
        return QString::fromStdString(finding.id);
    const QString path = QString::fromStdString(finding.keys.front());
    return finding.subject == Subject::agreedPoints ? path : path.section(u'.', -1);
}

int countMissing(const EvaluatedDocument &evaluated, std::size_t test, Page page, Lack lack) {
    return static_cast<int>(
        std::ranges::count_if(evaluated.tests[test]->findings, [&](const Finding &finding) {
            return lackOf(finding) == lack && pageOf(finding, *evaluated.document) == page;
        }));
}

int countMissing(const EvaluatedDocument &evaluated) {
    int missing = 0;
    for (Page page = Page::identification; page <= Page::uncertainty;
         page = static_cast<Page>(static_cast<int>(page) + 1)) {
        int most = 0;
        int sum = 0;
        for (std::size_t test = 0; test < evaluated.tests.size(); ++test) {
            const int here = countMissing(evaluated, test, page);
            most = std::max(most, here);
            sum += here;
        }
        missing += page < Page::readings ? most : sum;
    }
    return missing;
}

} // namespace palmer::ui
