// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/explanationview.h"

#include "ui/formulatext.h"
#include "ui/theme.h"

#include <QPainter>

namespace palmer::ui {

namespace {

constexpr double stepIndent = 24;
constexpr double gap = 5;

/// A sentence, wrapped at spaces like a formula without subscripts.
Formula sentence(const QString &text) {
    return Formula{{{text}}};
}

} // namespace

ExplanationView::ExplanationView(QWidget *parent)
    : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void ExplanationView::setExplanation(const Explanation &explanation) {
    m_explanation = explanation;
    setAccessibleDescription(plainText());
    updateGeometry();
    update();
}

QString ExplanationView::plainText() const {
    QStringList lines{m_explanation.formula.plain()};
    for (const Formula &step : m_explanation.steps)
        lines << step.plain();
    lines += m_explanation.words;
    return lines.join(u'\n');
}

double ExplanationView::draw(QPainter *painter, double width) const {
    const QColor text = palette().color(QPalette::Text);
    const QColor secondary = token(Token::secondaryText, palette());
    double y = 0;
    const auto line = [&](const Formula &formula, const QFont &font, const QColor &colour, double left,
                          double indent) {
        y += drawFormulaLines(painter, QRectF(left, y, width - left, 0), formula, font, colour, palette(),
                              indent);
    };
    line(m_explanation.formula, themeFont(TextSize::base), secondary, 0, stepIndent);
    y += gap;
    for (const Formula &step : m_explanation.steps) {
        const bool continues = step.plain().startsWith(u'=');
        line(step, themeFont(TextSize::base), text, continues ? stepIndent : 0, stepIndent);
    }
    y += gap;
    for (const QString &words : m_explanation.words)
        line(sentence(words), themeFont(TextSize::small), secondary, 0, 0);
    return y;
}

QSize ExplanationView::sizeHint() const {
    return {320, heightForWidth(320)};
}

int ExplanationView::heightForWidth(int width) const {
    return static_cast<int>(draw(nullptr, width)) + 1;
}

void ExplanationView::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::TextAntialiasing);
    draw(&painter, width());
}

} // namespace palmer::ui
