#include "report/report.h"

namespace palmer {

QString Phrase::plain() const {
    QString result;
    for (const Span &span : spans)
        result += span.text;
    return result;
}

} // namespace palmer
