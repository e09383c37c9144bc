#include "editing/typednumber.h"

#include <QString>

namespace palmer {

namespace {

constexpr qsizetype longest = 40; ///< characters: more say nothing more in a double

bool isMinus(QChar c) {
    return c == u'-' || c == u'\u2212' || c == u'\u2013';
}

bool isBlank(QChar c) {
    return c == u'\u202F' || c == u'\u00A0' || c == u'\u2009';
}

TypedNumber refused(Text problem) {
    return {{}, problem};
}

} // namespace

TypedNumber typedNumber(QStringView text) {
    const QStringView typed = text.trimmed();
    if (typed.isEmpty() || (typed.size() == 1 && isMinus(typed.front())))
        return {};
    if (typed.size() > longest)
        return refused(REPORT_TEXT("report", "too long for a number"));
    std::string decimal;
    int commas = 0;
    int points = 0;
    bool digits = false;
    for (qsizetype i = 0; i < typed.size(); ++i) {
        const QChar c = typed[i];
        if (c >= u'0' && c <= u'9') {
            decimal += c.toLatin1();
            digits = true;
        } else if (c == u',' || c == u'.') {
            ++(c == u',' ? commas : points);
            decimal += '.';
        } else if (isMinus(c) && i == 0) {
            decimal += '-';
        } else if (c == u'+' && i == 0) {
            continue;
        } else if (isBlank(c) && commas + points == 0 && digits) {
            continue;
        } else {
            return refused(REPORT_TEXT("report", "not a number"));
        }
    }
    if (commas > 0 && points > 0)
        return refused(REPORT_TEXT("report", "comma and point in one number"));
    if (commas > 1)
        return refused(REPORT_TEXT("report", "two commas"));
    if (points > 1)
        return refused(REPORT_TEXT("report", "two points"));
    if (!digits)
        return refused(REPORT_TEXT("report", "not a number"));
    return {std::move(decimal), {}};
}

} // namespace palmer
