// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/zoombuttons.h"

#include "ui/madewidgets.h"
#include "ui/theme.h"

#include <QToolButton>

namespace palmer::ui {

ZoomButtons::ZoomButtons(QWidget *parent)
    : Translated(parent)
    , m_out(iconButton(this, QStringLiteral("zoomOut"), QStringLiteral("zoomout")))
    , m_in(iconButton(this, QStringLiteral("zoomIn"), QStringLiteral("zoomin")))
    , m_fit(iconButton(this, QStringLiteral("fitFigure"), QStringLiteral("fit"))) {
    inRow(this, noMargins, 2, {m_out, m_in, m_fit});
    connect(m_out, &QToolButton::clicked, this, [this] { emit zoomWanted(-1); });
    connect(m_in, &QToolButton::clicked, this, [this] { emit zoomWanted(1); });
    connect(m_fit, &QToolButton::clicked, this, &ZoomButtons::fitWanted);
    retranslate();
}

void ZoomButtons::retranslate() {
    nameWidget(*m_out, tr("Zoom out"), QStringLiteral("−"));
    nameWidget(*m_in, tr("Zoom in"), QStringLiteral("+"));
    nameWidget(*m_fit, tr("Show the whole figure"), QStringLiteral("0"));
}

} // namespace palmer::ui
