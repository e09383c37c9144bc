// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/formula.h"

namespace palmer {

QString Formula::plain() const {
    QString result;
    for (const FormulaSpan &span : spans)
        result += span.text;
    return result;
}

Formula &Formula::operator+=(const Formula &other) {
    spans.insert(spans.end(), other.spans.begin(), other.spans.end());
    return *this;
}

Formula formulaFrom(const QString &source) {
    Formula result;
    QString plain;
    const auto flush = [&] {
        if (!plain.isEmpty())
            result.spans.push_back({plain});
        plain.clear();
    };
    for (qsizetype i = 0; i < source.size(); ++i) {
        if (source[i] != u'_') {
            plain += source[i];
            continue;
        }
        flush();
        qsizetype from = i + 1;
        qsizetype end = from;
        if (from < source.size() && source[from] == u'{') {
            end = source.indexOf(u'}', ++from);
            end = end < 0 ? source.size() : end;
            i = end;
        } else {
            while (end < source.size() && source[end].isLetterOrNumber())
                ++end;
            i = end - 1;
        }
        result.spans.push_back({source.mid(from, end - from), true});
    }
    flush();
    return result;
}

QString lowerPart(const Symbol &symbol, const std::string &index) {
    QString result = QString::fromUtf8(symbol.subscript);
    if (!result.isEmpty() && !index.empty())
        result += u',';
    return result + QString::fromStdString(index);
}

Formula symbolFormula(const Symbol &symbol, const std::string &index) {
    Formula result;
    result.spans.push_back({QString::fromUtf8(symbol.base)});
    const QString lower = lowerPart(symbol, index);
    if (!lower.isEmpty())
        result.spans.push_back({lower, true});
    if (*symbol.arrow != 0)
        result.spans.push_back({QString::fromUtf8(symbol.arrow)});
    return result;
}

Formula symbolFormula(const Parameter &parameter) {
    return symbolFormula(parameter.term.symbol, parameter.index);
}

} // namespace palmer
