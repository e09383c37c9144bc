// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/trendfacts.h"

#include "language/rounding.h"
#include "register/trendoutput.h"
#include "ui/measures.h"
#include "ui/windowlanguage.h"

#include <QGuiApplication>
#include <QScrollArea>

namespace palmer::ui {

namespace {

/// Allows line breaks only after a comma and at a "·", never within a number or before its unit.
QString inPieces(QString text) {
    const QChar joined = QChar::Nbsp;
    return text.replace(u'/', QStringLiteral("/\u2060"))
        .replace(u' ', joined)
        .replace(u',' + QString(joined), QStringLiteral(", "))
        .replace(joined + QStringLiteral("·"), QStringLiteral(" ·"));
}

} // namespace

TrendFacts::TrendFacts() {
    constexpr int factsColumnWidth = 256;
    setFixedWidth(factsColumnWidth);
    m_text->setTextFormat(Qt::RichText);
    m_text->setAlignment(Qt::AlignTop);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setContentsMargins(0, 0, pageMargin - 4, 0);
    auto *area = new QScrollArea; // a low window has no space for the method
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(m_text);
    area->viewport()->setAutoFillBackground(false);
    m_text->setAutoFillBackground(false);
    inColumn(this, {pageMargin, 12, 4, 8}, styleSpacing, {area});
}

void TrendFacts::setTrend(const MachineTrend &trend) {
    if (trend.series.empty()) {
        m_text->clear();
        return;
    }
    const Language &language = windowLanguage();
    const Quantity quantity = trendQuantity(trend);
    QString html;
    if (trend.limit)
        html += QStringLiteral("<p style='margin:0'>%1</p>")
                    .arg(tr("Limit %1")
                             .arg(language.quantity(*trend.limit, quantity,
                                                    limitDecimals(*trend.limit, quantity, language.units())))
                             .toHtmlEscaped());
    html +=
        QStringLiteral(
            "<p style='margin-top:2px;margin-bottom:8px;font-size:large'><b>%1</b></p><table width='100%'>")
            .arg(trendStatement(trend, language).toHtmlEscaped());
    for (const KeyValue &fact : trendFacts(trend, language))
        html += QStringLiteral("<tr><td style='padding:2px 8px 2px 0'>%1</td><td align='right'>%2</td></tr>")
                    .arg(fact.key.toHtmlEscaped(), inPieces(fact.value).toHtmlEscaped());
    html += QStringLiteral("</table>");
    html += QStringLiteral("<p style='color:%1'><small>%2</small></p>")
                .arg(token(Token::secondaryText, QGuiApplication::palette()).name(),
                     trendMethod(trend, language, false).toHtmlEscaped());
    m_text->setText(html);
}

} // namespace palmer::ui
