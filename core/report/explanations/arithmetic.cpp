// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/explanations/arithmetic.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr QChar minus(0x2212);
constexpr QChar times(0xB7);

/// Recursive descent.
class Calculator {
public:
    explicit Calculator(QStringView text)
        : m_rest(text) {}

    Calculation calculate() {
        Calculation result;
        result.isGrouped = true;
        result.value = sum([&](double term, bool isGroup) {
            result.isGrouped = result.isGrouped && isGroup;
            result.terms.push_back(term);
        });
        if (!m_chosen.empty()) {
            result.terms = m_chosen;
            result.isGrouped = true;
        }
        return result;
    }

private:
    bool consume(QStringView sign) {
        m_rest = m_rest.trimmed();
        if (!m_rest.startsWith(sign))
            return false;
        m_rest = m_rest.mid(sign.size());
        return true;
    }
    bool consume(QChar sign) { return consume(QStringView(&sign, 1)); }

    double sum() {
        return sum([](double, bool) {});
    }
    template <class Visit>
    double sum(Visit visit) {
        double result = 0;
        bool negative = false;
        do {
            const bool isGroup = m_rest.trimmed().startsWith(u'(');
            const double term = product();
            visit(term, isGroup && !m_isProduct);
            result += negative ? -term : term;
            negative = consume(minus);
        } while (negative || consume(u'+'));
        return result;
    }
    double product() {
        double result = factor();
        bool isProduct = false;
        for (;; isProduct = true) {
            if (consume(times))
                result *= factor();
            else if (consume(u'/'))
                result /= factor();
            else
                break;
        }
        m_isProduct = isProduct;
        return result;
    }
    double factor() {
        if (consume(u'-') || consume(minus))
            return -factor();
        const bool largest = consume(u"max(");
        if (largest || consume(u"min("))
            return chosen(largest);
        if (consume(u'('))
            return closed(sum(), u')');
        if (consume(u'|'))
            return closed(std::abs(sum()), u'|');
        m_rest = m_rest.trimmed();
        const auto *const end =
            std::ranges::find_if(m_rest, [](QChar c) { return !(c >= u'0' && c <= u'9') && c != u'.'; });
        const QStringView number = m_rest.first(end - m_rest.begin());
        m_rest = m_rest.mid(number.size());
        return number.toDouble();
    }
    double closed(double value, QChar sign) {
        consume(sign);
        return value;
    }
    double chosen(bool largest) {
        std::vector<double> values;
        do
            values.push_back(sum());
        while (consume(u';'));
        m_chosen = values;
        return closed(largest ? std::ranges::max(values) : std::ranges::min(values), u')');
    }

    QStringView m_rest;
    std::vector<double> m_chosen;
    bool m_isProduct = false; ///< the last term is a product
};

} // namespace

Calculation calculated(QStringView text) {
    return Calculator(text).calculate();
}

} // namespace palmer
